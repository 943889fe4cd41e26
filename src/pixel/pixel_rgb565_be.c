/* SPDX-License-Identifier: MIT */
/* Pixels of 16 bits, high byte first whatever the core's byte order. */
#include "pixel.h"

static inline uint32_t pack_rgb565_be(const int32_t colour[3], uint32_t threshold) {
    return glint_level(colour[0], 5, threshold) << 11 | glint_level(colour[1], 6, threshold) << 5 |
           glint_level(colour[2], 5, threshold);
}

static inline void put_rgb565_be(const glint_target *target, uint32_t offset, uint32_t packed) {
    uint8_t *out = (uint8_t *)target->pixels + 2 * offset;
    out[0] = (uint8_t)(packed >> 8);
    out[1] = (uint8_t)packed;
}

/* Words have half a level already, and are clamped. */
static inline uint32_t pack_spread_rgb565_be(uint32_t word, uint32_t threshold) {
    (void)threshold;
    return glint_spread_pack(word);
}

#define SPREAD_ROUNDED_BE(suffix) store_spread_##suffix, GLINT_SPANS_OF_RGB565_BE

GLINT_DEFINE_SPREAD(rgb565_be, pack_spread_rgb565_be, put_rgb565_be, 0)
GLINT_DEFINE_SPREAD(rgb565_be_dithered, glint_spread_565, put_rgb565_be, 1)
GLINT_DEFINE_FORMAT(rgb565_be, 16, GLINT_ROW_EDGE, 5, 6, 5, pack_rgb565_be, put_rgb565_be, glint_fill_tile,
                    GLINT_KEEPS_SWAPPED, SPREAD_ROUNDED_BE, GLINT_SPREAD_ANY);

const struct glint_sun_spans *const glint_spans_of_rgb565_be = &glint_sun_spans_rgb565_be;
