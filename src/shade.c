/* SPDX-License-Identifier: MIT */
/* Shade: colours of a few fragments of one triangle, light by light, then into the tile's pixels. */
#include "frame.h"

/* V points from the fragment to the eye: against the ray through the pixel's centre, in half pixels, Q12. */
static void find_view_vectors(const glint_frame *frame, glint_fragments *fragments) {
    uint32_t mask = (uint32_t)frame->config.tile_width - 1;
    for (uint32_t i = 0; i < fragments->count; i++) {
        int32_t x = fragments->tile_x + (int32_t)(fragments->offset[i] & mask);
        int32_t y = fragments->tile_y + (fragments->offset[i] >> frame->tile_shift_x);
        glint_unit((frame->config.width - 1 - 2 * x) * 4096, (2 * y + 1 - frame->config.height) * 4096,
                   frame->view->focal, fragments->view[i]);
    }
}

void glint_shade(const glint_frame *frame, glint_workspace *workspace, const glint_shading *shading) {
    glint_fragments *fragments = workspace->fragments;
    if (frame->view->local_viewer && shading->has_specular)
        find_view_vectors(frame, fragments);
    for (uint32_t i = 0; i < fragments->count; i++)
        for (int c = 0; c < 3; c++)
            fragments->colour[i][c] = shading->ambient[c];
    for (uint32_t light = 0; light < frame->view->light_count; light++)
        shading->material->model->light(shading, light, frame->view, fragments);
    frame->config.format->store(workspace->pixels, fragments->offset, fragments->colour, fragments->count);
    fragments->count = 0;
}
