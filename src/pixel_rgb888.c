/* SPDX-License-Identifier: MIT */
/* Pixels of 24 bits: red, green, blue, rounded to nearest. */
#include "pixel.h"

static void put(uint8_t *out, const uint32_t colour[3]) {
    for (int c = 0; c < 3; c++)
        out[c] = (uint8_t)glint_level(colour[c], 255);
}

static void store(void *pixels, const uint16_t *offset, uint32_t (*colour)[3], uint32_t count) {
    uint8_t *out = pixels;
    for (uint32_t i = 0; i < count; i++)
        put(out + 3 * offset[i], colour[i]);
}

static void fill(void *pixels, uint32_t count, const uint32_t colour[3]) {
    uint8_t *out = pixels;
    for (uint32_t i = 0; i < count; i++)
        put(out + 3 * i, colour);
}

const glint_format glint_format_rgb888 = {24, store, fill};
