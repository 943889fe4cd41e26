/* SPDX-License-Identifier: MIT */
/*
 * Firmware that counts what a visible fragment of a large triangle takes, its depth test and its share of its row
 * included: two frames of one triangle, half as large in one, by their difference in pixels. It writes a line for
 * each lighting and viewer,
 *     fragment,interpolated,infinite viewer,INSTRUCTIONS,fragment,0
 * instructions in hundredths.
 */
#include "board.h"
#include "counter.h"
#include "glint.h"
#include "text.h"

/** The tile in the middle of a screen so large that no triangle in it is large for that. */
enum { TILE = 64, SIZE = 15 * TILE, REPEATS = 16 };

typedef struct lighting {
    const char *name;
    int16_t lean;            /* of the corners' normals from the middle's, in units of its length: 2^10 */
    uint8_t matt, highlight; /* kernels that draw it */
} lighting;

static const lighting lightings[] = {
    {"plane", 20, GLINT_KERNEL_DIFFUSE, GLINT_KERNEL_SPECULAR},
    {"interpolated", 200, GLINT_KERNEL_CURVED_DIFFUSE, GLINT_KERNEL_CURVED_SPECULAR},
    {"exact", 600, GLINT_KERNEL_CURVED_DIFFUSE, GLINT_KERNEL_CURVED_SPECULAR},
};

typedef struct variant {
    const char *name;
    glint_viewer viewer;
    glint_q16 diffuse, specular;
} variant;

static const variant variants[] = {
    {"no highlight", GLINT_VIEWER_INFINITE, GLINT_Q16(0.5), 0},
    {"infinite viewer", GLINT_VIEWER_INFINITE, GLINT_Q16(0.5), GLINT_Q16(0.35)},
    {"infinite viewer clamped", GLINT_VIEWER_INFINITE, GLINT_Q16(0.8), GLINT_Q16(0.4)},
    {"local viewer", GLINT_VIEWER_LOCAL, GLINT_Q16(0.5), GLINT_Q16(0.35)},
    {"local viewer clamped", GLINT_VIEWER_LOCAL, GLINT_Q16(0.8), GLINT_Q16(0.4)},
};

static const int16_t positions[3][3] = {{-32767, -32767, 0}, {32767, -32767, 0}, {-32767, 32767, 0}};
static const uint16_t triangles[1][3] = {{0, 1, 2}};
static const glint_light light = {.type = &glint_light_directional,
                                  .vector = {GLINT_Q16(0.2), GLINT_Q16(0.1), GLINT_ONE},
                                  .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE},
                                  .specular = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};

static uint32_t arena[(1 << 16) / sizeof(uint32_t)];
static uint32_t pixels;

static int count_pixels(void *context, int x, int y, int width, int height, const void *tile, size_t stride) {
    (void)context, (void)x, (void)y;
    for (int row = 0; row < height; row++) {
        const uint16_t *line = (const uint16_t *)(const void *)((const uint8_t *)tile + (size_t)row * stride);
        for (int column = 0; column < width; column++)
            pixels += line[column] != 0;
    }
    return 0;
}

static int ignore_tile(void *context, int x, int y, int width, int height, const void *tile, size_t stride) {
    (void)context, (void)x, (void)y, (void)width, (void)height, (void)tile, (void)stride;
    return 0;
}

static glint_status draw(const glint_scene *scene, glint_renderer *renderer, int counts) {
    const glint_config config = {.width = SIZE,
                                 .height = SIZE,
                                 .tile_width = TILE,
                                 .tile_height = TILE,
                                 .format = &glint_format_rgb565,
                                 .flush = {.begin = counts ? count_pixels : ignore_tile},
                                 .arena = arena,
                                 .arena_size = sizeof arena,
                                 .counts_drawn = (uint8_t)counts};
    const glint_status status = glint_init(renderer, &config);
    return status == GLINT_OK ? glint_render(renderer, scene) : status;
}

/* Ticks of REPEATS frames. @return 0 unless `kernel` draws all of it */
static uint32_t measure(const glint_scene *scene, uint8_t kernel) {
    glint_renderer renderer;
    pixels = 0;
    if (draw(scene, &renderer, 1) != GLINT_OK || renderer.stats.drawn[kernel].covered != pixels) {
        return 0;
    }
    const uint32_t start = counter_now();
    for (int i = 0; i < REPEATS; i++) {
        draw(scene, &renderer, 0);
    }
    return counter_ticks_since(start);
}

static void write_number(uint32_t number, const char *end) {
    char digits[TEXT_NUMBER_SIZE];

    board_write(text_number(digits, number));
    board_write(end);
}

/* Hundredths of instructions a fragment; 0 when it is not drawn as it should be. */
static uint32_t measure_variant(const lighting *l, const variant *v) {
    const int16_t lean = (int16_t)(l->lean * 16);
    const int16_t normals[3][3] = {{(int16_t)-lean, (int16_t)-lean, 16384}, {lean, 0, 16384}, {0, lean, 16384}};
    const glint_mesh mesh = {.positions = positions,
                             .normals = normals,
                             .triangles = triangles,
                             .vertex_count = 3,
                             .triangle_count = 1,
                             .extent = {GLINT_Q16(0.49), GLINT_Q16(0.49), GLINT_Q16(0.49)}};
    const glint_material material = {.model = &glint_model_blinn_phong,
                                     .ambient = {GLINT_Q16(0.1), GLINT_Q16(0.1), GLINT_Q16(0.1)},
                                     .diffuse = {v->diffuse, v->diffuse, v->diffuse},
                                     .specular = {v->specular, v->specular, v->specular},
                                     .shininess = 4 * GLINT_ONE};
    glint_object object = {.mesh = &mesh, .material = &material};
    const glint_scene scene = {.viewer = v->viewer,
                               .ambient = {GLINT_ONE, GLINT_ONE, GLINT_ONE},
                               .lights = &light,
                               .light_count = 1,
                               .objects = &object,
                               .object_count = 1,
                               .camera = {glint_pose_identity(), GLINT_Q16(105.4), GLINT_Q16(0.1)}};
    const uint8_t kernel = v->specular ? l->highlight : l->matt;

    object.pose = glint_pose_translate(0, 0, -6 * GLINT_ONE);
    const uint32_t large = measure(&scene, kernel), large_pixels = pixels;
    const glint_pose half = glint_pose_scale(GLINT_ONE / 2, GLINT_ONE / 2, GLINT_ONE / 2);
    object.pose = glint_pose_then(&half, &object.pose);
    const uint32_t small = measure(&scene, kernel), small_pixels = pixels;
    if (!large || !small) {
        return 0;
    }
    return (large - small) * (100 / 4 * COUNTER_INSTRUCTIONS_PER_TICK) / ((large_pixels - small_pixels) * REPEATS / 4);
}

int main(void) {
    counter_start();
    for (uint32_t i = 0; i < sizeof lightings / sizeof lightings[0]; i++) {
        for (uint32_t j = 0; j < sizeof variants / sizeof variants[0]; j++) {
            const uint32_t hundredths = measure_variant(&lightings[i], &variants[j]);
            board_write("fragment,");
            board_write(lightings[i].name);
            board_write(",");
            board_write(variants[j].name);
            board_write(",");
            write_number(hundredths, ",fragment,0\n");
            if (!hundredths) {
                return 1;
            }
        }
    }
    return 0;
}
