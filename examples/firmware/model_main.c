/* SPDX-License-Identifier: MIT */
/*
 * Firmware for any board: a model of one's own turns on whatever the board shows pictures on. `make run BOARD=pico
 * MODEL=my.obj` makes a header of it (glint convert --name model --centre --scale fit), and builds this.
 */
#include "board.h"
#include "glint_extras.h"

#ifdef MODEL_HEADER
/* cppcheck-suppress preprocessorErrorDirective; the makefile says which */
#include MODEL_HEADER
#else
#include "meshes/torus576.h"
#define model_mesh torus576_mesh
#endif

/** Degrees of the first frame, which shows a box from three sides, and from one frame to the next. */
#define FIRST 330
#define STEP 10

#define GREY(level) GLINT_COLOUR(level, level, level)

#ifndef MODEL_HAS_MATERIALS
static const glint_material clay = {&glint_model_blinn_phong, GREY(0.1), GREY(0.6), GREY(0.4), GLINT_Q16(32)};
static const glint_object model_objects[] = {
    {&model_mesh, &clay, {{{GLINT_ONE, 0, 0, 0}, {0, GLINT_ONE, 0, 0}, {0, 0, GLINT_ONE, 0}}}, &glint_per_fragment}};
#endif
#ifdef MODEL_BLENDS
static const glint_layer_stage *const layers = &glint_layers;
#else
static const glint_layer_stage *const layers = 0;
#endif
enum { OBJECTS = sizeof model_objects / sizeof *model_objects };

/* BOARD_ARENA, bytes, is what the board can spare, BOARD_TILE_WIDTH and BOARD_TILE_HEIGHT are its tiles'
 * (port/boards.mk). What does not fit costs more passes. */
static uint32_t arena[BOARD_ARENA / sizeof(uint32_t)];

/* Returns the square root, rounded down. */
static glint_q16 square_root(uint64_t square) {
    uint32_t root = 0;

    for (uint32_t bit = 1u << 31; bit > 0; bit >>= 1) {
        if ((uint64_t)(root | bit) * (root | bit) <= square) {
            root |= bit;
        }
    }
    return (glint_q16)root;
}

/*
 * Returns how far behind the origin a camera stands, a quarter as high, that looks there by 45 degrees and sees the
 * model however it is turned. All objects of a model have the same extent. Coordinates are below 4 (--scale fit).
 */
static glint_q16 find_distance(const board_display *display) {
    const glint_vector half = model_objects[0].mesh->extent;
    const uint64_t x = (uint32_t)half.x, z = (uint32_t)half.z;
    const glint_q16 radius = square_root(x * x + z * z); /* of the cylinder that it turns in */
    const glint_q16 across = radius / display->width * display->height, up = half.y + radius / 4;

    return (across > up ? across : up) / 5 * 12 + radius; /* 12 / 5 is 1 / tan(22.5 degrees), less 0.6 % */
}

int main(void) {
    const glint_vector up = GLINT_VECTOR(0, 1, 0), origin = GLINT_VECTOR(0, 0, 0);
    /* from the upper left, and weaker from the right, so that no side that is seen is black */
    const glint_light lights[] = {
        {&glint_light_directional, {0}, GLINT_VECTOR(0.5, -0.7, -0.7), GREY(1), GREY(1)},
        {&glint_light_directional, {0}, GLINT_VECTOR(-0.8, -0.1, -0.6), GREY(0.25), GREY(0.25)}};
    glint_object objects[OBJECTS];
    glint_scene scene = {.camera = glint_camera_default(),
                         .ambient = GREY(1),
                         .lights = lights,
                         .light_count = 2,
                         .objects = objects,
                         .object_count = OBJECTS};
    glint_renderer renderer;
    board_display display;

    if (board_display_start(&display)) {
        board_write("the display does not answer\n");
        return 1;
    }
    const glint_config config = {.width = display.width,
                                 .height = display.height,
                                 .tile_width = BOARD_TILE_WIDTH,
                                 .tile_height = BOARD_TILE_HEIGHT,
                                 .format = display.format,
                                 .flush = display.flush,
                                 .arena = arena,
                                 .arena_size = sizeof arena,
                                 .keeps_arena = 1,
                                 .layers = layers};
    const glint_q16 distance = find_distance(&display);
    glint_status status = glint_init(&renderer, &config);
    glint_camera_look_at(&scene.camera, (glint_vector){0, distance / 4, distance}, origin, up);
    for (glint_q16 degrees = FIRST; status == GLINT_OK; degrees = (degrees + STEP) % 360) {
        for (int i = 0; i < OBJECTS; i++) {
            objects[i] = model_objects[i];
            objects[i].pose = glint_pose_rotate_y(degrees * GLINT_ONE);
        }
        status = glint_render(&renderer, &scene);
    }
    board_write(glint_strerror(status));
    board_write("\n");
    return 1;
}
