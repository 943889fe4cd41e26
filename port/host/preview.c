/* SPDX-License-Identifier: MIT */
#include "preview.h"

#include <stdio.h>

/** A picture that is made smaller: `factor` times `factor` pixels become one. */
typedef struct preview {
    const uint8_t *pixels;
    uint32_t width, height, channels, factor;
} preview;

/** The mean of a square, as far as it lies in the picture; black below it. */
static void find_mean(const preview *from, uint32_t column, uint32_t row, uint32_t mean[3]) {
    uint32_t count = 0;
    mean[0] = mean[1] = mean[2] = 0;
    for (uint32_t y = row * from->factor; y < (row + 1) * from->factor && y < from->height; y++) {
        for (uint32_t x = column * from->factor; x < (column + 1) * from->factor && x < from->width; x++, count++) {
            const uint8_t *pixel = from->pixels + ((size_t)y * from->width + x) * from->channels;
            for (uint32_t c = 0; c < 3; c++) {
                mean[c] += pixel[c % from->channels];
            }
        }
    }
    for (uint32_t c = 0; c < 3; c++) {
        mean[c] = count > 0 ? (mean[c] + count / 2) / count : 0;
    }
}

void preview_print(const uint8_t *pixels, uint32_t width, uint32_t height, uint32_t channels, uint32_t columns) {
    const uint32_t factor = (width + columns - 1) / columns;
    const preview from = {pixels, width, height, channels, factor};
    for (uint32_t row = 0; row * factor < height; row += 2) {
        for (uint32_t column = 0; column * factor < width; column++) {
            uint32_t upper[3];
            uint32_t lower[3];
            find_mean(&from, column, row, upper);
            find_mean(&from, column, row + 1, lower);
            printf("\033[38;2;%u;%u;%u;48;2;%u;%u;%um\342\226\200", (unsigned)upper[0], (unsigned)upper[1],
                   (unsigned)upper[2], (unsigned)lower[0], (unsigned)lower[1], (unsigned)lower[2]);
        }
        puts("\033[0m");
    }
}
