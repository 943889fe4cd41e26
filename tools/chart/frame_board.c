/* SPDX-License-Identifier: MIT */
/*
 * Firmware that counts the instructions of frames for every way to light, clear and copy to a framebuffer in memory
 * included. It writes lines of
 *     torus576,320x240,rgb565,8 points,fragment Blinn-Phong local,INSTRUCTIONS
 * which are means of ten frames. With FRAME_FLOAT the float renderer draws them.
 */
#include "../bench/counter.h"
#include "../bench/framebuffer.h"
#include "ways.h"

#ifdef FRAME_FLOAT
#include "../bench/float/fpu.h"
#include "../bench/float/renderer.h"
#endif

enum { WIDTH = 320, HEIGHT = 240 };

static uint32_t framebuffer[WIDTH * HEIGHT / 2]; /* words are copied and cleared */
static workload_stage stage;

#ifdef FRAME_FLOAT

static int32_t depth[WIDTH * HEIGHT];
static float_memory memory;

/* `make bench` has the first scene. */
#define FIRST_SCENE 1

static void start(void) {
    fpu_start();
}

static int draw(int first) {
    const float_screen screen = {WIDTH, HEIGHT, (uint16_t *)(void *)framebuffer, depth};

    (void)first;
    float_render(&screen, &memory, &stage.example.scene);
    return 0;
}

#else

static uint32_t arena[(1 << 20) / sizeof(uint32_t)];

#define FIRST_SCENE 0

static void start(void) {
}

static int copy_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    uint8_t *to = (uint8_t *)framebuffer + 2 * ((size_t)y * WIDTH + (size_t)x);

    (void)context;
    framebuffer_copy(to, 2 * (size_t)WIDTH, pixels, stride, 2 * (size_t)width, height);
    return 0;
}

/* The first frame of an animation is counted from glint_init on. */
static int draw(int first) {
    static glint_renderer renderer;
    const glint_config config = {.width = WIDTH,
                                 .height = HEIGHT,
                                 .tile_width = 32,
                                 .tile_height = 32,
                                 .format = &glint_format_rgb565,
                                 .flush = {copy_tile, 0, 0},
                                 .keeps_arena = 1,
                                 .arena = arena,
                                 .arena_size = sizeof arena};

    return (first && glint_init(&renderer, &config) != GLINT_OK) ||
           glint_render(&renderer, &stage.example.scene) != GLINT_OK;
}

#endif

/* @return 0, or 1 after an error */
static int count(const workload *drawn, const choice *chosen) {
    uint64_t ticks = 0;
    int failed = ways_build(&stage, drawn, chosen);

    for (uint32_t frame = 0; frame < drawn->frames && !failed; frame++) {
        workload_set_frame(&stage, frame);
        const uint32_t before = counter_now();
        failed = draw(frame == 0);
        ticks += counter_ticks_since(before);
    }
    board_write(drawn->scene);
    board_write(",320x240,rgb565,");
    board_write(ways_lights(drawn));
    board_write(",");
    board_write(chosen->name);
    board_write(",");
    write_number(drawn->frames ? (uint32_t)(ticks * COUNTER_INSTRUCTIONS_PER_TICK / drawn->frames) : 0, "\n");
    return failed;
}

int main(void) {
    int failed = 0;

    start();
    counter_start();
    for (uint32_t scene = FIRST_SCENE; scene < WAYS_SCENES; scene++) {
        const workload drawn = ways_scene(scene);
        for (uint32_t i = 0; i < CHOICES && !failed; i++) {
            failed = count(&drawn, &choices[i]);
        }
    }
    return failed;
}
