/* SPDX-License-Identifier: MIT */
/* Pixels of 16 bits: 5 red, 6 green, 5 blue. */
#include "pixel.h"

static inline uint32_t pack_rgb565(const int32_t colour[3], uint32_t threshold) {
    return glint_level(colour[0], 5, threshold) << 11 | glint_level(colour[1], 6, threshold) << 5 |
           glint_level(colour[2], 5, threshold);
}

static inline void put_rgb565(const glint_target *target, uint32_t offset, uint32_t packed) {
    ((uint16_t *)target->pixels)[offset] = (uint16_t)packed;
}

/* Words have half a level already, and are clamped. */
static inline uint32_t pack_spread_rgb565(uint32_t word, uint32_t threshold) {
    (void)threshold;
    return glint_spread_pack(word);
}

#define SPREAD_ROUNDED(suffix) store_spread_##suffix, GLINT_SPANS_OF_RGB565

GLINT_DEFINE_SPREAD(rgb565, pack_spread_rgb565, put_rgb565, 0)
GLINT_DEFINE_SPREAD(rgb565_dithered, glint_spread_565, put_rgb565, 1)
GLINT_DEFINE_FORMAT(rgb565, 16, GLINT_ROW_EDGE, 5, 6, 5, pack_rgb565, put_rgb565, glint_fill_tile, GLINT_KEEPS_16,
                    SPREAD_ROUNDED, GLINT_SPREAD_ANY);

const struct glint_sun_spans *const glint_spans_of_rgb565 = &glint_sun_spans_rgb565;
