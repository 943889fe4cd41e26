/* SPDX-License-Identifier: MIT */
/* Lighting at every fragment, with the normal interpolated and made unit (Phong, 1975). */
#include "colour.h"
#include "evaluation.h"
#include "fragments.h"

void glint_shade(const glint_frame *frame, glint_fragments *fragments, const glint_draw *draw) {
    if (glint_needs_rays(frame->view, draw->shading))
        glint_find_rays(frame, fragments);
    glint_find_surface(fragments, draw, glint_resolve_colour);
    glint_light_all(frame, fragments, draw->shading, draw->extra != 0);
}

const glint_evaluation glint_per_fragment = {GLINT_LIT_AT_FRAGMENTS, 0, glint_transform_normals, glint_draw_any,
                                             glint_draw_any,         0};
