/* SPDX-License-Identifier: MIT */
/*
 * Firmware that counts the instructions of each picture of the gallery, drawn by itself in RGB565: clear and copy to a
 * framebuffer in memory included, labels left out. It writes a line for each,
 *     teapot,vertex,320x160,INSTRUCTIONS
 */
#include "../../examples/scenes/scenes.h"
#include "../bench/framebuffer.h"
#include "../bench/measure.h"

/** The largest screen. */
enum { WIDTH = 320, HEIGHT = 240 };

/** The frame that `glint scene` draws. */
enum { FRAME = 0 };

static uint32_t arena[(1 << 20) / sizeof(uint32_t)];
static uint16_t framebuffer[HEIGHT][WIDTH];
static example_stage stage;

static int copy_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context;
    framebuffer_copy(&framebuffer[y][x], sizeof framebuffer[0], pixels, stride, 2 * (size_t)width, height);
    return 0;
}

static void write_heading(const example_scene *scene, uint32_t variant) {
    board_write(scene->name);
    board_write(",");
    board_write(scene->variants[variant].name);
    board_write(",");
    write_number(scene->width, "x");
    write_number(scene->height, ",");
}

/* @return 0, or 1 when it cannot be drawn */
static int count(const example_scene *scene, uint32_t variant) {
    glint_config config = {.width = scene->width,
                           .height = scene->height,
                           .format = &glint_format_rgb565,
                           .flush = {copy_tile, 0, 0},
                           .arena = arena,
                           .arena_size = sizeof arena};
    measured result = {0};
    glint_renderer renderer;

    write_heading(scene, variant);
    scene->build(&stage, variant, FRAME);
    config.layers = stage.layers;
    config.samples = stage.samples;
    const glint_status status = measure_frame(&config, &stage.scene, 1, &renderer, &result);
    if (status != GLINT_OK) {
        board_write(glint_strerror(status));
        board_write("\n");
        return 1;
    }
    write_number((uint32_t)(result.ticks * COUNTER_INSTRUCTIONS_PER_TICK), "\n");
    return 0;
}

int main(void) {
    int failed = 0;

    counter_start();
    for (uint32_t i = 0; i < EXAMPLE_SCENES; i++) {
        for (uint32_t variant = 0; variant < example_scenes[i]->variant_count && !failed; variant++) {
            failed = count(example_scenes[i], variant);
        }
    }
    return failed;
}
