/* SPDX-License-Identifier: MIT */
/*
 * Setup: attributes of a triangle as planes. A plane is one integer polynomial per triangle, anchored at its first
 * corner and evaluated modulo 2^32, so that a pixel gets the same value whatever tile it is drawn in.
 */
#include "setup.h"

static void gradients_begin(glint_gradients *g, const glint_vertex *const v[3], int32_t area) {
    unsigned zeros = glint_leading_zeros((uint32_t)area);
    int64_t reciprocal = glint_reciprocal((uint32_t)area << zeros); /* 1 / area is this times 2^(zeros - 63) */
    g->x1 = (int32_t)glint_shift_right64((v[2]->y - v[0]->y) * reciprocal, 17);
    g->y1 = (int32_t)glint_shift_right64((v[0]->x - v[2]->x) * reciprocal, 17);
    g->x2 = (int32_t)glint_shift_right64((v[0]->y - v[1]->y) * reciprocal, 17);
    g->y2 = (int32_t)glint_shift_right64((v[1]->x - v[0]->x) * reciprocal, 17);
    g->shift = 42 - zeros; /* 63 - 17, less 4 for sixteenths of a pixel */
    g->to_center_x = 8 - (v[0]->x & 15);
    g->to_center_y = 8 - (v[0]->y & 15);
}

void glint_plane_begin(glint_plane *p, const glint_gradients *g, int32_t a0, int32_t a1, int32_t a2) {
    int64_t d1 = (int64_t)a1 - a0, d2 = (int64_t)a2 - a0;
    int64_t dx = glint_round_shift64(d1 * g->x1 + d2 * g->x2, g->shift);
    int64_t dy = glint_round_shift64(d1 * g->y1 + d2 * g->y2, g->shift);
    p->dx = (int32_t)(uint32_t)dx;
    p->dy = (int32_t)(uint32_t)dy;
    int64_t to_center = glint_shift_right64(dx * g->to_center_x + dy * g->to_center_y, 4);
    p->start = (int32_t)((uint32_t)a0 + (uint32_t)to_center);
}

void glint_setup(glint_part *part, const glint_triangle *t) {
    const glint_vertex *const *v = t->corners;
    gradients_begin(&part->gradients, v, t->area);
    glint_plane_begin(&part->depth, &part->gradients, v[0]->inverse_w, v[1]->inverse_w, v[2]->inverse_w);
}
