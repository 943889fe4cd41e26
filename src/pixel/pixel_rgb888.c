/* SPDX-License-Identifier: MIT */
/* Pixels of 24 bits: red, green, blue. */
#include "pixel.h"

static inline uint32_t pack_rgb888(const int32_t colour[3], uint32_t threshold) {
    return glint_level(colour[0], 8, threshold) << 16 | glint_level(colour[1], 8, threshold) << 8 |
           glint_level(colour[2], 8, threshold);
}

static inline void put_rgb888(const glint_target *target, uint32_t offset, uint32_t packed) {
    uint8_t *out = (uint8_t *)target->pixels + 3 * offset;
    out[0] = (uint8_t)(packed >> 16);
    out[1] = (uint8_t)(packed >> 8);
    out[2] = (uint8_t)packed;
}

GLINT_DEFINE_FORMAT(rgb888, 24, GLINT_ROW_EDGE, 8, 8, 8, pack_rgb888, put_rgb888, glint_fill_tile, GLINT_KEEPS_ANY,
                    GLINT_SPREAD_NONE, GLINT_SPREAD_NONE);
