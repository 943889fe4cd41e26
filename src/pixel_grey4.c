/* SPDX-License-Identifier: MIT */
/* Pixels of 4 bits: luma, the left one of two in the high half. */
#include "pixel.h"

static void put(void *pixels, uint32_t offset, const uint32_t colour[3], uint32_t threshold) {
    uint8_t *pair = (uint8_t *)pixels + (offset >> 1);
    uint32_t level = glint_level(glint_luma(colour), 15, threshold);
    *pair = (uint8_t)(offset & 1 ? (*pair & 0xf0u) | level : (*pair & 0x0fu) | level << 4);
}

GLINT_DEFINE_FORMAT(glint_format_grey4, 4, put);
