/* SPDX-License-Identifier: MIT */
/* Pixels of 8 bits: luma. */
#include "pixel.h"

static void put(void *pixels, uint32_t offset, const uint32_t colour[3], uint32_t threshold) {
    ((uint8_t *)pixels)[offset] = (uint8_t)glint_level(glint_luma(colour), 255, threshold);
}

GLINT_DEFINE_FORMAT(glint_format_grey8, 8, put);
