/* SPDX-License-Identifier: MIT */
/* Colour: the perspective divide of interpolated colours. */
#include "colour.h"
#include "setup.h"

void glint_resolve_colour(const glint_frame *frame, const glint_fragments *fragments, uint32_t i,
                          const glint_plane planes[3], int16_t out[3]) {
    int32_t x, y;
    glint_fragment_place(frame, fragments, i, &x, &y);
    /* The planes hold colour times w 2^-16; both are brought to 16 bits, which spares 64-bit products. */
    const uint32_t w = ((uint32_t)fragments->inverse_w[i] | 1) << fragments->scale;
    const unsigned zeros = glint_leading_zeros(w);
    const uint32_t reciprocal = 0x80000000u / ((w << zeros) >> 16); /* 2^15 to 2^16 */
    for (int c = 0; c < 3; c++) {
        int32_t value = glint_plane_at(&planes[c], x, y);
        uint32_t scaled = value > 0 ? (uint32_t)value << zeros : 0; /* colour times w in 16 bits: below 2^31 */
        uint32_t colour = ((scaled < 0x7fffffffu ? scaled : 0x7fffffffu) >> 15) * reciprocal >> 16;
        out[c] = (int16_t)(colour < GLINT_COLOUR_ONE ? colour : GLINT_COLOUR_ONE);
    }
}
