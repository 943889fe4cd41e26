/* SPDX-License-Identifier: MIT */
/* Shade: colours of a few fragments of one triangle, of vertices or of a triangle's middle. */
#include "shade.h"

int glint_needs_rays(const glint_view *view, const glint_shading *shading) {
    return view->has_positions || (view->local_viewer && shading->has_specular);
}

void glint_find_view_vectors(const glint_view *view, glint_fragments *fragments) {
    if (view->local_viewer) {
        for (uint32_t i = 0; i < fragments->count; i++)
            glint_unit_each(fragments->ray[i][0], fragments->ray[i][1], fragments->ray[i][2], fragments->view[i]);
        return;
    }
    for (uint32_t i = 0; i < fragments->count; i++)
        fragments->view[i][0] = 0, fragments->view[i][1] = 0, fragments->view[i][2] = GLINT_UNIT;
}

static void set_colours(glint_fragments *fragments, const uint32_t colour[3]) {
    for (uint32_t i = 0; i < fragments->count; i++)
        for (int c = 0; c < 3; c++)
            fragments->colour[i][c] = colour[c];
}

/* The larger of each colour and its ambient light: what is 0 becomes ambient light. */
static void raise_to_ambient(const glint_shading *shading, glint_fragments *fragments, int has_surface) {
    int16_t(*surface)[3] = fragments->surface;
    uint32_t(*colour)[3] = fragments->colour;
    for (uint32_t i = 0; i < fragments->count; i++, surface++, colour++) {
        for (int c = 0; c < 3; c++) {
            uint32_t ambient = shading->ambient[c];
            if (has_surface)
                ambient = (uint32_t)((uint64_t)ambient * ((uint32_t)(*surface)[c] + 1) >> 15);
            (*colour)[c] = (*colour)[c] < ambient ? ambient : (*colour)[c];
        }
    }
}

void glint_light_all(const glint_frame *frame, glint_fragments *fragments, const glint_shading *shading,
                     int has_surface) {
    const glint_model *model = shading->material->model;
    const uint32_t lights = shading->lights & ~fragments->away;
    const uint32_t takes_largest = model->light ? shading->material->flags & GLINT_MATERIAL_MAX : 0;
    static const uint32_t black[3] = {0, 0, 0};
    set_colours(fragments, takes_largest || has_surface ? black : shading->ambient);
    if (has_surface && !takes_largest)
        raise_to_ambient(shading, fragments, has_surface);
    if (!model->light)
        return;
    if (shading->has_specular & lights)
        glint_find_view_vectors(frame->view, fragments);
    for (uint32_t light = 0; light < frame->view->light_count; light++)
        if (lights >> light & 1)
            model->light(shading, light, frame->view, fragments, has_surface);
    if (takes_largest)
        raise_to_ambient(shading, fragments, has_surface);
}

void glint_clamp_colour(const uint32_t colour[3], int16_t out[3]) {
    for (int c = 0; c < 3; c++)
        out[c] = (int16_t)(colour[c] < (1u << 23) - 256 ? (colour[c] + 128) >> 8 : GLINT_COLOUR_ONE);
}
