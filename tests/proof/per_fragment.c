/* SPDX-License-Identifier: MIT */
/* Lighting of fragments. */
#include "proof.h"

#include "../../src/per_fragment.c"
#include "lit.h"
#include "pixels.h"

/*
 * Fragments anywhere on any screen, planes of any slopes, rays where they are needed; and what is known of vertices.
 * @contract glint_unit_inline glint_resolve_colour glint_light_all glint_needs_rays
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 9
 */
PROOF(glint_shade) {
    static const glint_evaluation at_vertices = {.lit_at = GLINT_LIT_AT_VERTICES};
    static int16_t extra[1][3];
    glint_frame frame;
    glint_view view;
    glint_material material;
    glint_shading shading;
    glint_attributes attributes;
    glint_draw draw;
    any_lights(&view, &near_light);
    any_shading(&shading, &material);
    frame.view = &view;
    draw.shading = &shading;
    any_planes(&attributes);
    FOR_PARTS(count, 1, GLINT_FRAGMENTS_MAX) {
        FOR_PARTS(kind, 0, 2) {
            glint_fragments fragments;
            any_run(&frame, &fragments, (uint32_t)count);
            fragments.attributes = &attributes;
            draw.evaluation = kind == 2 ? &at_vertices : &glint_per_fragment;
            draw.extra = kind == 1 ? extra : 0;
            glint_shade(&frame, &fragments, &draw);
        }
    }
}
