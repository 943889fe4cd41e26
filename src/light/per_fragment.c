/* SPDX-License-Identifier: MIT */
/* Lighting at every fragment, with the normal interpolated and made unit (Phong, 1975). */
#include "evaluation.h"
#include "lamps.h"

const glint_evaluation glint_per_fragment = {
    .lit_at = GLINT_LIT_AT_FRAGMENTS, .light = glint_transform_normals, .draw_triangle = glint_draw_lamps};
