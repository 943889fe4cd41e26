/* SPDX-License-Identifier: MIT */
/**
 * @file small.h Takes small triangles from corner words to pixels: those of at most 31 rows, whose corners lie within
 * 64 pixels of the top one in x. Edges, 1/w and rows are one function, which a format specialises by its loop over the
 * pixels of a span.
 */
#ifndef GLINT_SMALL_H
#define GLINT_SMALL_H

#include "../math/division.h"
#include "depth.h"
#include "triangle.h"

/* ---- Corners ---- */

#define GLINT_TO_CENTER 15
#define GLINT_X_BIAS 0x8000

static inline glint_corner_word glint_word_of(const glint_window *window, const glint_vertex *v) {
    const uint32_t word = (uint32_t)(uint16_t)v->x | (uint32_t)(uint16_t)v->y << 16;
    return (int32_t)((word ^ GLINT_X_BIAS) - window->origin);
}

static inline int32_t glint_x_of(glint_corner_word p) {
    return (int32_t)((uint32_t)p & 0xffff);
}

static inline int32_t glint_y_of(glint_corner_word p) {
    return glint_shift_right(p, 16);
}

/** Returns the first row of centres at or below a corner. */
static inline int32_t glint_row_of(glint_corner_word p) {
    return glint_shift_right(p, 20);
}

/**
 * Finds the words of a triangle's corners, from the top one on, and the corners in that order.
 * @return which of the triangle's corners is the top one
 */
static GLINT_INLINE uint32_t glint_find_words(const glint_row_walk *walk, glint_corners *k, const glint_vertex *v[3]) {
    const glint_window *window = &walk->part->window;
    const glint_vertex *p = walk->triangle.corners[0], *q = walk->triangle.corners[1], *r = walk->triangle.corners[2];
    glint_corner_word a = glint_word_of(window, p), b = glint_word_of(window, q), c = glint_word_of(window, r);
    uint32_t top = 0;
    if (b < a && b < c) {
        const glint_corner_word first = a;
        const glint_vertex *corner = p;
        a = b, b = c, c = first;
        p = q, q = r, r = corner;
        top = 1;
    } else if (c < a) {
        const glint_corner_word first = a;
        const glint_vertex *corner = p;
        a = c, c = b, b = first;
        p = r, r = q, q = corner;
        top = 2;
    }
    k->a = a, k->b = b, k->c = c;
    v[0] = p, v[1] = q, v[2] = r;
    return top;
}

/* ---- Sides ---- */

/** Q20: with this added to a word's x, the whole part is the first column at or right of x. */
#define GLINT_SIDE_ORIGIN (INT32_MIN + GLINT_EDGE_CEILING - (GLINT_TO_CENTER << 16))

/** Begins a side of a small triangle that runs down from `upper` to `lower`, so many rows below its first one. */
static inline glint_side glint_begin_side(glint_corner_word upper, glint_corner_word lower, int32_t rows) {
    const int32_t slope = glint_slope(lower - upper, glint_y_of(lower) - glint_y_of(upper));
    int32_t x = glint_add_wrap(glint_shift_left(upper, 16), GLINT_SIDE_ORIGIN);
    x = glint_add_wrap(x, glint_edge_start(slope, ~glint_y_of(upper) & 15));
    return (glint_side){glint_add_wrap(x, glint_multiply_wrap(slope, rows)), slope};
}

/* ---- Slopes ---- */

/* From this area on, twice the area in 28.4 squared, slopes serve any small triangle; up to this length of sides they
 * serve any area. Other sides are too long for the bits that the reciprocal of so small an area has. */
#define GLINT_SLOPES_AREA (1u << 10)
#define GLINT_SLOPES_SIDE 64

/* The weights of triangles below this area have no fraction: slopes do not serve them. */
#define GLINT_LEAST_SLOPES_AREA 8

/** Returns the sum of differences by two weights. */
static inline uint32_t glint_weigh(int32_t d1, int32_t weight1, int32_t d2, int32_t weight2) {
    return (uint32_t)d1 * (uint32_t)weight1 + (uint32_t)d2 * (uint32_t)weight2;
}

/** These are the sides of a triangle that begin at its top corner, in sixteenths. */
typedef struct glint_sides {
    int32_t dx1, dy1, dx2, dy2;
} glint_sides;

/** Finds 1/area of a small triangle, for its slopes. @return 0 where slopes do not serve */
static GLINT_INLINE int glint_find_area(const glint_sides *s, glint_area *to) {
    const uint32_t area = (uint32_t)(s->dy1 * s->dx2 - s->dy2 * s->dx1);
    if (area < GLINT_SLOPES_AREA) {
        const uint32_t side = GLINT_SLOPES_SIDE;
        if (((uint32_t)(s->dx1 + (int32_t)side) | (uint32_t)(s->dx2 + (int32_t)side)) >= 2 * side ||
            ((uint32_t)s->dy1 | (uint32_t)s->dy2) >= side || area < GLINT_LEAST_SLOPES_AREA)
            return 0;
    }
    to->zeros = glint_leading_zeros(area);
    to->reciprocal = glint_reciprocal16(area << to->zeros >> 16);
    return 1;
}

/** Finds the slopes of a small triangle, given 1/area. */
static GLINT_INLINE void glint_find_slopes(const glint_corners *k, glint_slopes *s) {
    const int32_t dx1 = glint_x_of(k->b) - glint_x_of(k->a), dx2 = glint_x_of(k->c) - glint_x_of(k->a);
    const int32_t dy1 = glint_y_of(k->b) - glint_y_of(k->a), dy2 = glint_y_of(k->c) - glint_y_of(k->a);
    const uint32_t down = 29 - k->area.zeros;
    const int32_t reciprocal = k->area.reciprocal, half = (int32_t)(1u << (down - 1));
    const int32_t right = ~glint_x_of(k->a) & 15, below = ~glint_y_of(k->a) & 15;
    s->x1 = glint_shift_right(half - dy2 * reciprocal, down);
    s->x2 = glint_shift_right(half + dy1 * reciprocal, down);
    s->y1 = glint_shift_right(half + dx2 * reciprocal, down);
    s->y2 = glint_shift_right(half - dx1 * reciprocal, down);
    s->column = glint_shift_right(glint_x_of(k->a), 4) - (GLINT_X_BIAS >> 4);
    s->row = glint_row_of(k->a);
    s->start1 = glint_shift_right(s->x1 * right + s->y1 * below, 4);
    s->start2 = glint_shift_right(s->x2 * right + s->y2 * below, 4);
}

/* Returns the change of 1/w, Q31, over a sixteenth of a pixel, modulo 2^32, from a sum of products of differences,
 * Q18, and sides. */
static inline uint32_t glint_depth_change(int32_t sum, const glint_area *area) {
    const int32_t change = glint_slope_of(sum, area->reciprocal, 15); /* times 2^(19 - zeros) */
    return area->zeros <= 19 ? (uint32_t)glint_shift_right(change, 19 - area->zeros)
                             : (uint32_t)change << (area->zeros - 19);
}

/**
 * Returns the plane of 1/w, Q31, with GLINT_DEPTH_BIAS, from the tile's first pixel on. It consists of sums of products
 * without rounding, times 1/area in 16 bits: it is off by 2^-15 of the corners' difference across the triangle, and by
 * half a step of depth. Changes per pixel are 16 times those of a sixteenth, so that any tile gives a pixel the same
 * value.
 */
static GLINT_INLINE glint_plane glint_small_depth(glint_corner_word a, const glint_sides *s, const glint_area *area,
                                                  int32_t wa, int32_t wb, int32_t wc) {
    const int32_t d1 = glint_shift_right(wb - wa, 13), d2 = glint_shift_right(wc - wa, 13);
    const uint32_t dx = glint_depth_change(d2 * s->dy1 - d1 * s->dy2, area); /* of at most 2^28, */
    const uint32_t dy = glint_depth_change(d1 * s->dx2 - d2 * s->dx1, area); /* and 2^29 */
    const uint32_t x = (uint32_t)(glint_x_of(a) - GLINT_X_BIAS - GLINT_TO_CENTER),
                   y = (uint32_t)(glint_y_of(a) - GLINT_TO_CENTER);
    const uint32_t start = (uint32_t)wa + GLINT_DEPTH_BIAS - dx * x - dy * y;
    return (glint_plane){(int32_t)start, (int32_t)(dx << 4), (int32_t)(dy << 4)};
}

/* Differences of 1/w, Q31, may be cut to 17 bits from this 1/w on. */
#define GLINT_LEAST_W (1 << 18)

/** Is the plane of 1/w too steep for slopes? Where 1/w of the corners does not differ by more than a factor of 8 to 16,
 * is not too small, and is not that of parallel rays, no rounding takes it below 0 or beyond 2^31. */
static inline int glint_is_steep(int32_t wa, int32_t wb, int32_t wc) {
    const int32_t least = glint_most(glint_shift_right(wa | wb | wc, 4), GLINT_LEAST_W);
    return ((wa - least) | (wb - least) | (wc - least) | (GLINT_DEPTH_TOP - wa) | (GLINT_DEPTH_TOP - wb) |
            (GLINT_DEPTH_TOP - wc)) < 0;
}

/** Is a triangle of so many rows small? */
static GLINT_INLINE int glint_is_small(const glint_corners *k, int32_t rows) {
    const uint32_t to_b = (uint32_t)(glint_x_of(k->b) - glint_x_of(k->a) + GLINT_EDGE_DX / 2);
    const uint32_t to_c = (uint32_t)(glint_x_of(k->c) - glint_x_of(k->a) + GLINT_EDGE_DX / 2);
    return (to_b | to_c) < GLINT_EDGE_DX && rows <= GLINT_SHORT_ROWS;
}

/* ---- Rows ---- */

/** Begins the sides of a small triangle at its first row in the tile: a long one from the top to the lowest corner, and
 * two short ones. The second short one replaces the first at the middle corner. */
static inline void glint_begin_sides(glint_corner_word top, glint_corner_word middle, glint_corner_word lowest,
                                     int is_left, glint_small_rows *rows) {
    const int32_t row = rows->row, end = rows->end, turn = glint_row_of(middle), down = row - glint_row_of(top);
    glint_side *const brief = is_left ? &rows->left : &rows->right, *const other = is_left ? &rows->right : &rows->left;
    *other = glint_begin_side(top, lowest, down);
    if (row >= turn) {
        *brief = glint_begin_side(middle, lowest, row - turn);
        rows->stop = end;
        return;
    }
    *brief = glint_begin_side(top, middle, down);
    rows->stop = end;
    if (turn >= end)
        return;
    rows->third = glint_begin_side(middle, lowest, 0);
    rows->is_left = is_left;
    rows->stop = turn;
}

/** Finds a triangle's corners, and its rows in the tile. @return GLINT_IS_SMALL where sides may follow */
static GLINT_INLINE glint_begun glint_find_rows(glint_row_walk *walk, const glint_vertex *v[3]) {
    glint_corners *const k = &walk->corners;
    k->top = glint_find_words(walk, k, v);
    const int32_t top = glint_row_of(k->a), bottom = glint_most(glint_row_of(k->b), glint_row_of(k->c));
    walk->rows.row = glint_most(top, 0);
    walk->rows.end = glint_least(bottom, walk->part->window.height);
    if (walk->rows.row >= walk->rows.end)
        return GLINT_NO_ROWS;
    return glint_is_small(k, bottom - top) ? GLINT_IS_SMALL : GLINT_IS_LARGE;
}

/** Finds area and plane of 1/w of a small triangle, its corners from the top one on, where slopes serve it. */
static GLINT_INLINE void glint_begin_slopes(glint_row_walk *walk, const glint_vertex *const v[3]) {
    glint_corners *const k = &walk->corners;
    const int32_t wa = v[0]->inverse_w, wb = v[1]->inverse_w, wc = v[2]->inverse_w;
    const glint_sides s = {glint_x_of(k->b) - glint_x_of(k->a), glint_y_of(k->b) - glint_y_of(k->a),
                           glint_x_of(k->c) - glint_x_of(k->a), glint_y_of(k->c) - glint_y_of(k->a)};
    glint_area area;
    if ((walk->draw->is_wide && glint_is_steep(wa, wb, wc)) || !glint_find_area(&s, &area)) {
        walk->has_slopes = 0;
        return;
    }
    k->area = area;
    walk->z = glint_small_depth(k->a, &s, &area, wa, wb, wc);
    walk->has_slopes = 1;
    walk->is_deep = 0;
}

/** Begins the sides of a small triangle whose rows are known. */
static GLINT_INLINE void glint_find_sides(glint_row_walk *walk) {
    const glint_corners *const k = &walk->corners;
    if (k->b < k->c)
        glint_begin_sides(k->a, k->b, k->c, 1, &walk->rows);
    else
        glint_begin_sides(k->a, k->c, k->b, 0, &walk->rows);
}

/** Does what glint_begin_triangle does, within its caller, and returns the corners in order. */
static GLINT_INLINE glint_begun glint_begin_inline(glint_row_walk *walk, const glint_vertex *v[3]) {
    const glint_begun begun = glint_find_rows(walk, v);
    if (begun != GLINT_IS_SMALL) {
        walk->has_slopes = 0;
        return begun;
    }
    glint_begin_slopes(walk, v);
    GLINT_OPAQUE(walk); /* what follows reads what has been stored: otherwise it is kept on the stack */
    glint_find_sides(walk);
    return GLINT_IS_SMALL;
}

/** The state of a walk down the rows of a small triangle is this. */
typedef struct glint_row_state {
    glint_side left, right;
    int32_t row, stop;
} glint_row_state;

static GLINT_INLINE glint_row_state glint_begin_rows(const glint_row_walk *walk) {
    const glint_small_rows *const rows = &walk->rows;
    return (glint_row_state){rows->left, rows->right, rows->row, rows->stop};
}

static GLINT_INLINE void glint_keep_rows(glint_row_walk *walk, const glint_row_state *at) {
    glint_small_rows *const rows = &walk->rows;
    rows->left = at->left, rows->right = at->right;
    rows->row = at->row, rows->stop = at->stop;
}

/** Finds the columns of a row. @return 0 where there are none */
static GLINT_INLINE int glint_find_span(const glint_row_state *at, int32_t width, int32_t *from, int32_t *to) {
    *from = glint_most(glint_shift_right(at->left.x, 20), 0);
    *to = glint_least(glint_shift_right(at->right.x, 20), width);
    return *from < *to;
}

/** Steps to the next row. @return 0 behind the last one */
static GLINT_INLINE int glint_next_row(const glint_row_walk *walk, glint_row_state *at) {
    at->left.x = glint_add_wrap(at->left.x, at->left.slope);
    at->right.x = glint_add_wrap(at->right.x, at->right.slope);
    if (++at->row != at->stop)
        return 1;
    at->stop = walk->rows.end;
    if (at->row == at->stop)
        return 0;
    if (walk->rows.is_left)
        at->left = walk->rows.third;
    else
        at->right = walk->rows.third;
    return 1;
}

/** Moves on to the first row that has a visible pixel. @return 0 where there is none */
static GLINT_INLINE int glint_seek_visible(const glint_row_walk *walk, glint_row_state *at) {
    const int32_t width = walk->part->window.width;
    const uint32_t dx = (uint32_t)walk->z.dx;
    do {
        int32_t from, to;
        if (!glint_find_span(at, width, &from, &to))
            continue;
        const uint16_t *depth = walk->depth + ((uint32_t)at->row << walk->shift) + from;
        uint32_t z = glint_z_at(walk, at->row, from);
        for (; from < to; from++, depth++, z += dx)
            if (z >> 15 > *depth)
                return 1;
    } while (glint_next_row(walk, at));
    return 0;
}

/** Draws the rows of a small triangle from a state on, span by span. */
static GLINT_INLINE void glint_draw_rows(glint_row_walk *walk, glint_row_state at, glint_draw_span *draw_span) {
    const int32_t width = walk->part->window.width;
    do {
        int32_t from, to;
        if (glint_find_span(&at, width, &from, &to))
            draw_span(walk, at.row, from, to);
    } while (glint_next_row(walk, &at));
}

#endif
