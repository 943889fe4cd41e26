/* SPDX-License-Identifier: MIT */
/* Pixels of 12 bits: 4 red, 4 green, 4 blue, high bits first; two pixels in three bytes. */
#include "pixel.h"

static inline uint32_t pack_rgb444(const int32_t colour[3], uint32_t threshold) {
    return glint_level(colour[0], 4, threshold) << 8 | glint_level(colour[1], 4, threshold) << 4 |
           glint_level(colour[2], 4, threshold);
}

/* Thresholds in 1/32: all that words have of blue. */
static inline uint32_t pack_spread_rgb444(uint32_t word, uint32_t threshold) {
    const uint32_t levels = glint_spread_clamp(word + (threshold >> 2) * 0x00400801u);
    return (levels >> 8 & 0xf00u) | (levels >> 23 & 0xf0u) | (levels >> 5 & 0xfu);
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
GLINT_DEFINE_FORMAT(rgb444, 12, GLINT_ROW_EDGE, 4, 4, 4, pack_rgb444, put_rgb444, glint_fill_tile, GLINT_FAST_SPREAD,
                    GLINT_FAST_SPREAD);
