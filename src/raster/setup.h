/* SPDX-License-Identifier: MIT */
/** @file setup.h Attributes of a triangle as planes over the screen. */
#ifndef GLINT_SETUP_H
#define GLINT_SETUP_H

#include "raster.h"

/** Gradients, area and depth plane of a triangle, from its corners, counter-clockwise; the rest of the part stays. */
void glint_setup(glint_part *part, glint_triangle *triangle);

/**
 * The plane of an attribute that is a0, a1, a2 at the corners; below 2^31 apart. Slivers have slopes above 2^31: those
 * wrap, as their values do.
 */
void glint_plane_begin(glint_plane *plane, const glint_gradients *gradients, int32_t a0, int32_t a1, int32_t a2);

/** Slenderness, below, up to which a triangle's polynomials keep their digits; planes of others take whole slopes. */
#define GLINT_SLENDER 7

/** How many bits a triangle's longest side has, twice, beyond those of its area: of an equilateral one at most 2. */
static inline int32_t glint_slenderness(const glint_gradients *gradients, int32_t area) {
    const int32_t side_bits = 32 - (int32_t)glint_leading_zeros(gradients->reach + 1);
    return 2 * side_bits - 31 + (int32_t)glint_leading_zeros((uint32_t)area);
}

/** A plane's value at a pixel, x and y from the anchor. */
static inline int32_t glint_plane_at(const glint_plane *p, int32_t x, int32_t y) {
    return glint_add_wrap(p->start, glint_add_wrap(glint_multiply_wrap(p->dx, x), glint_multiply_wrap(p->dy, y)));
}

/** How 1/w changes across a triangle, Q16. */
typedef struct glint_w_range {
    uint32_t least, change;
} glint_w_range;

static inline glint_w_range glint_find_w_range(const glint_vertex *const v[3]) {
    const int32_t a = v[0]->inverse_w, b = v[1]->inverse_w, c = v[2]->inverse_w;
    const uint32_t low = (uint32_t)glint_least_of(a, b, c) >> 15, high = (uint32_t)glint_most_of(a, b, c) >> 15;
    return (glint_w_range){low, high - low + 1};
}

/** The shift that brings the largest 1/w of the corners, none 0, to 2^30 .. 2^31. */
static inline unsigned glint_find_room(const glint_vertex *const v[3]) {
    return glint_leading_zeros((uint32_t)(v[0]->inverse_w | v[1]->inverse_w | v[2]->inverse_w)) - 1;
}

/**
 * May rounding take the plane of 1/w below 0: by 2^-10 of the corners' difference and some pixels' steps? It is asked
 * for some times that.
 */
static inline int glint_is_deep(const glint_triangle *triangle) {
    const int32_t a = triangle->corners[0]->inverse_w, b = triangle->corners[1]->inverse_w,
                  c = triangle->corners[2]->inverse_w;
    const int32_t least = glint_least_of(a, b, c), most = glint_most_of(a, b, c);
    return least < 1 << 21 && least < glint_most(glint_shift_right(most, 6), 1 << 17);
}

#endif
