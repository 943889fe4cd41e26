/* SPDX-License-Identifier: MIT */
/** @file angles.h What a region turns by, products of that, and what these leave of highlights. */
#ifndef GLINT_ANGLES_H
#define GLINT_ANGLES_H

#include "terms.h"

/** Angles beyond this, Q12, have no polynomial. */
#define GLINT_WIDEST (2 << 12)

/** Products of angles up to 2, Q12. */
static inline uint32_t glint_times(uint32_t a, uint32_t b) {
    return a * b >> 12;
}

/** a (a + b)^2, what quadratics err by where something turns by a, and 1/w changes by b. */
static inline uint32_t glint_cube(uint32_t a, uint32_t b) {
    return glint_times(glint_times(a, a + b), a + b);
}

/** How far a region's highlights turn about their axes, and these about them. */
static inline uint32_t glint_lobe_turn(const glint_shading *shading, const glint_region *region) {
    return shading->material->model->lobe == GLINT_LOBE_MIRROR ? 2 * region->turn : region->turn;
}

/** What L and V turn by. */
static inline uint32_t glint_turn_of_rays(const glint_frame *frame, const glint_region *region, uint32_t l) {
    return region->near_of[l] + (frame->view->local_viewer ? region->reach : 0);
}

/* ---- What quadratics leave of a highlight's deviation ---- */

/** a b of angles up to 3, b of 13 bits: a Q24, Q16. */
static inline uint32_t glint_times_angle(uint32_t a, uint32_t b) {
    return (a >> 12) * b >> 8;
}

/**
 * What an axis alone leaves, which turns by g where L and V turn by v, over g: as g does, or as V, whose third
 * derivative goes with v^3, over |L + V|, which is v / g. That leaves 0.0275 of it, 0.685 of 0.041.
 */
static inline uint32_t glint_axis_third(uint32_t g, uint32_t v, uint32_t b) {
    const uint32_t own = (g + b) * (g + b), of_view = ((v + b) * (v + b) >> 4) * 11;
    return own > of_view ? own : of_view;
}

/**
 * What quadratics leave of a highlight's deviation, in 0.041: N, which turns by t, and its axis together; or, where N
 * turns little, the axis. 1/w changes by b.
 */
static inline uint32_t glint_lobe_third(uint32_t t, uint32_t g, uint32_t v, uint32_t b) {
    const uint32_t h = t + g, both = glint_times_angle((h + b) * (h + b), h),
                   axis = glint_times_angle(glint_axis_third(g, v, b), g);
    return both > axis ? both : axis;
}

/**
 * The same over length. N there is linear, and R under Phong's model, times |M|^2, quadratic: their turn t is exact
 * alone, and what is left is what the axis turns by, g, alone and with them. Quadratics through the middles are off
 * from the product of a linear function that changes by x along edges and a quadratic one by 0.0281 x y, y being its
 * second derivative, of one sign as those of unit vectors are; 0.0281 is 0.685 of 0.041. That of the axis is g v, where
 * L and V turn by v and g is v / |L + V|. That of R |M|^2 = 2 (M.L) M - (M.M) L is twice the square of what M changes
 * by, which is t / 2 and what 1/w makes of it; dividing by M.M makes it 1 / cos^2(t / 4) times as much, less than 1 +
 * t^2 / 8.
 */
static inline uint32_t glint_lobe_third_over_length(uint32_t t, uint32_t g, uint32_t v, uint32_t b, int is_mirrored) {
    const uint32_t square = glint_times(t, t),
                   of_r = glint_times(square / 2 + glint_times(b, b), (1 << 12) + square / 8);
    const uint32_t mixed = (t + b) * (v + b) + (is_mirrored ? of_r << 12 : 0);
    return glint_times_angle(glint_axis_third(g, v, b) + (mixed >> 4) * 11, g);
}

#endif
