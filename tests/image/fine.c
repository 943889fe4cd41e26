/* SPDX-License-Identifier: MIT */
#include "fine.h"

#include "pixel/pixel.h"

static inline uint32_t pack(const int32_t colour[3], uint32_t threshold) {
    (void)threshold;
    return glint_saturate(colour[0], 24, GLINT_CHANNEL_BITS - 24);
}

static inline void put(const glint_target *target, uint32_t offset, uint32_t packed) {
    uint8_t *out = (uint8_t *)target->pixels + 3 * offset;
    out[0] = (uint8_t)(packed >> 16);
    out[1] = (uint8_t)(packed >> 8);
    out[2] = (uint8_t)packed;
}

GLINT_DEFINE_FORMAT(fine, 24, GLINT_ROW_EDGE, 8, 8, 8, pack, put, glint_fill_tile, GLINT_FAST_NONE, GLINT_FAST_NONE);

double fine_level(const picture *image, int pixel) {
    const uint8_t *bytes = image->bytes + (size_t)3 * (size_t)pixel;
    return bytes[0] + bytes[1] / 256.0 + bytes[2] / 65536.0;
}
