/* SPDX-License-Identifier: MIT */
/* Pixels of 4 bits: luma, rounded to nearest, the left one of two in the high half. */
#include "pixel.h"

static void store(void *pixels, const uint16_t *offset, uint32_t (*colour)[3], uint32_t count) {
    uint8_t *out = pixels;
    for (uint32_t i = 0; i < count; i++) {
        uint8_t *pair = &out[offset[i] >> 1];
        uint32_t level = glint_level(glint_luma(colour[i]), 15);
        *pair = (uint8_t)(offset[i] & 1 ? (*pair & 0xf0u) | level : (*pair & 0x0fu) | level << 4);
    }
}

static void fill(void *pixels, uint32_t count, const uint32_t colour[3]) {
    uint8_t *out = pixels, value = (uint8_t)(glint_level(glint_luma(colour), 15) * 0x11);
    for (uint32_t i = 0; i < count / 2; i++)
        out[i] = value;
}

const glint_format glint_format_grey4 = {4, store, fill};
