/* SPDX-License-Identifier: MIT */
/* Lighting at every fragment, with the normal interpolated and made unit (Phong, 1975). */
#include "colour.h"
#include "setup.h"

/* Against the ray through the pixel's centre, in half pixels, Q12. */
static void find_rays(const glint_frame *frame, glint_fragments *fragments) {
    uint32_t mask = (uint32_t)frame->config.tile_width - 1;
    for (uint32_t i = 0; i < fragments->count; i++) {
        int32_t x = fragments->tile_x + (int32_t)(fragments->offset[i] & mask);
        int32_t y = fragments->tile_y + (fragments->offset[i] >> frame->tile_shift_x);
        fragments->ray[i][0] = (frame->config.width - 1 - 2 * x) * 4096;
        fragments->ray[i][1] = (2 * y + 1 - frame->config.height) * 4096;
        fragments->ray[i][2] = frame->view->focal;
    }
}

/* Unit normals, and the surface's own colours. */
static void find_surface(const glint_frame *frame, glint_fragments *fragments, const glint_draw *draw) {
    const glint_attributes *a = fragments->attributes;
    for (uint32_t i = 0; i < fragments->count; i++) {
        int32_t x, y;
        glint_fragment_place(frame, fragments, i, &x, &y);
        glint_unit_each(glint_plane_at(&a->main[0], x, y), glint_plane_at(&a->main[1], x, y),
                        glint_plane_at(&a->main[2], x, y), fragments->normal[i]);
        if (draw->extra)
            glint_resolve_colour(frame, fragments, i, a->extra, fragments->surface[i]);
    }
}

static void shade(const glint_frame *frame, glint_fragments *fragments, const glint_draw *draw) {
    if (glint_needs_rays(frame->view, draw->shading))
        find_rays(frame, fragments);
    find_surface(frame, fragments, draw);
    glint_light_all(frame, fragments, draw->shading, draw->extra != 0);
}

const glint_evaluation glint_per_fragment = {3, 0, 0, 0, shade};
