/* SPDX-License-Identifier: MIT */
/* RGB565 with the high byte first, whatever the byte order of the core. */
#include "pixel.h"

static inline void put_rgb565_be(const glint_target *target, uint32_t offset, uint32_t packed) {
    uint8_t *out = (uint8_t *)target->pixels + 2 * offset;
    out[0] = (uint8_t)(packed >> 8);
    out[1] = (uint8_t)packed;
}

#define SPREAD_ROUNDED_BE(suffix) store_spread_##suffix, GLINT_SPANS_OF_RGB565_BE

GLINT_DEFINE_SPREAD(rgb565_be, glint_pack_spread_565, put_rgb565_be, 0)
GLINT_DEFINE_SPREAD(rgb565_be_dithered, glint_spread_565, put_rgb565_be, 1)
GLINT_DEFINE_FORMAT(rgb565_be, 16, GLINT_ROW_EDGE, 5, 6, 5, glint_pack_565, put_rgb565_be, glint_fill_tile,
                    GLINT_KEEPS_SWAPPED, SPREAD_ROUNDED_BE, GLINT_SPREAD_ANY);

const struct glint_sun_spans *const glint_spans_of_rgb565_be = &glint_sun_spans_rgb565_be;
