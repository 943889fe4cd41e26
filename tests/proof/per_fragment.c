/* SPDX-License-Identifier: MIT */
/* Lighting of fragments. */
#include "proof.h"

#include "../../src/light/per_fragment.c"
#include "lit.h"
#include "pixels.h"

static void any_place_of_rays(const glint_frame *frame, glint_fragments *fragments) {
    (void)frame, (void)fragments;
}

/*
 * Fragments anywhere on any screen, planes of any slopes, rays where they are needed.
 * @contract glint_unit_inline glint_resolve_colour glint_light_all glint_needs_rays
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 9
 */
PROOF(glint_shade) {
    static int16_t extra[1][3];
    static const glint_projection projection = {0, 0, 0, 0, any_place_of_rays, 0};
    static const glint_scene scene = {.camera = {.projection = &projection}};
    glint_frame frame;
    glint_view view;
    glint_material material;
    glint_shading shading;
    glint_attributes attributes;
    glint_draw draw;
    glint_part part;
    any_lights(&view, &near_light);
    any_shading(&shading, &material);
    view.is_parallel = (uint8_t)ANY(0, 1);
    frame.view = &view;
    frame.scene = &scene;
    draw.shading = &shading;
    any_planes(&attributes);
    FOR_PARTS(count, 1, GLINT_FRAGMENTS_MAX) {
        FOR_PARTS(has_extra, 0, 1) {
            glint_fragments fragments;
            any_run(&frame, &fragments, &part, (uint32_t)count);
            fragments.attributes = &attributes;
            draw.extra = has_extra ? extra : 0;
            glint_shade(&frame, &fragments, &draw);
        }
    }
}
