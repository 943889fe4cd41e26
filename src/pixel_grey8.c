/* SPDX-License-Identifier: MIT */
/* Pixels of 8 bits: luma, rounded to nearest. */
#include "pixel.h"

static void store(void *pixels, const uint16_t *offset, uint32_t (*colour)[3], uint32_t count) {
    uint8_t *out = pixels;
    for (uint32_t i = 0; i < count; i++)
        out[offset[i]] = (uint8_t)glint_level(glint_luma(colour[i]), 255);
}

static void fill(void *pixels, uint32_t count, const uint32_t colour[3]) {
    uint8_t *out = pixels, value = (uint8_t)glint_level(glint_luma(colour), 255);
    for (uint32_t i = 0; i < count; i++)
        out[i] = value;
}

const glint_format glint_format_grey8 = {8, store, fill};
