/* SPDX-License-Identifier: MIT */
/** @file point.h Functions of point lights that spots use, too. */
#ifndef GLINT_POINT_H
#define GLINT_POINT_H

#include "corners.h"

/** Brings position and attenuation of a light to the frame's units. */
void glint_point_place(const glint_light *light, glint_prepared_light *prepared, const glint_view *view);

/** Returns the square of a unit vector's length, less GLINT_UNIT^2. */
static inline int32_t glint_square_excess(const int16_t unit[3]) {
    return glint_dot(unit, unit) - GLINT_UNIT * GLINT_UNIT;
}

/**
 * Returns by how much a cosine, times GLINT_UNIT^2, is too large because its vectors are longer than GLINT_UNIT.
 * `square_excess` is the sum of both vectors' glint_square_excess: below 2^18.9, as lengths are off by at most 7 steps
 * of 2^15.
 */
static inline int32_t glint_excess(int32_t cosine, int32_t square_excess) {
    return glint_shift_right(glint_shift_right(cosine, 18) * square_excess, 13);
}

/** Set a light's attenuation in an object's space, once its place there is known; and a spot's axis: view.h. */
glint_bring_light glint_point_bring GLINT_IF_LINKED, glint_spot_bring GLINT_IF_LINKED;

/** Find the direction and the strength of a light at a point: view.h. The strength, Q15, is off by at most 8 steps. */
glint_reach_light glint_point_reach GLINT_IF_LINKED, glint_spot_reach GLINT_IF_LINKED;

/** Returns whether a light grows stronger with distance, which is an error. */
static inline int glint_light_grows(const glint_light *light) {
    return light->linear < 0 || light->quadratic < 0;
}

#endif
