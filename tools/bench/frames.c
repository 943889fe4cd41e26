/* SPDX-License-Identifier: MIT */
/*
 * Counts the instructions of whole frames of the benchmark scenes. Under QEMU's -icount shift=0 an instruction takes a
 * nanosecond, and SysTick counts 25 MHz: forty instructions a tick, the same on every run.
 */
#include "board.h"
#include "cortex-m/cortex-m.h"

#include <bench_scenes.h>

#define INSTRUCTIONS_PER_TICK 40
#define TICKS 0x1000000u

static uint8_t arena[1 << 20];
static uint16_t framebuffer[320 * 240];
static uint16_t screen_width;

static uint32_t ticks(void) {
    return *cortex_m_register(0xe000e018u);
}

static void start_ticks(void) {
    *cortex_m_register(0xe000e014u) = TICKS - 1;
    *cortex_m_register(0xe000e018u) = 0;
    *cortex_m_register(0xe000e010u) = 5;
}

static int copy_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context;
    for (int row = 0; row < height; row++) {
        const uint16_t *from = (const uint16_t *)(const void *)((const uint8_t *)pixels + (size_t)row * stride);
        uint16_t *to = &framebuffer[(y + row) * screen_width + x];
        for (int column = 0; column < width; column++)
            to[column] = from[column];
    }
    return 0;
}

static void write_number(uint32_t value, const char *end) {
    char text[11];
    int i = 10;
    text[i] = 0;
    do {
        text[--i] = (char)('0' + value % 10);
        value /= 10;
    } while (value);
    board_write(text + i);
    board_write(end);
}

typedef struct variant {
    uint16_t width, height, tile_width, tile_height;
    glint_viewer viewer;
} variant;

/* Mean instructions of the ten frames; 0 when a frame fails. */
static uint32_t measure(uint32_t which, const variant *v) {
    static const glint_material material = {&glint_model_blinn_phong,
                                            {GLINT_Q16(0.9), GLINT_Q16(0.5), GLINT_Q16(0.3)},
                                            {GLINT_Q16(0.765), GLINT_Q16(0.425), GLINT_Q16(0.255)},
                                            {GLINT_Q16(0.5), GLINT_Q16(0.5), GLINT_Q16(0.5)},
                                            GLINT_Q16(32)};
    static const glint_light light = {&glint_light_directional,
                                      {GLINT_Q16(0.4), GLINT_Q16(0.6), GLINT_Q16(0.7)},
                                      {GLINT_ONE, GLINT_ONE, GLINT_ONE},
                                      {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
    glint_object object = {bench_scenes[which].mesh, &material, bench_scenes[which].poses[0]};
    const glint_scene scene = {{glint_pose_identity(), GLINT_Q16(60), GLINT_Q16(0.1)},
                               v->viewer,
                               {0, 0, 0},
                               {GLINT_Q16(0.15), GLINT_Q16(0.15), GLINT_Q16(0.15)},
                               &light,
                               1,
                               &object,
                               1};
    const glint_config config = {v->width, v->height, v->tile_width, v->tile_height, &glint_format_rgb565,
                                 {copy_tile, 0, 0}, arena, sizeof arena};
    glint_renderer renderer;
    uint32_t sum = 0;
    screen_width = v->width;
    for (int frame = 0; frame < BENCH_FRAMES; frame++) {
        object.pose = bench_scenes[which].poses[frame];
        uint32_t start = ticks();
        if (glint_init(&renderer, &config) != GLINT_OK || glint_render(&renderer, &scene) != GLINT_OK)
            return 0;
        sum += (start - ticks()) & (TICKS - 1);
    }
    return sum * (INSTRUCTIONS_PER_TICK / BENCH_FRAMES);
}

static const variant variants[] = {
    {320, 240, 32, 32, GLINT_VIEWER_LOCAL}, {320, 240, 32, 32, GLINT_VIEWER_INFINITE},
    {128, 64, 32, 32, GLINT_VIEWER_LOCAL},  {320, 240, 16, 16, GLINT_VIEWER_LOCAL},
    {320, 240, 32, 16, GLINT_VIEWER_LOCAL}, {320, 240, 64, 16, GLINT_VIEWER_LOCAL},
    {320, 240, 64, 32, GLINT_VIEWER_LOCAL}, {320, 240, 64, 64, GLINT_VIEWER_LOCAL},
};

int main(void) {
    start_ticks();
    for (uint32_t scene = 0; scene < sizeof bench_scenes / sizeof *bench_scenes; scene++) {
        for (uint32_t i = 0; i < sizeof variants / sizeof *variants; i++) {
            const variant *v = &variants[i];
            uint32_t instructions = measure(scene, v);
            if (!instructions)
                return 1;
            board_write("frame,");
            board_write(bench_scenes[scene].name);
            write_number(v->width, "x");
            write_number(v->height, v->viewer == GLINT_VIEWER_LOCAL ? " local" : " infinite");
            board_write(" tile ");
            write_number(v->tile_width, "x");
            write_number(v->tile_height, ",");
            write_number(instructions, "\n");
        }
    }
    return 0;
}
