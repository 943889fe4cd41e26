/* SPDX-License-Identifier: MIT */
/* Lighting of fragments. */
#include "proof.h"

#include "../../src/per_fragment.c"
#include "lit.h"
#include "pixels.h"

/*
 * Fragments anywhere in any tile of any screen, planes of any slopes, rays where they are needed.
 * @contract glint_unit_inline glint_resolve_colour glint_light_all glint_needs_rays
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 9
 */
PROOF(per_fragment_shade) {
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
        FOR_PARTS(has_surface, 0, 1) {
            glint_fragments fragments;
            any_tile(&frame, &fragments, (uint32_t)count);
            fragments.attributes = &attributes;
            draw.extra = has_surface ? extra : 0;
            shade(&frame, &fragments, &draw);
        }
    }
}
