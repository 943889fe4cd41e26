/* SPDX-License-Identifier: MIT */
/* What all models and evaluations share. */
#include "proof.h"

#include "../../src/light/shade.c"
#include "lit.h"

/* What any model adds for a light. */
static void any_model_light(const glint_shading *shading, uint32_t light, const glint_view *view,
                            glint_fragments *fragments, int has_surface) {
    (void)shading;
    (void)light;
    (void)view;
    (void)has_surface;
    for (int i = 0; i < GLINT_FRAGMENTS_MAX; i++)
        for (int c = 0; c < 3; c++)
            fragments->colour[i][c] += ANY_UNSIGNED(0, 2 * LIGHT_MOST);
}

/*
 * Any fragments, lit by 8 lights or not at all, with colours of their own and without: colours stay below 2^32.
 * @contract glint_unit_inline
 * @unsigned
 * @options -eva-slevel 0 -eva-min-loop-unroll 9
 */
PROOF(glint_light_all) {
    static const glint_model lit = {0, any_model_light, 0}, unlit = {0, 0, 0};
    glint_view view;
    glint_material material;
    glint_shading shading;
    glint_fragments fragments;
    glint_frame frame;
    FOR_PARTS(kind, 0, 7) {
        any_lights(&view, &far_light);
        view.local_viewer = (uint8_t)(kind & 1);
        frame.view = &view;
        any_shading(&shading, &material);
        material.flags = kind & 2;
        any_fragments(&fragments, 16u << 23);
        material.model = &lit;
        glint_light_all(&frame, &fragments, &shading, kind >> 2);
        material.model = &unlit;
        glint_light_all(&frame, &fragments, &shading, kind >> 2);
    }
}

/* Any lights. */
PROOF(glint_needs_rays) {
    glint_view view;
    glint_material material;
    glint_shading shading;
    any_view(&view);
    any_shading(&shading, &material);
    glint_needs_rays(&view, &shading);
}

/* Any colour. */
PROOF(glint_clamp_colour) {
    const uint32_t colour[3] = {ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX)};
    int16_t out[3];
    glint_clamp_colour(colour, out);
    /*@ assert \subset(out[0 .. 2], (0 .. 32767)); */
}

/* Any colour. @unsigned */
PROOF(glint_channels_of) {
    const uint32_t colour[3] = {ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX)};
    int32_t channel[3];
    glint_channels_of(colour, channel);
    /*@ assert \subset(channel[0 .. 2], (0 .. CHANNEL_MOST)); */
}
