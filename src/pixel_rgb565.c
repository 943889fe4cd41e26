/* SPDX-License-Identifier: MIT */
/* Pixels of 16 bits: 5 red, 6 green, 5 blue, rounded to nearest. */
#include "pixel.h"

static uint16_t pack(const uint32_t colour[3]) {
    return (uint16_t)(glint_level(colour[0], 31) << 11 | glint_level(colour[1], 63) << 5 | glint_level(colour[2], 31));
}

static void store(void *pixels, const uint16_t *offset, uint32_t (*colour)[3], uint32_t count) {
    uint16_t *out = pixels;
    for (uint32_t i = 0; i < count; i++)
        out[offset[i]] = pack(colour[i]);
}

static void fill(void *pixels, uint32_t count, const uint32_t colour[3]) {
    uint16_t *out = pixels, value = pack(colour);
    for (uint32_t i = 0; i < count; i++)
        out[i] = value;
}

const glint_format glint_format_rgb565 = {16, store, fill};
