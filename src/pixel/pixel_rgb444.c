/* SPDX-License-Identifier: MIT */
/* Pixels of 12 bits: 4 red, 4 green, 4 blue, high bits first; two pixels in three bytes. */
#include "pixel.h"

static inline uint32_t pack_rgb444(const int32_t colour[3], uint32_t threshold) {
    return glint_level(colour[0], 4, threshold) << 8 | glint_level(colour[1], 4, threshold) << 4 |
           glint_level(colour[2], 4, threshold);
}

/* A channel of a word, which is `most` where it is 1, as one of 15 levels, with the threshold in 1/2^20 of one. */
static inline uint32_t level_of(uint32_t channel, uint32_t most, uint32_t threshold) {
    return glint_saturate((int32_t)(channel * (15 * (1u << 20) / most) + threshold), 4, 20);
}

static inline uint32_t pack_spread_rgb444(uint32_t word, uint32_t threshold) {
    const uint32_t clamped = glint_spread_clamp(word), at = threshold << 13;
    return level_of(clamped >> 10 & 0x3ff, 31 << 5, at) << 8 | level_of(clamped >> 21 & 0x3ff, 63 << 4, at) << 4 |
           level_of(clamped & 0x1ff, 31 << 4, at);
}

static inline void put_rgb444(const glint_target *target, uint32_t offset, uint32_t packed) {
    uint8_t *pair = (uint8_t *)target->pixels + 3 * (offset >> 1);
    if (offset & 1) {
        pair[1] = (uint8_t)((pair[1] & 0xf0u) | packed >> 8);
        pair[2] = (uint8_t)packed;
    } else {
        pair[0] = (uint8_t)(packed >> 4);
        pair[1] = (uint8_t)((pair[1] & 0x0fu) | packed << 4);
    }
}

GLINT_DEFINE_SPREAD(rgb444, pack_spread_rgb444, put_rgb444, 0)
GLINT_DEFINE_SPREAD(rgb444_dithered, pack_spread_rgb444, put_rgb444, 1)
GLINT_DEFINE_FORMAT(rgb444, 12, GLINT_ROW_EDGE, 4, 4, 4, pack_rgb444, put_rgb444, glint_fill_tile, GLINT_KEEPS_ANY,
                    GLINT_SPREAD_ANY, GLINT_SPREAD_ANY);
