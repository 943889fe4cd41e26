/* SPDX-License-Identifier: MIT */
/* Pixels of 1 bit: luma, the left one of eight lowest. */
#include "pixel.h"

static void put(void *pixels, uint32_t offset, const uint32_t colour[3], uint32_t threshold) {
    uint8_t *eight = (uint8_t *)pixels + (offset >> 3);
    uint32_t bit = offset & 7;
    *eight = (uint8_t)((*eight & ~(1u << bit)) | glint_level(glint_luma(colour), 1, threshold) << bit);
}

GLINT_DEFINE_FORMAT(glint_format_mono, 1, put);
