/* SPDX-License-Identifier: MIT */
/*
 * Setup: attributes of a triangle as planes. A plane is one integer polynomial per triangle, anchored at its first
 * corner and evaluated modulo 2^32, so that a pixel gets the same value whatever tile it is drawn in.
 */
#include "setup.h"

/* Change of the two barycentric coordinates per pixel: value 2^-shift. */
typedef struct gradients {
    int32_t x1, y1, x2, y2;
    unsigned shift;
    int32_t to_center_x, to_center_y; /* from the first corner to the anchor's centre, in sixteenths */
} gradients;

static void gradients_begin(gradients *g, const glint_vertex *const v[3], int32_t area) {
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

/* Corner values are below 2^31 apart. Slivers have slopes above 2^31: those wrap, as their values do. */
static void plane_begin(glint_plane *p, const gradients *g, int32_t a0, int32_t a1, int32_t a2) {
    int64_t d1 = (int64_t)a1 - a0, d2 = (int64_t)a2 - a0;
    int64_t dx = glint_round_shift64(d1 * g->x1 + d2 * g->x2, g->shift);
    int64_t dy = glint_round_shift64(d1 * g->y1 + d2 * g->y2, g->shift);
    p->dx = (int32_t)(uint32_t)dx;
    p->dy = (int32_t)(uint32_t)dy;
    int64_t to_center = glint_shift_right64(dx * g->to_center_x + dy * g->to_center_y, 4);
    p->start = (int32_t)((uint32_t)a0 + (uint32_t)to_center);
}

/* 1/w of the corners, the largest in 2^30 .. 2^31; @return the shift that took. */
static unsigned scale_inverse_w(const glint_vertex *const v[3], uint32_t w[3]) {
    unsigned up =
        glint_leading_zeros((uint32_t)v[0]->inverse_w | (uint32_t)v[1]->inverse_w | (uint32_t)v[2]->inverse_w | 1) - 1;
    for (int i = 0; i < 3; i++)
        w[i] = (uint32_t)v[i]->inverse_w << up;
    return up;
}

/* An attribute of 16 bits over w: below 2^30. */
static int32_t over_w(int32_t attribute, uint32_t w) {
    return attribute * (int32_t)(w >> 16) + glint_shift_right(attribute * (int32_t)(w & 0xffff), 16);
}

/* Planes of three attributes of 16 bits over w; negated, normals are those of the back. */
static void triple(glint_plane planes[3], const gradients *g, const int16_t *const attribute[3], const uint32_t w[3],
                   int negated) {
    for (int c = 0; c < 3; c++) {
        int32_t scaled[3];
        for (int i = 0; i < 3; i++)
            scaled[i] = over_w(negated ? -attribute[i][c] : attribute[i][c], w[i]);
        plane_begin(&planes[c], g, scaled[0], scaled[1], scaled[2]);
    }
}

void glint_setup(glint_attributes *a, glint_fragments *fragments, const glint_draw *draw, const glint_triangle *t,
                 int32_t area, int back) {
    const glint_vertex *const *v = t->corners;
    const int16_t *const main[3] = {v[0]->attribute, v[1]->attribute, v[2]->attribute};
    gradients g;
    uint32_t w[3];
    gradients_begin(&g, v, area);
    a->anchor_x = glint_shift_right(v[0]->x, 4);
    a->anchor_y = glint_shift_right(v[0]->y, 4);
    plane_begin(&a->depth, &g, v[0]->inverse_w, v[1]->inverse_w, v[2]->inverse_w);
    a->has_main = draw->evaluation->planes != 0;
    a->has_extra = a->has_main && draw->extra && !draw->evaluation->lit;
    fragments->facet = t->facet;
    fragments->attributes = a;
    if (!a->has_main)
        return;
    const int lit = draw->evaluation->lit;
    fragments->scale = scale_inverse_w(v, w);
    triple(a->main, &g, lit && back && draw->double_sided ? t->extra : main, w, back && !lit);
    if (a->has_extra)
        triple(a->extra, &g, t->extra, w, 0);
}
