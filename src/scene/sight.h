/* SPDX-License-Identifier: MIT */
/** @file sight.h Points as a camera sees them, for helpers that know no frame. */
#ifndef GLINT_SIGHT_H
#define GLINT_SIGHT_H

#include "../glint_extras.h"
#include "view.h"

/** Checks what places on a screen are found from. @return GLINT_ERROR_NULL, _SIZE or _CAMERA */
glint_status glint_check_sight(const glint_config *config, const glint_camera *camera);

/** A point from the eye: right, down and away, Q31, below 2^52. */
void glint_find_sight(const glint_camera *camera, glint_vector point, int64_t sight[3]);

/** Twice the focal length in pixels, Q12, below 2^29; of parallel rays, the guard band's width. */
int64_t glint_find_focal_length(const glint_config *config, const glint_camera *camera);

/** What x and y are divided by, Q31: how far away a point is, or the w of parallel rays, below 2^58. */
int64_t glint_find_divisor(const glint_config *config, const glint_camera *camera, const int64_t sight[3]);

#endif
