/* SPDX-License-Identifier: MIT */
/* What all models and evaluations share. */
#include "proof.h"

#include "../../src/shade.c"
#include "lit.h"

/* What any model adds for a light, and what any format does. */
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

static void any_store(void *pixels, const glint_fragments *fragments, unsigned tile_shift_x) {
    (void)pixels;
    (void)fragments;
    (void)tile_shift_x;
}

static void any_shade(const glint_frame *frame, glint_fragments *fragments, const glint_draw *draw) {
    (void)frame;
    (void)draw;
    any_fragments(fragments, UINT_MAX);
}

/*@ requires count <= 8;
    requires \initialized(&colour[0 .. count - 1][0 .. 2]);
    assigns colour[0 .. count - 1][0 .. 2] \from gamma, count, colour[0 .. count - 1][0 .. 2]; */
void glint_apply_gamma(const uint16_t (*gamma)[GLINT_GAMMA_ENTRIES], uint32_t (*colour)[3], uint32_t count);

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

/* Any fragments, with output tables and without. @contract glint_apply_gamma */
PROOF(glint_shade) {
    static const uint16_t gamma[3][GLINT_GAMMA_ENTRIES];
    static const glint_evaluation evaluation = {0, 0, 0, 0, any_shade};
    static const glint_format format = {16, any_store, 0, 0};
    glint_fragments fragments;
    glint_workspace workspace;
    glint_frame frame;
    glint_draw draw;
    draw.evaluation = &evaluation;
    frame.config.format = &format;
    frame.config.gamma = ANY(0, 1) ? gamma : 0;
    frame.tile_shift_x = (uint8_t)ANY(3, 6);
    workspace.fragments = &fragments;
    workspace.pixels = 0;
    glint_shade(&frame, &workspace, &draw);
}
