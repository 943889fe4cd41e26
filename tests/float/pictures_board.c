/* SPDX-License-Identifier: MIT */
/*
 * Firmware that draws the first frame of each workload in RGB565 with the float renderer, and writes the pictures: a
 * row of pixels a line, four hexadecimal digits each, or "----" where no surface is seen.
 */
#include "board.h"
#include "fpu.h"
#include "renderer.h"
#include "workloads.h"

enum { WIDTH = 320, HEIGHT = 240 };

/* Aligned to words, which clearing writes. */
static uint32_t colour[WIDTH * HEIGHT / 2];
static int32_t depth[WIDTH * HEIGHT];
static float_memory memory;
static workload_stage stage;

static void write_row(const uint16_t *pixels, const int32_t *depths, uint32_t width) {
    static const char digits[] = "0123456789abcdef";
    static char text[4 * WIDTH + 2];
    char *out = text;

    for (uint32_t x = 0; x < width; x++) {
        for (int shift = 12; shift >= 0; shift -= 4) {
            *out++ = depths[x] ? digits[pixels[x] >> shift & 15] : '-';
        }
    }
    *out++ = '\n';
    *out = '\0';
    board_write(text);
}

/* @return 0, or 1 when it cannot be drawn */
static int draw(const workload *drawn) {
    const float_screen screen = {drawn->width, drawn->height, (uint16_t *)(void *)colour, depth};

    if (workload_build(&stage, drawn)) {
        board_write("no such variant\n");
        return 1;
    }
    float_render(&screen, &memory, &stage.example.scene);
    for (uint32_t y = 0; y < screen.height; y++) {
        write_row(screen.colour + (size_t)y * screen.width, depth + (size_t)y * screen.width, screen.width);
    }
    return 0;
}

int main(void) {
    int failed = 0;

    fpu_start();
    for (uint32_t i = 0; i < workload_count() && !failed; i++) {
        const workload drawn = workload_get(i);
        if (*drawn.output->name == '\0') {
            failed = draw(&drawn);
        }
    }
    return failed;
}
