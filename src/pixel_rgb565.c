/* SPDX-License-Identifier: MIT */
/* Pixels of 16 bits: 5 red, 6 green, 5 blue. */
#include "pixel.h"
#include "spans565.h"

static void put(void *pixels, uint32_t offset, const uint32_t colour[3], uint32_t threshold) {
    uint16_t *out = pixels;
    out[offset] = (uint16_t)(glint_level(colour[0], 31, threshold) << 11 | glint_level(colour[1], 63, threshold) << 5 |
                             glint_level(colour[2], 31, threshold));
}

GLINT_DEFINE_FAST(fast, 0);
GLINT_DEFINE_FAST_FORMAT(glint_format_rgb565, 16, put, &fast);
