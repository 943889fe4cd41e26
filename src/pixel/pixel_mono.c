/* SPDX-License-Identifier: MIT */
/* Pixels of 1 bit: luma, the left one of eight lowest. */
#include "pixel.h"

static inline uint32_t pack_mono(const int32_t colour[3], uint32_t threshold) {
    return glint_luma_level(colour, 1, threshold);
}

static inline uint32_t pack_spread_mono(uint32_t word, uint32_t threshold) {
    return glint_spread_luma(word, 1, threshold);
}

static inline void put_mono(const glint_target *target, uint32_t offset, uint32_t packed) {
    uint8_t *eight = (uint8_t *)target->pixels + (offset >> 3);
    const uint32_t bit = offset & 7;
    *eight = (uint8_t)((*eight & ~(1u << bit)) | packed << bit);
}

GLINT_DEFINE_SPREAD(mono, pack_spread_mono, put_mono, 0)
GLINT_DEFINE_SPREAD(mono_dithered, pack_spread_mono, put_mono, 1)
GLINT_DEFINE_FORMAT(mono, 1, GLINT_ROW_EDGE, 0, 0, 0, pack_mono, put_mono, glint_fill_tile, GLINT_KEEPS_ANY,
                    GLINT_SPREAD_ANY, GLINT_SPREAD_ANY);
