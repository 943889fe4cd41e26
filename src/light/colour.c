/* SPDX-License-Identifier: MIT */
/* Colour: the perspective divide of interpolated colours. */
#include "colour.h"

#include "../math/division.h"
#include "../raster/setup.h"

void glint_resolve_colour(const glint_fragments *fragments, uint32_t i, const glint_plane planes[3], int16_t out[3]) {
    const int32_t x = fragments->part->x + fragments->column[i], y = fragments->part->y + fragments->row[i];
    /*
     * The planes hold colour times w 2^-16; both are brought to 16 bits, which spares 64-bit products. What is cut off
     * is rounded up, so that white stays white; 0 stays 0.
     */
    const uint32_t w = (uint32_t)glint_most(fragments->inverse_w[i], 1) << fragments->scale;
    const unsigned zeros = glint_leading_zeros(w);
    const uint32_t reciprocal = 0x80000000u / ((w << zeros) >> 16) + 1; /* 2^15 + 1 to 2^16 + 1 */
    for (int c = 0; c < 3; c++) {
        int32_t value = glint_plane_at(&planes[c], x, y);
        uint32_t scaled = value > 0 ? (uint32_t)value << zeros : 0; /* colour times w in 16 bits: below 2^31 */
        scaled = scaled < 0x7fff8000u ? scaled : 0x7fff8000u;
        uint32_t product = ((scaled + 0x7fff) >> 15) * reciprocal; /* at most 2^32 - 1 */
        uint32_t colour = ((product >> 15) + 1) >> 1;
        out[c] = (int16_t)(colour < GLINT_COLOUR_ONE ? colour : GLINT_COLOUR_ONE);
    }
}

void glint_extend_colour(const glint_fragments *fragments, uint32_t i, const glint_plane planes[3], int16_t out[3]) {
    const int32_t x = fragments->part->x + fragments->column[i], y = fragments->part->y + fragments->row[i];
    const uint32_t w = (uint32_t)glint_most(fragments->inverse_w[i], 1) << fragments->scale;
    const unsigned zeros = glint_leading_zeros(w);
    const int32_t reciprocal = glint_reciprocal16(w << zeros >> 16) >> 1;
    for (int c = 0; c < 3; c++) {
        const int32_t value = glint_plane_at(&planes[c], x, y);
        const int32_t scaled = zeros < 16 ? glint_shift_right(value, 16 - zeros) : value; /* 1 has 15 bits */
        const int32_t most = (1 << 16) - 2;
        const int32_t colour =
            glint_shift_right(glint_most(glint_least(scaled, most), -most) * reciprocal + (1 << 14), 15);
        out[c] = (int16_t)glint_most(glint_least(colour, INT16_MAX), -INT16_MAX);
    }
}
