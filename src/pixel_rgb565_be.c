/* SPDX-License-Identifier: MIT */
/* Pixels of 16 bits, high byte first whatever the core's byte order. */
#include "pixel.h"

static void put(uint8_t *out, const uint32_t colour[3]) {
    uint32_t green = glint_level(colour[1], 63);
    out[0] = (uint8_t)(glint_level(colour[0], 31) << 3 | green >> 3);
    out[1] = (uint8_t)((green & 7) << 5 | glint_level(colour[2], 31));
}

static void store(void *pixels, const uint16_t *offset, uint32_t (*colour)[3], uint32_t count) {
    uint8_t *out = pixels;
    for (uint32_t i = 0; i < count; i++)
        put(out + 2 * offset[i], colour[i]);
}

static void fill(void *pixels, uint32_t count, const uint32_t colour[3]) {
    uint8_t *out = pixels;
    for (uint32_t i = 0; i < count; i++)
        put(out + 2 * i, colour);
}

const glint_format glint_format_rgb565_be = {16, store, fill};
