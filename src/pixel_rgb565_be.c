/* SPDX-License-Identifier: MIT */
/* Pixels of 16 bits, high byte first whatever the core's byte order. */
#include "pixel.h"
#include "spans565.h"

static void put(void *pixels, uint32_t offset, const uint32_t colour[3], uint32_t threshold) {
    uint8_t *out = (uint8_t *)pixels + 2 * offset;
    uint32_t green = glint_level(colour[1], 63, threshold);
    out[0] = (uint8_t)(glint_level(colour[0], 31, threshold) << 3 | green >> 3);
    out[1] = (uint8_t)((green & 7) << 5 | glint_level(colour[2], 31, threshold));
}

GLINT_DEFINE_FAST(fast, 1);
GLINT_DEFINE_FAST_FORMAT(glint_format_rgb565_be, 16, put, &fast);
