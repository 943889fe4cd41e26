/* SPDX-License-Identifier: MIT */
/*
 * Raster: the part of a triangle that lies in one tile, as rows of fragments that pass the depth test.
 *
 * Coverage is exact. An edge is walked with an integer quotient and remainder, so that a pixel is inside exactly
 * when its centre is, and left and right edges round alike: a shared edge gives each pixel to one side.
 */
#include "setup.h"

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

/* The farthest surfaces still count as nearer than nothing: depth 1. */
static int32_t depth_of(int32_t inverse_w) {
    return glint_shift_right(inverse_w, 15) + 1;
}

/* Fragments of one row, from column `left` to before `right`. */
static void row(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw, const glint_attributes *a,
                int32_t left, int32_t right, int32_t y) {
    glint_fragments *fragments = workspace->fragments;
    int32_t inverse_w = glint_plane_at(&a->depth, left - a->anchor_x, y - a->anchor_y);
    uint32_t offset = ((uint32_t)(y - fragments->tile_y) << frame->tile_shift_x) + (uint32_t)(left - fragments->tile_x);
    const uint32_t end = offset + (uint32_t)(right - left);
    for (; offset < end; offset++) {
        int32_t depth = depth_of(inverse_w);
        if (depth > workspace->depth[offset]) {
            workspace->depth[offset] = (uint16_t)depth;
            uint32_t i = fragments->count++;
            fragments->offset[i] = (uint16_t)offset;
            fragments->inverse_w[i] = inverse_w;
            if (i == GLINT_FRAGMENTS_MAX - 1)
                glint_shade(frame, workspace, draw);
        }
        inverse_w = glint_add_wrap(inverse_w, a->depth.dx);
    }
}

/* Rows from `top` to before `bottom` between two edges. */
static void rows(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                 const glint_attributes *a, const glint_range *tile, const glint_vertex *const sides[4], int32_t top,
                 int32_t bottom) {
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
static void walk(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                 const glint_attributes *a, const glint_vertex *const corners[3]) {
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
    glint_attributes a;
    glint_setup(&a, workspace->fragments, draw, &t, area, back);
    walk(frame, workspace, draw, &a, t.corners);
    if (workspace->fragments->count)
        glint_shade(frame, workspace, draw);
}
