/* SPDX-License-Identifier: MIT */
/* Colour: the perspective divide of interpolated colours. */
#include "colour.h"
#include "setup.h"

void glint_resolve_colour(const glint_frame *frame, const glint_fragments *fragments, uint32_t i,
                          const glint_plane planes[3], int16_t out[3]) {
    int32_t x, y;
    glint_fragment_place(frame, fragments, i, &x, &y);
    uint32_t w = (uint32_t)fragments->inverse_w[i] | 1;
    unsigned zeros = glint_leading_zeros(w);
    int64_t reciprocal = glint_reciprocal(w << zeros); /* 1 / w is this times 2^(zeros - 63) */
    unsigned shift = 47 - zeros + fragments->scale;    /* the planes hold colour times w 2^(scale - 16) */
    for (int c = 0; c < 3; c++) {
        int64_t value = glint_round_shift64(glint_plane_at(&planes[c], x, y) * reciprocal, shift);
        out[c] = (int16_t)(value < 0 ? 0 : value > GLINT_COLOUR_ONE ? GLINT_COLOUR_ONE : value);
    }
}
