/* SPDX-License-Identifier: MIT */
/* Flat: triangles that a format does not draw whole, span by span. */
#include "../raster/depth.h"
#include "format.h"

/* Draws one colour where rounding may take the plane of 1/w out of its range: below the least step it counts as that.
 */
static void draw_deep(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    uint32_t z = glint_z_at(walk, row, left), pixel = ((uint32_t)row << walk->shift) + (uint32_t)left;
    for (const uint32_t end = pixel + (uint32_t)(right - left); pixel < end; pixel++, z += (uint32_t)walk->z.dx)
        if (glint_is_nearest((uint8_t *)&walk->depth[pixel], (uint32_t)glint_most((int32_t)z, GLINT_DEPTH_BIAS)))
            walk->frame->config.format->put(walk, pixel, walk->lanes[0]);
}

static void begin_spans(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    glint_begin_depth(walk);
    walk->draw_span = walk->is_deep ? draw_deep : walk->frame->config.format->flat_span;
    walk->draw_span(walk, row, left, right);
}

void glint_walk_flat(glint_row_walk *walk, glint_begun begun) {
    walk->draw_span = begin_spans;
    glint_walk_begun(walk, begun);
}

void glint_draw_flat(glint_row_walk *walk) {
    glint_walk_flat(walk, glint_begin_triangle(walk));
}

void glint_draw_smooth_rows(glint_row_walk *walk, glint_begin_colours *begin) {
    if (!glint_find_visible_row(walk))
        return;
    if (begin(walk))
        walk->draw_span = walk->frame->config.format->smooth;
    glint_walk_small(walk);
}
