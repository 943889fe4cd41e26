/* SPDX-License-Identifier: MIT */
/*
 * Raster: the part of a triangle that lies in one tile, as rows of fragments that pass the depth test.
 *
 * Coverage is exact. An edge is walked with an integer quotient and remainder, so that a pixel is inside exactly
 * when its centre is, and left and right edges round alike: a shared edge gives each pixel to one side.
 * Attributes are planes: one integer polynomial per triangle, anchored at its first corner and evaluated modulo 2^32,
 * so that a pixel gets the same value whatever tile it is drawn in.
 */
#include "frame.h"

/* A linear function of the pixel: value at the anchor, change per pixel in x and y. */
typedef struct plane {
    int32_t start, dx, dy;
} plane;

/* Depth, and the normal over w. */
typedef struct attributes {
    plane depth, normal[3];
    int32_t anchor_x, anchor_y; /* pixel */
} attributes;

/* Change of the two barycentric coordinates per pixel: value 2^-shift. */
typedef struct gradients {
    int32_t x1, y1, x2, y2;
    unsigned shift;
    int32_t to_center_x, to_center_y; /* from the first corner to the anchor's centre, in sixteenths */
} gradients;

/* Pixel columns where an edge crosses the centres of successive rows: ceil of the exact crossing. */
typedef struct edge {
    int32_t x, remainder, x_step, remainder_step, divisor;
} edge;

/* floor(a / b), b above 0 */
static int32_t divide_floor(int32_t a, int32_t b, int32_t *remainder) {
    int32_t quotient = a / b;
    int32_t rest = a - quotient * b;
    if (rest < 0) {
        quotient--;
        rest += b;
    }
    *remainder = rest;
    return quotient;
}

/* An edge from `top` down to `bottom`, at pixel row `row`. Numerators stay below 2^31: |dx|, dy < 2^15, |x| < 2^15. */
static void edge_begin(edge *e, const glint_vertex *top, const glint_vertex *bottom, int32_t row) {
    int32_t dx = bottom->x - top->x, dy = bottom->y - top->y, rest;
    int32_t down = 16 * row + 8 - top->y;
    e->divisor = 16 * dy;
    e->x = divide_floor((top->x - 8) * dy + down * dx + e->divisor - 1, e->divisor, &e->remainder);
    e->x_step = divide_floor(dx, dy, &rest);
    e->remainder_step = 16 * rest;
}

static void edge_step(edge *e) {
    e->x += e->x_step;
    e->remainder += e->remainder_step;
    if (e->remainder >= e->divisor) {
        e->remainder -= e->divisor;
        e->x++;
    }
}

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
static void plane_begin(plane *p, const gradients *g, int32_t a0, int32_t a1, int32_t a2) {
    int64_t d1 = (int64_t)a1 - a0, d2 = (int64_t)a2 - a0;
    int64_t dx = glint_round_shift64(d1 * g->x1 + d2 * g->x2, g->shift);
    int64_t dy = glint_round_shift64(d1 * g->y1 + d2 * g->y2, g->shift);
    p->dx = (int32_t)(uint32_t)dx;
    p->dy = (int32_t)(uint32_t)dy;
    int64_t to_center = glint_shift_right64(dx * g->to_center_x + dy * g->to_center_y, 4);
    p->start = (int32_t)((uint32_t)a0 + (uint32_t)to_center);
}

static int32_t plane_at(const plane *p, int32_t x, int32_t y) {
    return glint_add_wrap(p->start, glint_add_wrap(glint_multiply_wrap(p->dx, x), glint_multiply_wrap(p->dy, y)));
}

/* Normal over w, scaled so that the nearest corner's is in 30 bits; turned where the back is seen. */
static void normal_planes(attributes *a, const gradients *g, const glint_vertex *const v[3], int back) {
    int32_t scaled[3][3];
    unsigned zeros = glint_leading_zeros((uint32_t)(v[0]->inverse_w | v[1]->inverse_w | v[2]->inverse_w));
    for (int i = 0; i < 3; i++) {
        uint32_t w = (uint32_t)v[i]->inverse_w << (zeros - 1); /* the largest in 2^30 .. 2^31 */
        int32_t high = (int32_t)(w >> 16), low = (int32_t)(w & 0xffff);
        for (int j = 0; j < 3; j++) {
            int32_t n = back ? -v[i]->normal[j] : v[i]->normal[j];
            scaled[i][j] = n * high + glint_shift_right(n * low, 16);
        }
    }
    for (int j = 0; j < 3; j++)
        plane_begin(&a->normal[j], g, scaled[0][j], scaled[1][j], scaled[2][j]);
}

/* The farthest surfaces still count as nearer than nothing. */
static int32_t depth_of(const glint_vertex *v) {
    return v->inverse_w < 1 << 15 ? 1 << 15 : v->inverse_w;
}

static void attributes_begin(attributes *a, const glint_vertex *const v[3], int32_t area, int back) {
    gradients g;
    gradients_begin(&g, v, area);
    a->anchor_x = glint_shift_right(v[0]->x, 4);
    a->anchor_y = glint_shift_right(v[0]->y, 4);
    plane_begin(&a->depth, &g, depth_of(v[0]), depth_of(v[1]), depth_of(v[2]));
    normal_planes(a, &g, v, back);
}

/* Fragments of one row, from column `left` to before `right`; tile coordinates in `fragments`. */
static void row(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw, const attributes *a,
                int32_t left, int32_t right, int32_t y) {
    glint_fragments *fragments = workspace->fragments;
    int32_t depth = plane_at(&a->depth, left - a->anchor_x, y - a->anchor_y);
    int32_t n[3];
    for (int i = 0; i < 3; i++)
        n[i] = plane_at(&a->normal[i], left - a->anchor_x, y - a->anchor_y);
    uint32_t offset = ((uint32_t)(y - fragments->tile_y) << frame->tile_shift_x) + (uint32_t)(left - fragments->tile_x);
    for (; left < right; left++, offset++) {
        int32_t here = glint_shift_right(depth, 15);
        if (here > workspace->depth[offset]) {
            workspace->depth[offset] = (uint16_t)here;
            uint32_t i = fragments->count++;
            fragments->offset[i] = (uint16_t)offset;
            glint_unit(n[0], n[1], n[2], fragments->normal[i]);
            if (i == GLINT_FRAGMENTS_MAX - 1)
                glint_shade(frame, workspace, draw->shading);
        }
        depth = glint_add_wrap(depth, a->depth.dx);
        n[0] = glint_add_wrap(n[0], a->normal[0].dx);
        n[1] = glint_add_wrap(n[1], a->normal[1].dx);
        n[2] = glint_add_wrap(n[2], a->normal[2].dx);
    }
}

/* Rows from `top` to before `bottom` between two edges. */
static void rows(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw, const attributes *a,
                 const glint_range *tile, const glint_vertex *const sides[4], int32_t top, int32_t bottom) {
    edge left, right;
    edge_begin(&left, sides[0], sides[1], top);
    edge_begin(&right, sides[2], sides[3], top);
    for (int32_t y = top; y < bottom; y++) {
        int32_t from = left.x < tile->left ? tile->left : left.x;
        int32_t to = right.x > tile->right ? tile->right : right.x;
        if (from < to)
            row(frame, workspace, draw, a, from, to, y);
        edge_step(&left);
        edge_step(&right);
    }
}

/* First pixel row whose centre is not above y; the last one is before that of the lower end. */
static int32_t first_row(const glint_vertex *v) {
    return glint_shift_right(v->y + 7, 4);
}

static void swap(const glint_vertex **a, const glint_vertex **b) {
    const glint_vertex *t = *a;
    *a = *b;
    *b = t;
}

void glint_raster(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                  const glint_vertex *const corners[3]) {
    const glint_fragments *fragments = workspace->fragments;
    const glint_range tile = {fragments->tile_x, fragments->tile_y, fragments->tile_x + fragments->tile_width,
                              fragments->tile_y + fragments->tile_height};
    const glint_vertex *v[3] = {corners[0], corners[1], corners[2]};
    int32_t area = glint_double_area(v[0], v[1], v[2]);
    int back = (area > 0) != draw->mirrored;
    if (area < 0) {
        swap(&v[1], &v[2]);
        area = -area;
    }
    attributes a;
    attributes_begin(&a, v, area, back);
    const glint_vertex *top = v[0], *middle = v[1], *bottom = v[2];
    if (middle->y < top->y)
        swap(&top, &middle);
    if (bottom->y < middle->y)
        swap(&middle, &bottom);
    if (middle->y < top->y)
        swap(&top, &middle);
    /* y runs down, so the middle corner lies right of the long edge where this area is above 0. */
    int long_is_left = glint_double_area(top, middle, bottom) > 0;
    int32_t first = first_row(top), turn = first_row(middle), end = first_row(bottom);
    first = first < tile.top ? tile.top : first;
    end = end > tile.bottom ? tile.bottom : end;
    const glint_vertex *const upper[6] = {top, middle, top, bottom, top, middle};
    const glint_vertex *const lower[6] = {middle, bottom, top, bottom, middle, bottom};
    if (first < turn)
        rows(frame, workspace, draw, &a, &tile, upper + (long_is_left ? 2 : 0), first, turn < end ? turn : end);
    first = first < turn ? turn : first;
    if (first < end)
        rows(frame, workspace, draw, &a, &tile, lower + (long_is_left ? 2 : 0), first, end);
    if (workspace->fragments->count)
        glint_shade(frame, workspace, draw->shading);
}
