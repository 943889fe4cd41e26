/* SPDX-License-Identifier: MIT */
/** @file point.h What spots have of point lights. */
#ifndef GLINT_POINT_H
#define GLINT_POINT_H

#include "frame.h"

/** Position and attenuation in the frame's units. */
void glint_point_place(const glint_light *light, glint_prepared_light *prepared, const glint_view *view);

/**
 * Direction and strength at each fragment. Direction is off by at most 2 steps of GLINT_UNIT, strength by 3e-4 of
 * itself and half a step of Q15.
 */
void glint_point_illuminate(const glint_prepared_light *light, glint_fragments *fragments);

/** Takes over how a light weakens with distance. @return GLINT_ERROR_ATTENUATION where it would grow */
glint_status glint_point_attenuation(const glint_light *light, glint_prepared_light *prepared);

#endif
