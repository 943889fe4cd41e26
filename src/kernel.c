/* SPDX-License-Identifier: MIT */
/* Kernel: from the spans of a triangle to pixels: the one for everything. */
#include "setup.h"

/* 1/w of the corners, none 0, the largest in 2^30 .. 2^31; @return the shift that took. */
static unsigned scale_inverse_w(const glint_vertex *const v[3], uint32_t w[3]) {
    unsigned up =
        glint_leading_zeros((uint32_t)v[0]->inverse_w | (uint32_t)v[1]->inverse_w | (uint32_t)v[2]->inverse_w) - 1;
    for (int i = 0; i < 3; i++)
        w[i] = (uint32_t)v[i]->inverse_w << up;
    return up;
}

/* An attribute of 16 bits over w: below 2^30. */
static int32_t over_w(int32_t attribute, uint32_t w) {
    return attribute * (int32_t)(w >> 16) + glint_shift_right(attribute * (int32_t)(w & 0xffff), 16);
}

/* Planes of three attributes of 16 bits over w; negated, normals are those of the back. */
static void triple(glint_plane planes[3], const glint_gradients *g, const int16_t *const attribute[3],
                   const uint32_t w[3], int negated) {
    for (int c = 0; c < 3; c++) {
        int32_t scaled[3];
        for (int i = 0; i < 3; i++)
            scaled[i] = over_w(negated ? -attribute[i][c] : attribute[i][c], w[i]);
        glint_plane_begin(&planes[c], g, scaled[0], scaled[1], scaled[2]);
    }
}

/* Attributes for the draw's evaluation, and what the triangle's fragments have in common. */
static void begin(glint_attributes *a, glint_fragments *fragments, const glint_draw *draw, const glint_triangle *t,
                  const glint_part *part) {
    const glint_vertex *const *v = t->corners;
    const int16_t *const main[3] = {v[0]->attribute, v[1]->attribute, v[2]->attribute};
    const int lit = draw->evaluation->lit;
    uint32_t w[3];
    a->x = part->x;
    a->y = part->y;
    fragments->facet = t->facet;
    fragments->attributes = a;
    if (!draw->evaluation->planes)
        return;
    fragments->scale = scale_inverse_w(v, w);
    triple(a->main, &part->gradients, lit && t->back && draw->double_sided ? t->extra : main, w, t->back && !lit);
    if (draw->extra && !lit)
        triple(a->extra, &part->gradients, t->extra, w, 0);
}

/* The farthest surfaces still count as nearer than nothing: depth 1. */
static int32_t depth_of(int32_t inverse_w) {
    return glint_shift_right(inverse_w, 15) + 1;
}

/* Gathers the fragments from `offset` to before `end`, and shades them whenever there are enough. */
static void gather(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw, uint32_t offset,
                   uint32_t end, int32_t inverse_w, int32_t slope) {
    glint_fragments *fragments = workspace->fragments;
    for (; offset < end; offset++) {
        const int32_t here = glint_most(inverse_w, 0); /* rounding may take the plane of a deep triangle below */
        int32_t depth = depth_of(here);
        if (depth > workspace->depth[offset]) {
            workspace->depth[offset] = (uint16_t)depth;
            uint32_t i = fragments->count++;
            fragments->offset[i] = (uint16_t)offset;
            fragments->inverse_w[i] = here;
            if (i == GLINT_FRAGMENTS_MAX - 1)
                glint_shade(frame, workspace, draw);
        }
        inverse_w = glint_add_wrap(inverse_w, slope);
    }
}

void glint_draw_any(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                    const glint_triangle *triangle, const glint_part *part) {
    glint_attributes attributes;
    begin(&attributes, workspace->fragments, draw, triangle, part);
    uint32_t covered = 0;
    for (uint32_t row = part->top; row < part->bottom; row++) {
        const glint_span span = part->spans[row];
        const uint32_t first = row << frame->tile_shift_x;
        covered += (uint32_t)span.right - span.left;
        gather(frame, workspace, draw, first + span.left, first + span.right,
               glint_plane_at(&part->depth, part->x + span.left, part->y + (int32_t)row), part->depth.dx);
    }
    if (workspace->fragments->count)
        glint_shade(frame, workspace, draw);
    glint_count(workspace, GLINT_KERNEL_GENERAL, covered);
}
