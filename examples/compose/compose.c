/* SPDX-License-Identifier: MIT */
#include "compose.h"

#include "glint_extras.h"
#include "meshes/box.h"
#include "meshes/torus576.h"
#include "paint.h"

#define RGB565(r, g, b) ((uint32_t)(r) << 11 | (uint32_t)(g) << 5 | (uint32_t)(b))

/* The model's view takes the left of the screen, the clock a square at the right. */
#define VIEW_WIDTH 224
#define CLOCK_SIZE 96
#define CLOCK_TOP 24

static const glint_colour white = GLINT_COLOUR(1, 1, 1);

/* ---- The model's view ---- */

/* What its painters show. */
typedef struct view {
    int label_x, label_y; /* below the label's middle */
    int cursor_x, cursor_y;
    char number[6]; /* of the triangle there */
} view;

/* The picture: a sky that gets lighter downwards, and a table. */
static int paint_picture(void *context, const glint_tile *tile) {
    (void)context;
    for (int y = tile->y; y < tile->y + tile->height; y++) {
        const uint32_t colour = y < 170 ? RGB565(2 + y / 16, 8 + y / 6, 12 + y / 12) : RGB565(9, 12 + y / 40, 4);

        paint_rectangle(tile, tile->x, y, tile->width, 1, colour);
    }
    return 0;
}

/* The label on its pole, the cursor, and what that is on. */
static int paint_labels(void *context, const glint_tile *tile) {
    const view *const v = context;

    paint_rectangle(tile, v->label_x, v->label_y - 18, 1, 18, RGB565(31, 63, 31));
    paint_rectangle(tile, v->label_x - 23, v->label_y - 32, 47, 15, RGB565(31, 63, 31));
    paint_text(tile, v->label_x - 20, v->label_y - 29, 2, RGB565(0, 0, 0), "TORUS");
    paint_rectangle(tile, v->cursor_x - 6, v->cursor_y, 13, 1, RGB565(31, 63, 0));
    paint_rectangle(tile, v->cursor_x, v->cursor_y - 6, 1, 13, RGB565(31, 63, 0));
    paint_text(tile, 6, 222, 2, RGB565(31, 63, 31), "TRIANGLE");
    paint_text(tile, 78, 222, 2, RGB565(31, 63, 0), v->number);
    return 0;
}

static void write_number(char to[6], uint32_t number) {
    char digits[6];
    int count = 0;

    do {
        digits[count++] = (char)('0' + number % 10);
        number /= 10;
    } while (number && count < 5);
    for (int i = 0; i < count; i++)
        to[i] = digits[count - 1 - i];
    to[count] = '\0';
}

static glint_status draw_model(glint_config config, int number) {
    static const glint_material copper = {&glint_model_blinn_phong, GLINT_COLOUR(0.08, 0.04, 0.02),
                                          GLINT_COLOUR(0.6, 0.28, 0.12), GLINT_COLOUR(0.6, 0.4, 0.3), GLINT_Q16(40)};
    static const glint_light lamp = {.type = &glint_light_directional,
                                     .direction = GLINT_VECTOR(-0.5, -0.8, -0.7),
                                     .diffuse = GLINT_COLOUR(1, 1, 1),
                                     .specular = GLINT_COLOUR(1, 1, 1)};
    const glint_pose tilt = glint_pose_rotate_x(GLINT_Q16(-50)), turn = glint_pose_rotate_y(number * GLINT_Q16(6));
    const glint_object torus = {.mesh = &torus576_mesh,
                                .material = &copper,
                                .evaluation = &glint_per_fragment,
                                .pose = glint_pose_then(&tilt, &turn)};
    glint_scene scene = {.ambient = white, .lights = &lamp, .light_count = 1, .objects = &torus, .object_count = 1};
    glint_renderer renderer;
    glint_screen_point place;
    glint_hit hit;
    view v = {.cursor_x = VIEW_WIDTH / 2 + 32, .cursor_y = 150, .number = "NONE"};

    scene.viewer = GLINT_VIEWER_LOCAL;
    scene.camera = (glint_camera){.field_of_view = GLINT_Q16(45), .near_plane = GLINT_Q16(0.1)};
    glint_camera_orbit(&scene.camera, (glint_vector){0, 0, 0}, 0, GLINT_Q16(15), GLINT_Q16(4.4));
    config.width = VIEW_WIDTH;
    config.background = (glint_painter){paint_picture, &v};
    config.overlay = (glint_painter){paint_labels, &v};
    const glint_vector top = glint_pose_apply(&torus.pose, (glint_vector){0, GLINT_Q16(1.4), 0});
    if (glint_camera_project(&config, &scene.camera, top, &place) > 0) {
        v.label_x = place.x >> 16;
        v.label_y = place.y >> 16;
    }
    glint_status status = glint_init(&renderer, &config);
    if (status != GLINT_OK)
        return status;
    const int picked = glint_pick(&renderer, &scene, v.cursor_x, v.cursor_y, &hit);
    if (picked < 0)
        return (glint_status)picked;
    if (picked)
        write_number(v.number, hit.triangle);
    return glint_render(&renderer, &scene);
}

/* ---- The clock ---- */

static int paint_dial(void *context, const glint_tile *tile) {
    (void)context;
    paint_rectangle(tile, 0, 0, COMPOSE_WIDTH, COMPOSE_HEIGHT, RGB565(4, 8, 6));
    for (int hour = 0; hour < 12; hour++) {
        const glint_q16 angle = hour * GLINT_Q16(30);
        const int x = CLOCK_SIZE / 2 + (43 * glint_sin(angle) + GLINT_ONE / 2) / GLINT_ONE;
        const int y = CLOCK_TOP + CLOCK_SIZE / 2 - (43 * glint_cos(angle) + GLINT_ONE / 2) / GLINT_ONE;

        paint_rectangle(tile, x - 1, y - 1, hour % 3 ? 2 : 4, hour % 3 ? 2 : 4, RGB565(28, 56, 28));
    }
    paint_text(tile, 24, 140, 2, RGB565(31, 63, 31), "CLOCK");
    return 0;
}

/* A hand that points upwards, so long and thick, turned clockwise. */
static glint_pose turn_hand(glint_q16 length, glint_q16 width, glint_q16 angle, glint_q16 height) {
    const glint_pose shape = glint_pose_scale(width, length, width), up = glint_pose_translate(0, length, height),
                     turn = glint_pose_rotate_z(-angle);
    const glint_pose stands = glint_pose_then(&shape, &up);

    return glint_pose_then(&stands, &turn);
}

/* The strip at the right, once; then only the region that the hands cover. */
static glint_status draw_clock(glint_config config, int number) {
    static const glint_material steel = {&glint_model_blinn_phong, GLINT_COLOUR(0.1, 0.1, 0.12),
                                         GLINT_COLOUR(0.5, 0.5, 0.55), GLINT_COLOUR(0.5, 0.5, 0.5), GLINT_Q16(20)};
    static const glint_light lamp = {.type = &glint_light_directional,
                                     .direction = GLINT_VECTOR(0.6, -0.5, -0.7),
                                     .diffuse = GLINT_COLOUR(1, 1, 1),
                                     .specular = GLINT_COLOUR(1, 1, 1)};
    const glint_object hands[2] = {
        {.mesh = &box_mesh,
         .material = &steel,
         .evaluation = &glint_per_fragment,
         .pose = turn_hand(GLINT_Q16(0.24), GLINT_Q16(0.06), number * GLINT_Q16(30), 0)},
        {.mesh = &box_mesh,
         .material = &steel,
         .evaluation = &glint_per_fragment,
         .pose = turn_hand(GLINT_Q16(0.33), GLINT_Q16(0.04), number * GLINT_Q16(6), GLINT_Q16(0.12))}};
    glint_scene scene = {.ambient = white, .lights = &lamp, .light_count = 1, .objects = hands, .object_count = 2};
    glint_renderer renderer;

    scene.camera = (glint_camera){.pose = glint_pose_translate(0, GLINT_Q16(-1.26), GLINT_Q16(6)),
                                  .field_of_view = GLINT_Q16(45),
                                  .near_plane = GLINT_Q16(0.1)};
    config.width = COMPOSE_WIDTH - VIEW_WIDTH;
    config.left = VIEW_WIDTH;
    config.background = (glint_painter){paint_dial, 0};
    if (number)
        config.region = (glint_rectangle){0, CLOCK_TOP, CLOCK_SIZE, CLOCK_SIZE};
    const glint_status status = glint_init(&renderer, &config);
    return status == GLINT_OK ? glint_render(&renderer, &scene) : status;
}

glint_status compose_draw(glint_flush flush, void *arena, size_t arena_size, int number) {
    const glint_config config = {.height = COMPOSE_HEIGHT,
                                 .format = &glint_format_rgb565_be,
                                 .flush = flush,
                                 .arena = arena,
                                 .arena_size = arena_size};
    const glint_status status = draw_model(config, number);

    return status == GLINT_OK ? draw_clock(config, number) : status;
}
