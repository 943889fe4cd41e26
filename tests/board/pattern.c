/* SPDX-License-Identifier: MIT */
/*
 * Firmware that draws a pattern through the panel driver alone, no renderer: rectangles of several sizes and strides,
 * each pixel a hash of its place, so that a swapped half byte, a shifted window or a lost row shows.
 */
#include "board.h"
#include "panel/ssd0323.h"

/* The same sum in tests/board/panel.py. */
static unsigned pattern(int x, int y) {
    return (unsigned)(x * 7 + y * 11 + x * y / 5) & 15u;
}

static int draw(const glint_panel *panel, int x, int y, int width, int height) {
    static uint8_t pixels[40 * 64];
    const size_t stride = 40;
    int status;

    for (int row = 0; row < height; row++) {
        for (int pair = 0; pair < width / 2; pair++) {
            const int left = x + 2 * pair;
            pixels[(size_t)row * stride + (size_t)pair] =
                (uint8_t)(pattern(left, y + row) << 4 | pattern(left + 1, y + row));
        }
    }
    status = glint_panel_begin(panel, x, y, width, height, pixels, stride);
    return status ? status : glint_panel_wait(panel);
}

int main(void) {
    static const int rectangles[][4] = {{64, 0, 64, 64}, {0, 0, 32, 32},  {32, 0, 32, 31},
                                        {0, 32, 2, 32},  {2, 32, 30, 32}, {32, 31, 32, 33}};
    const glint_panel panel = {&glint_panel_ssd0323, board_panel_bus()};
    int failed = glint_panel_start(&panel) != 0;

    for (unsigned i = 0; i < sizeof rectangles / sizeof rectangles[0]; i++) {
        const int *r = rectangles[i];
        failed |= draw(&panel, r[0], r[1], r[2], r[3]) != 0;
    }
    failed |= draw(&panel, 1, 0, 2, 2) != GLINT_ERROR_REGION;
    failed |= draw(&panel, 0, 63, 2, 2) != GLINT_ERROR_REGION;
    board_checkpoint("pattern 0");
    return failed;
}
