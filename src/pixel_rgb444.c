/* SPDX-License-Identifier: MIT */
/* Pixels of 12 bits: 4 red, 4 green, 4 blue, high bits first; two pixels in three bytes. */
#include "pixel.h"

static void put(void *pixels, uint32_t offset, const uint32_t colour[3], uint32_t threshold) {
    uint8_t *pair = (uint8_t *)pixels + 3 * (offset >> 1);
    uint32_t red = glint_level(colour[0], 15, threshold);
    uint32_t green = glint_level(colour[1], 15, threshold);
    uint32_t blue = glint_level(colour[2], 15, threshold);
    if (offset & 1) {
        pair[1] = (uint8_t)((pair[1] & 0xf0u) | red);
        pair[2] = (uint8_t)(green << 4 | blue);
    } else {
        pair[0] = (uint8_t)(red << 4 | green);
        pair[1] = (uint8_t)((pair[1] & 0x0fu) | blue << 4);
    }
}

GLINT_DEFINE_FORMAT(glint_format_rgb444, 12, put);
