/* SPDX-License-Identifier: MIT */
/* Pixels of 4 bits: luma, the left one of two in the high half. */
#include "pixel.h"

static inline uint32_t pack_grey4(const int32_t colour[3], uint32_t threshold) {
    return glint_luma_level(colour, 15, threshold);
}

static inline uint32_t pack_spread_grey4(uint32_t word, uint32_t threshold) {
    return glint_spread_luma(word, 4, threshold);
}

static inline void put_grey4(const glint_target *target, uint32_t offset, uint32_t packed) {
    uint8_t *pair = (uint8_t *)target->pixels + (offset >> 1);
    *pair = (uint8_t)(offset & 1 ? (*pair & 0xf0u) | packed : (*pair & 0x0fu) | packed << 4);
}

GLINT_DEFINE_SPREAD(grey4, pack_spread_grey4, put_grey4, 0)
GLINT_DEFINE_SPREAD(grey4_dithered, pack_spread_grey4, put_grey4, 1)
GLINT_DEFINE_FORMAT(grey4, 4, GLINT_ROW_EDGE, 0, 0, 0, pack_grey4, put_grey4, glint_fill_tile, GLINT_KEEPS_ANY,
                    GLINT_SPREAD_ANY, GLINT_SPREAD_ANY);
