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

/** Takes over how a light weakens with distance. @return GLINT_ERROR_ATTENUATION where it would grow */
glint_status glint_point_attenuation(const glint_light *light, glint_prepared_light *prepared);

#endif
