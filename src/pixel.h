/* SPDX-License-Identifier: MIT */
/** @file pixel.h What the pixel formats share. */
#ifndef GLINT_PIXEL_H
#define GLINT_PIXEL_H

#include "frame.h"

/** 1 in a fragment's colour, Q23. */
#define GLINT_FULL (1u << 23)

static inline uint32_t glint_clamp(uint32_t channel) {
    return channel < GLINT_FULL ? channel : GLINT_FULL;
}

/** A channel, Q23, clamped at 1 and rounded to the nearest of 0 to `top` levels; top up to 255. */
static inline uint32_t glint_level(uint32_t channel, uint32_t top) {
    return (glint_clamp(channel) * top + GLINT_FULL / 2) >> 23;
}

/** 0.299 R + 0.587 G + 0.114 B (ITU-R BT.601) of the clamped colour, Q23; off by at most 3.3e-5. */
static inline uint32_t glint_luma(const uint32_t colour[3]) {
    return ((glint_clamp(colour[0]) >> 8) * 9798 + (glint_clamp(colour[1]) >> 8) * 19235 +
            (glint_clamp(colour[2]) >> 8) * 3735) >>
           7;
}

#endif
