/* SPDX-License-Identifier: MIT */
/** @file lengths.h How long the normal over w is at the nodes of a triangle. */
#ifndef GLINT_LENGTHS_H
#define GLINT_LENGTHS_H

#include "../math/division.h"
#include "terms.h"

/** M at a node, N/w with the largest corner's 1/w as 1: its square and its length, Q15. */
typedef struct glint_lengths {
    int32_t square[6], length[6];
} glint_lengths;

/** sqrt(x), Q15, x from 2^13 to 2^15. */
static inline int32_t glint_root_of15(uint32_t x) {
    const unsigned up = (glint_leading_zeros(x) - 3) | 1;
    const uint32_t wide = x << up; /* 2^28 .. 2^30 */
    const uint32_t inverse = (uint32_t)glint_inverse_root(wide);
    const uint32_t root = (wide >> 14) * (inverse + (inverse >> 13)) >> 16;
    return (int32_t)(root << 1 >> (up - 13) / 2);
}

/**
 * M.M between the nodes is no less than 1/4 + 0.0026 where they have this, Q15: it is (4 s - 1) / 3 at the centre of a
 * triangle whose corners have 1 and whose middles have s. Quadratics are off by less than what is above 1/4.
 */
#define GLINT_LEAST_SQUARE ((7 << 11) + 64)

/**
 * Lengths at the corners, whose 1/w is w, Q15, and squares there and at the middles of the edges, where
 * M.M = ((wa + wb) / 2)^2 - wa wb |Na - Nb|^2 / 4. @param apart |Na - Nb|^2 of an edge, Q26
 * @return 0 where a square is too small
 */
static inline int glint_find_lengths(const glint_triangle *triangle, const int32_t apart[3], glint_lengths *of) {
    const glint_vertex *const *v = triangle->corners;
    uint32_t w[3];
    const uint32_t largest = (uint32_t)glint_most_of(v[0]->inverse_w, v[1]->inverse_w, v[2]->inverse_w);
    const unsigned zeros = glint_leading_zeros(largest);
    const uint32_t reciprocal = (uint32_t)glint_reciprocal16(largest << zeros >> 16) - 1; /* 2^31 over 16 bits */
    for (int i = 0; i < 3; i++) {
        w[i] = ((uint32_t)v[i]->inverse_w << zeros >> 16) * reciprocal >> 16;
        of->length[i] = (int32_t)w[i];
        of->square[i] = (int32_t)(w[i] * w[i] >> 15);
    }
    for (int i = 0; i < 3; i++) {
        const int a = i == 1 ? 1 : 0, b = i == 0 ? 1 : 2;
        const int32_t mean = (int32_t)(w[a] + w[b]) >> 1, both = (int32_t)(w[a] * w[b] >> 15);
        const int32_t square = (mean * mean >> 15) - (both * glint_shift_right(apart[i], 12) >> 16);
        if (square < GLINT_LEAST_SQUARE || of->square[i] < GLINT_LEAST_SQUARE)
            return 0;
        of->square[3 + i] = square;
    }
    return 1;
}

/** And at the middles. */
static inline void glint_find_middle_lengths(glint_lengths *of) {
    for (int i = 3; i < 6; i++)
        of->length[i] = glint_root_of15((uint32_t)of->square[i]);
}

#endif
