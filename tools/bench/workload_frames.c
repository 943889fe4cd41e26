/* SPDX-License-Identifier: MIT */
/*
 * Firmware that counts the instructions of whole frames of all workloads, clear and copy to a framebuffer in memory
 * included; not those which frames.c counts. It writes a line for each,
 *     torus576,320x240 local 32x32 8 points,INSTRUCTIONS,SMALLEST,BEST
 * as frames.c does.
 */
#include "framebuffer.h"
#include "measure.h"
#include "workloads.h"

#ifdef IS_BY_DEFAULT
#include "../cost/shown.h"
#define IS_COUNTED(number, drawn) cost_is_shown(drawn)
#else
#define IS_BY_DEFAULT 0
#define IS_COUNTED(number, drawn) ((number) >= WORKLOADS_PLAIN)
#endif

/** The largest screen in the largest pixels. */
enum { FRAMEBUFFER_BYTES = 320 * 240 * 3 };

static uint32_t arena[(1 << 20) / sizeof(uint32_t)];
static uint32_t framebuffer[FRAMEBUFFER_BYTES / sizeof(uint32_t)];
static workload_stage stage;

static int copy_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    const workload *drawn = (const workload *)context;
    const glint_format *format = drawn->output->format;
    const size_t pitch = glint_row_bytes(format, drawn->width);
    uint8_t *to = (uint8_t *)framebuffer + (size_t)y * pitch + glint_row_bytes(format, (uint32_t)x);

    framebuffer_copy(to, pitch, pixels, stride, glint_row_bytes(format, (uint32_t)width), height);
    return 0;
}

/* Rows of bytes that hold 8 rows of pixels each. */
static int copy_pages(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    const workload *drawn = (const workload *)context;
    uint8_t *to = (uint8_t *)framebuffer + (size_t)(y / 8) * drawn->width + x;

    framebuffer_copy(to, drawn->width, pixels, 8 * stride, (size_t)width, (height + 7) / 8);
    return 0;
}

static glint_config config_of(workload *drawn) {
    static uint16_t tables[3][GLINT_GAMMA_ENTRIES];
    glint_config config = {.width = drawn->width,
                           .height = drawn->height,
                           .tile_width = 32,
                           .tile_height = 32,
                           .format = drawn->output->format,
                           .keeps_arena = !IS_BY_DEFAULT,
                           .arena = arena,
                           .arena_size = sizeof arena};

    config.flush.begin = drawn->output->pages ? copy_pages : copy_tile;
    config.flush.context = drawn;
    if (drawn->output->gamma) {
        workload_gamma(tables);
        config.gamma = (const uint16_t(*)[GLINT_GAMMA_ENTRIES])tables;
    }
    return config;
}

/* @return 0, or 1 when it cannot be drawn */
static int count(workload *drawn) {
    glint_config config = config_of(drawn);
    char text[WORKLOAD_TEXT];
    measured result = {0};
    glint_renderer renderer;

    board_write(drawn->scene);
    board_write(",");
    board_write(workload_variant(drawn, text));
    board_write(",");
    if (workload_build(&stage, drawn)) {
        board_write("no such variant\n");
        return 1;
    }
    config.layers = stage.example.layers;
    config.samples = stage.example.samples;
    for (uint32_t frame = 0; frame < drawn->frames; frame++) {
        workload_set_frame(&stage, frame);
        const glint_status status = measure_frame(&config, &stage.example.scene, frame == 0, &renderer, &result);
        if (status != GLINT_OK) {
            board_write(glint_strerror(status));
            board_write("\n");
            return 1;
        }
    }
    measure_write(&result, drawn->frames);
    return 0;
}

int main(void) {
    int failed = 0;

    counter_start();
    for (uint32_t i = 0; i < workload_count() && !failed; i++) {
        workload drawn = workload_get(i);
        drawn.by_default = IS_BY_DEFAULT;
        failed = IS_COUNTED(i, &drawn) && count(&drawn);
    }
    return failed;
}
