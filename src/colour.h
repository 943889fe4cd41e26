/* SPDX-License-Identifier: MIT */
/** @file colour.h Colours that were interpolated: over w, or on the screen where that is as good. */
#ifndef GLINT_COLOUR_H
#define GLINT_COLOUR_H

#include "frame.h"

/**
 * A fragment's colour, 1 = GLINT_COLOUR_ONE, from its planes: the colour times 2^15, or the colour over w. Off by at
 * most 2 steps.
 */
static inline void glint_resolve_colour(const glint_fragments *fragments, uint32_t i, const int32_t plane[3],
                                        int16_t out[3]) {
    int64_t factor = 1;
    unsigned shift = 15;
    if (fragments->perspective) {
        uint32_t w = (uint32_t)fragments->inverse_w[i];
        unsigned zeros = glint_leading_zeros(w | 1);
        factor = glint_reciprocal((w | 1) << zeros); /* 1 / w is this times 2^(zeros - 63) */
        shift = 46 - zeros + fragments->perspective; /* the planes hold colour times w 2^(perspective - 17) */
    }
    for (int c = 0; c < 3; c++) {
        int64_t value = glint_round_shift64(plane[c] * factor, shift);
        out[c] = (int16_t)(value < 0 ? 0 : value > GLINT_COLOUR_ONE ? GLINT_COLOUR_ONE : value);
    }
}

#endif
