/* SPDX-License-Identifier: MIT */
/** @file point.h What spots have of point lights. */
#ifndef GLINT_POINT_H
#define GLINT_POINT_H

#include "shade.h"

/** Position and attenuation in the frame's units. */
void glint_point_place(const glint_light *light, glint_prepared_light *prepared, const glint_view *view);

/**
 * Direction and strength at each fragment; where it is gated and faces away strength alone, 0. Direction is off by at
 * most 2.4 steps of GLINT_UNIT, strength by 3.4 of Q15, where the vector to the light has 2^18 of the ray's steps and
 * 2^-13 of the ray, or more; for shorter ones, rounding to these steps adds to that.
 */
void glint_point_illuminate(const glint_prepared_light *light, glint_fragments *fragments);

/** Depth over the distance to a light that has just illuminated fragment i, Q8, or more; at most 2^16 - 1. */
uint32_t glint_point_closeness(const glint_fragments *fragments, uint32_t i);

/** What the square of a unit vector's length is more than GLINT_UNIT^2. */
static inline int32_t glint_square_excess(const int16_t unit[3]) {
    return glint_dot(unit, unit) - GLINT_UNIT * GLINT_UNIT;
}

/** What a cosine, times GLINT_UNIT^2, is more than it were of a unit vector as long as GLINT_UNIT. */
static inline int32_t glint_excess(int32_t cosine, int32_t square_excess) {
    return glint_shift_right(glint_shift_right(cosine, 17) * square_excess, 14);
}

/**
 * Cosine between a spot's axis and the way to a fragment, times GLINT_UNIT^2: rounding leaves L up to 2.4 of GLINT_UNIT
 * too long or short, which near the axis is all that the cosine would be off by. Within 20 degrees it is off by 0.8 of
 * 2^-15.
 */
static inline int32_t glint_cone_cosine(const glint_prepared_light *light, const int16_t direction[3]) {
    const int32_t cosine = glint_dot(direction, light->direction);
    return cosine - glint_excess(cosine, glint_square_excess(direction));
}

/** Takes over how a light weakens with distance. @return GLINT_ERROR_ATTENUATION where it would grow */
glint_status glint_point_attenuation(const glint_light *light, glint_prepared_light *prepared);

#endif
