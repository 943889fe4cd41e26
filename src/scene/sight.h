/* SPDX-License-Identifier: MIT */
/** @file sight.h Points as a camera sees them, for helpers that know no frame. */
#ifndef GLINT_SIGHT_H
#define GLINT_SIGHT_H

#include "view.h"

/** Checks what places on a screen are found from. @return GLINT_ERROR_NULL, _SIZE or _CAMERA */
glint_status glint_check_sight(const glint_config *config, const glint_camera *camera);

/** A point from the eye: right, down and away, Q31, below 2^52. */
void glint_find_sight(const glint_camera *camera, glint_vector point, int64_t sight[3]);

/** Twice the focal length in pixels, Q12, below 2^29: half the height over the tangent of half the field of view. */
int64_t glint_find_focal_length(const glint_config *config, glint_q16 field_of_view);

#endif
