/* SPDX-License-Identifier: MIT */
/* Pixels of 24 bits: red, green, blue. */
#include "pixel.h"

static void put(void *pixels, uint32_t offset, const uint32_t colour[3], uint32_t threshold) {
    uint8_t *out = (uint8_t *)pixels + 3 * offset;
    out[0] = (uint8_t)glint_level(colour[0], 255, threshold);
    out[1] = (uint8_t)glint_level(colour[1], 255, threshold);
    out[2] = (uint8_t)glint_level(colour[2], 255, threshold);
}

GLINT_DEFINE_FORMAT(glint_format_rgb888, 24, put);
