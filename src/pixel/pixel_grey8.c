/* SPDX-License-Identifier: MIT */
/* Pixels of 8 bits: luma. */
#include "pixel.h"

static inline uint32_t pack_grey8(const int32_t colour[3], uint32_t threshold) {
    return glint_luma_level(colour, 255, threshold);
}

static inline void put_grey8(const glint_target *target, uint32_t offset, uint32_t packed) {
    ((uint8_t *)target->pixels)[offset] = (uint8_t)packed;
}

GLINT_DEFINE_FORMAT(grey8, 8, GLINT_ROW_EDGE, 0, 0, 0, pack_grey8, put_grey8, glint_fill_tile, GLINT_KEEPS_ANY,
                    GLINT_SPREAD_NONE, GLINT_SPREAD_NONE);
