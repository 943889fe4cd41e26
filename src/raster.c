/* SPDX-License-Identifier: MIT */
/*
 * Raster: the part of a triangle that lies in one tile, as spans of pixels for a kernel to draw.
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

/* Spans from row `top` to before `bottom`, of the tile, between two edges. */
static void find_spans(glint_part *part, const glint_range *tile, const glint_vertex *const sides[4], int32_t top,
                       int32_t bottom) {
    edge left, right;
    edge_begin(&left, sides[0], sides[1], top);
    edge_begin(&right, sides[2], sides[3], top);
    for (int32_t y = top; y < bottom; y++) {
        int32_t from = left.x < tile->left ? tile->left : left.x;
        int32_t to = right.x > tile->right ? tile->right : right.x;
        glint_span *span = &part->spans[y - tile->top];
        span->left = (uint8_t)(from - tile->left);
        span->count = (uint8_t)(from < to ? to - from : 0);
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

/* The triangle's spans in the tile: of its upper part to the middle corner, then of the lower. */
static void find_part(glint_part *part, const glint_range *tile, const glint_vertex *const corners[3]) {
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
    first = first < tile->top ? tile->top : first;
    end = end > tile->bottom ? tile->bottom : end;
    end = end < first ? first : end;
    part->top = (uint32_t)(first - tile->top);
    part->bottom = (uint32_t)(end - tile->top);
    const glint_vertex *const upper[6] = {top, middle, top, bottom, top, middle};
    const glint_vertex *const lower[6] = {middle, bottom, top, bottom, middle, bottom};
    if (first < turn)
        find_spans(part, tile, upper + first_side, first, turn < end ? turn : end);
    first = first < turn ? turn : first;
    if (first < end)
        find_spans(part, tile, lower + first_side, first, end);
}

/* Orders the corners clockwise. */
static void orient(glint_triangle *t, int mirrored) {
    t->area = glint_double_area(t->corners[0], t->corners[1], t->corners[2]);
    t->back = (t->area > 0) != mirrored;
    if (t->area < 0) {
        const int16_t *extra = t->extra[1];
        swap(&t->corners[1], &t->corners[2]);
        t->extra[1] = t->extra[2];
        t->extra[2] = extra;
        t->area = -t->area;
    }
}

void glint_raster(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                  glint_triangle *triangle) {
    const glint_fragments *fragments = workspace->fragments;
    const glint_range tile = {fragments->tile_x, fragments->tile_y, fragments->tile_x + fragments->tile_width,
                              fragments->tile_y + fragments->tile_height};
    glint_part part;
    orient(triangle, draw->mirrored);
    find_part(&part, &tile, triangle->corners);
    if (part.top == part.bottom)
        return;
    part.x = tile.left - glint_shift_right(triangle->corners[0]->x, 4);
    part.y = tile.top - glint_shift_right(triangle->corners[0]->y, 4);
    glint_setup(&part, triangle);
    glint_choose_kernel(frame, draw, triangle)(frame, workspace, draw, triangle, &part);
}
