/* SPDX-License-Identifier: MIT */
/* Lighting at every fragment, with the normal interpolated and made unit (Phong, 1975). */
#include "colour.h"
#include "setup.h"

/* In half pixels, Q12; the window is in sixteenths. */
void glint_find_rays(const glint_frame *frame, glint_fragments *fragments) {
    const glint_window *window = &fragments->part->window;
    const int32_t x = frame->config.width * 4096 - window->left * 512;
    const int32_t y = window->top * 512 - frame->config.height * 4096;
    for (uint32_t i = 0; i < fragments->count; i++) {
        fragments->ray[i][0] = x - fragments->column[i] * 8192;
        fragments->ray[i][1] = y + fragments->row[i] * 8192;
        fragments->ray[i][2] = frame->view->focal;
    }
}

void glint_find_surface(glint_fragments *fragments, const glint_draw *draw, glint_resolver *resolve) {
    const glint_attributes *a = fragments->attributes;
    for (uint32_t i = 0; i < fragments->count; i++) {
        const int32_t x = fragments->part->x + fragments->column[i], y = fragments->part->y + fragments->row[i];
        glint_unit_each(glint_plane_at(&a->main[0], x, y), glint_plane_at(&a->main[1], x, y),
                        glint_plane_at(&a->main[2], x, y), fragments->normal[i]);
        if (draw->extra)
            resolve(fragments, i, a->extra, fragments->surface[i]);
    }
}

void glint_shade(const glint_frame *frame, glint_fragments *fragments, const glint_draw *draw) {
    if (glint_needs_rays(frame->view, draw->shading))
        glint_find_rays(frame, fragments);
    glint_find_surface(fragments, draw, glint_resolve_colour);
    glint_light_all(frame, fragments, draw->shading, draw->extra != 0);
}

const glint_evaluation glint_per_fragment = {GLINT_LIT_AT_FRAGMENTS, glint_transform_normals, glint_draw_any};
