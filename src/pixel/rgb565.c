/* SPDX-License-Identifier: MIT */
/* RGB565: 5 bits of red, 6 of green and 5 of blue in the byte order of the core. */
#include "pixel.h"

static inline void put_rgb565(const glint_target *target, uint32_t offset, uint32_t packed) {
    ((uint16_t *)target->pixels)[offset] = (uint16_t)packed;
}

#define SPREAD_ROUNDED(suffix) store_spread_##suffix, GLINT_SPANS_OF_RGB565

GLINT_DEFINE_SPREAD(rgb565, glint_pack_spread_565, put_rgb565, 0)
GLINT_DEFINE_SPREAD(rgb565_dithered, glint_spread_565, put_rgb565, 1)
GLINT_DEFINE_FORMAT(rgb565, 16, GLINT_ROW_EDGE, 5, 6, 5, glint_pack_565, put_rgb565, glint_fill_tile, GLINT_KEEPS_16,
                    SPREAD_ROUNDED, GLINT_SPREAD_ANY);

const struct glint_sun_spans *const glint_spans_of_rgb565 = &glint_sun_spans_rgb565;
