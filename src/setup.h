/* SPDX-License-Identifier: MIT */
/** @file setup.h Attributes of a triangle as planes over the screen. */
#ifndef GLINT_SETUP_H
#define GLINT_SETUP_H

#include "frame.h"

/** Gradients, area and depth plane of a triangle, from its corners, counter-clockwise; the rest of the part stays. */
void glint_setup(glint_part *part, glint_triangle *triangle);

/**
 * The plane of an attribute that is a0, a1, a2 at the corners; below 2^31 apart. Slivers have slopes above 2^31: those
 * wrap, as their values do.
 */
void glint_plane_begin(glint_plane *plane, const glint_gradients *gradients, int32_t a0, int32_t a1, int32_t a2);

/** How many bits a triangle's longest side has, twice, beyond those of its area: of an equilateral one at most 2. */
static inline int32_t glint_slenderness(const glint_gradients *gradients, int32_t area) {
    const int32_t side_bits = 32 - (int32_t)glint_leading_zeros(gradients->reach + 1);
    return 2 * side_bits - 31 + (int32_t)glint_leading_zeros((uint32_t)area);
}

/** A plane's value at a pixel, x and y from the anchor. */
static inline int32_t glint_plane_at(const glint_plane *p, int32_t x, int32_t y) {
    return glint_add_wrap(p->start, glint_add_wrap(glint_multiply_wrap(p->dx, x), glint_multiply_wrap(p->dy, y)));
}

/** Pixel of fragment i, from the anchor. */
static inline void glint_fragment_place(const glint_frame *frame, const glint_fragments *fragments, uint32_t i,
                                        int32_t *x, int32_t *y) {
    const uint32_t offset = fragments->offset[i], mask = (uint32_t)frame->config.tile_width - 1;
    *x = fragments->attributes->x + (int32_t)(offset & mask);
    *y = fragments->attributes->y + (int32_t)(offset >> frame->tile_shift_x);
}

#endif
