/* SPDX-License-Identifier: MIT */
/** @file point.h What spots have of point lights. */
#ifndef GLINT_POINT_H
#define GLINT_POINT_H

#include "corners.h"

/** Position and attenuation in the frame's units. */
void glint_point_place(const glint_light *light, glint_prepared_light *prepared, const glint_view *view);

/** What the square of a unit vector's length is more than GLINT_UNIT^2. */
static inline int32_t glint_square_excess(const int16_t unit[3]) {
    return glint_dot(unit, unit) - GLINT_UNIT * GLINT_UNIT;
}

/**
 * What a cosine, times GLINT_UNIT^2, is more than it were of a unit vector as long as GLINT_UNIT. Both vectors'
 * excesses together are below 2^18.9: lengths are off by 7 of 2^15 at most.
 */
static inline int32_t glint_excess(int32_t cosine, int32_t square_excess) {
    return glint_shift_right(glint_shift_right(cosine, 18) * square_excess, 13);
}

/** Sets how a light weakens with distance in an object's space, where its place is known; of a spot its axis too. */
glint_bring_light glint_point_bring GLINT_IF_LINKED, glint_spot_bring GLINT_IF_LINKED;

/** Finds what a point sees of a light; view.h. Strength is off by at most 8 of Q15. */
glint_reach_light glint_point_reach GLINT_IF_LINKED, glint_spot_reach GLINT_IF_LINKED;

/** Does a light grow with distance? */
static inline int glint_light_grows(const glint_light *light) {
    return light->linear < 0 || light->quadratic < 0;
}

#endif
