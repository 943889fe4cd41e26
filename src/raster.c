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

/* Depth, and up to two triples: a normal over w or a lit colour, and the surface's own colour. */
typedef struct attributes {
    plane depth, main[3], extra[3];
    uint8_t has_main, has_extra;
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

/* Normals over w, turned where the back is seen. */
static void normal_planes(plane planes[3], const gradients *g, const int16_t *const n[3], const uint32_t w[3],
                          int back) {
    for (int c = 0; c < 3; c++) {
        int32_t scaled[3];
        for (int i = 0; i < 3; i++)
            scaled[i] = over_w(back ? -n[i][c] : n[i][c], w[i]);
        plane_begin(&planes[c], g, scaled[0], scaled[1], scaled[2]);
    }
}

/*
 * Is a colour's plane on the screen within 1/4 of an 8-bit step of the right one? Where w changes by a factor r, the
 * two are at most a quarter of (r - 1) of the colour's change apart (the largest of x - x / (r - (r - 1) x), to first
 * order).
 */
static int is_linear(const int16_t *const colour[3], const uint32_t w[3]) {
    uint32_t most = w[0] > w[1] ? w[0] : w[1], least = w[0] < w[1] ? w[0] : w[1];
    most = (most > w[2] ? most : w[2]) >> 16;
    least = (least < w[2] ? least : w[2]) >> 16;
    for (int c = 0; c < 3; c++) {
        int32_t a = colour[0][c], b = colour[1][c], d = colour[2][c];
        int32_t top = a > b ? a : b, low = a < b ? a : b;
        int32_t change = (top > d ? top : d) - (low < d ? low : d);
        if ((uint32_t)change * (most - least) > 128 * least)
            return 0;
    }
    return 1;
}

static void colour_planes(plane planes[3], const gradients *g, const int16_t *const colour[3], const uint32_t w[3],
                          int perspective) {
    for (int c = 0; c < 3; c++) {
        int32_t scaled[3];
        for (int i = 0; i < 3; i++)
            scaled[i] = perspective ? over_w(colour[i][c], w[i]) : colour[i][c] * (1 << 15);
        plane_begin(&planes[c], g, scaled[0], scaled[1], scaled[2]);
    }
}

/* The farthest surfaces still count as nearer than nothing: depth 1. */
static int32_t depth_of(int32_t inverse_w) {
    return glint_shift_right(inverse_w, 15) + 1;
}

static void attributes_begin(attributes *a, glint_fragments *fragments, const glint_draw *draw, const glint_triangle *t,
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
    if (!a->has_main)
        return;
    const unsigned up = scale_inverse_w(v, w);
    if (draw->evaluation->lit) {
        const int16_t *const *colour = back && draw->double_sided ? t->extra : main;
        fragments->perspective = is_linear(colour, w) ? 0 : up + 1;
        colour_planes(a->main, &g, colour, w, fragments->perspective != 0);
    } else {
        normal_planes(a->main, &g, main, w, back);
    }
    if (a->has_extra) {
        fragments->perspective = is_linear(t->extra, w) ? 0 : up + 1;
        colour_planes(a->extra, &g, t->extra, w, fragments->perspective != 0);
    }
}

static void planes_at(const plane planes[3], int32_t x, int32_t y, int32_t value[3]) {
    for (int c = 0; c < 3; c++)
        value[c] = plane_at(&planes[c], x, y);
}

static void step(const plane planes[3], int32_t value[3]) {
    value[0] = glint_add_wrap(value[0], planes[0].dx);
    value[1] = glint_add_wrap(value[1], planes[1].dx);
    value[2] = glint_add_wrap(value[2], planes[2].dx);
}

static void copy(int32_t to[3], const int32_t from[3]) {
    to[0] = from[0];
    to[1] = from[1];
    to[2] = from[2];
}

/* Fragments of one row, from column `left` to before `right`. */
static void row(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw, const attributes *a,
                int32_t left, int32_t right, int32_t y) {
    glint_fragments *fragments = workspace->fragments;
    const int32_t from_x = left - a->anchor_x, from_y = y - a->anchor_y;
    int32_t inverse_w = plane_at(&a->depth, from_x, from_y), main[3], extra[3];
    if (a->has_main)
        planes_at(a->main, from_x, from_y, main);
    if (a->has_extra)
        planes_at(a->extra, from_x, from_y, extra);
    uint32_t offset = ((uint32_t)(y - fragments->tile_y) << frame->tile_shift_x) + (uint32_t)(left - fragments->tile_x);
    for (; left < right; left++, offset++) {
        int32_t depth = depth_of(inverse_w);
        if (depth > workspace->depth[offset]) {
            workspace->depth[offset] = (uint16_t)depth;
            uint32_t i = fragments->count++;
            fragments->offset[i] = (uint16_t)offset;
            fragments->inverse_w[i] = inverse_w;
            if (a->has_main)
                copy(fragments->attribute[i], main);
            if (a->has_extra)
                copy(fragments->extra[i], extra);
            if (i == GLINT_FRAGMENTS_MAX - 1)
                glint_shade(frame, workspace, draw);
        }
        inverse_w = glint_add_wrap(inverse_w, a->depth.dx);
        if (a->has_main)
            step(a->main, main);
        if (a->has_extra)
            step(a->extra, extra);
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

/* The triangle's rows in the tile: its upper part to the middle corner, then the lower. */
static void walk(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw, const attributes *a,
                 const glint_vertex *const corners[3]) {
    const glint_fragments *fragments = workspace->fragments;
    const glint_range tile = {fragments->tile_x, fragments->tile_y, fragments->tile_x + fragments->tile_width,
                              fragments->tile_y + fragments->tile_height};
    const glint_vertex *top = corners[0], *middle = corners[1], *bottom = corners[2];
    if (middle->y < top->y)
        swap(&top, &middle);
    if (bottom->y < middle->y)
        swap(&middle, &bottom);
    if (middle->y < top->y)
        swap(&top, &middle);
    /* y runs down, so the middle corner lies right of the long edge where this area is above 0. */
    const int first_side = glint_double_area(top, middle, bottom) > 0 ? 2 : 0;
    int32_t first = first_row(top), turn = first_row(middle), end = first_row(bottom);
    first = first < tile.top ? tile.top : first;
    end = end > tile.bottom ? tile.bottom : end;
    const glint_vertex *const upper[6] = {top, middle, top, bottom, top, middle};
    const glint_vertex *const lower[6] = {middle, bottom, top, bottom, middle, bottom};
    if (first < turn)
        rows(frame, workspace, draw, a, &tile, upper + first_side, first, turn < end ? turn : end);
    first = first < turn ? turn : first;
    if (first < end)
        rows(frame, workspace, draw, a, &tile, lower + first_side, first, end);
}

void glint_raster(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                  const glint_triangle *triangle) {
    glint_triangle t = *triangle;
    int32_t area = glint_double_area(t.corners[0], t.corners[1], t.corners[2]);
    const int back = (area > 0) != draw->mirrored;
    if (area < 0) {
        const int16_t *extra = t.extra[1];
        swap(&t.corners[1], &t.corners[2]);
        t.extra[1] = t.extra[2];
        t.extra[2] = extra;
        area = -area;
    }
    attributes a;
    attributes_begin(&a, workspace->fragments, draw, &t, area, back);
    walk(frame, workspace, draw, &a, t.corners);
    if (workspace->fragments->count)
        glint_shade(frame, workspace, draw);
}
