/* SPDX-License-Identifier: MIT */
/**
 * @file fast_begin.h
 * Fast lighting of fragments under one directional light: which triangles it fits, and the planes that they take. In
 * line in each format's kernel, where the planes stay in registers.
 */
#ifndef GLINT_FAST_BEGIN_H
#define GLINT_FAST_BEGIN_H

#include "../raster/polynomial.h"
#include "../raster/setup.h"
#include "fast.h"

static inline int32_t glint_square_of_sum(int32_t a, int32_t b, int32_t c) {
    const int32_t sum = glint_shift_right(a + b + c, 2);
    return sum * sum;
}

/* Sum of the squares of the normals' differences, Q26: 9 less the square of their sum. */
static inline int32_t glint_turn_of(const glint_vertex *const v[3]) {
    const int16_t *a = v[0]->attribute, *b = v[1]->attribute, *c = v[2]->attribute;
    return 9 * (GLINT_UNIT / 4 * (GLINT_UNIT / 4)) - glint_square_of_sum(a[0], b[0], c[0]) -
           glint_square_of_sum(a[1], b[1], c[1]) - glint_square_of_sum(a[2], b[2], c[2]);
}

/* Is the error of linear lighting small: `turn`, of the normal, Q26, and the change of 1/w across the triangle? */
static inline int glint_fast_fits(int32_t limit, int32_t turn, glint_w_range w) {
    if (turn > limit || w.change > w.least >> 2)
        return 0;
    return (w.change * w.change >> 2) <= (uint32_t)((limit - turn) >> 16) * (w.least * w.least >> 16);
}

/* x 2^n modulo 2^32, rounded down; |n| below 32. */
static inline int32_t glint_shift_either(int32_t x, int32_t n) {
    return n < 0 ? glint_shift_right(x, (unsigned)-n) : glint_shift_left(x, (unsigned)n);
}

/* Half of what chords fall short by, of 2^15: turn / 32. */
static inline int32_t glint_find_longer(int32_t turn) {
    return glint_shift_right(turn > 0 ? turn : 0, 16);
}

/*
 * A slope, floor((d1 s1 + d2 s2) r / 2^13): |d| at most 30,000, |s| at most 2^10, r from 0 to 2^16 + 2^11. As in
 * product.h both forms give the same bits.
 */
static inline int32_t glint_term_slope_whole(int32_t d1, int32_t s1, int32_t d2, int32_t s2, int32_t r) {
    return (int32_t)glint_shift_right64((int64_t)(d1 * (s1 * 32) + d2 * (s2 * 32)) * (r * (1 << 14)), 32);
}

static inline int32_t glint_term_slope_split(int32_t d1, int32_t s1, int32_t d2, int32_t s2, int32_t r) {
    const int32_t x = d1 * s1 + d2 * s2;
    return glint_shift_right(x, 13) * r + (int32_t)(((uint32_t)x & 0x1fff) * (uint32_t)r >> 13);
}

#if GLINT_SPLIT_PRODUCTS
#define glint_term_slope glint_term_slope_split
#else
#define glint_term_slope glint_term_slope_whole
#endif

/* The plane of a term, its value in the high half; it is made longer. */
static inline void glint_begin_term(glint_plane *p, const glint_gradients *g, int32_t longer, int32_t a0, int32_t a1,
                                    int32_t a2) {
    const int32_t length = (1 << 16) + 2 * longer, d1 = a1 - a0, d2 = a2 - a0, up = 17 - g->shift;
    if (!g->reciprocal) {
        glint_plane_begin(p, g, a0 * length, a1 * length, a2 * length);
        return;
    }
    int32_t reciprocal = g->reciprocal + glint_shift_right(g->reciprocal * longer, 15);
    GLINT_OPAQUE(reciprocal); /* of 32 bits to all slopes */
    const int32_t dx = glint_term_slope(d1, g->x1, d2, g->x2, reciprocal);
    const int32_t dy = glint_term_slope(d1, g->y1, d2, g->y2, reciprocal);
    const int32_t to_center = glint_shift_right(dx, 4) * g->to_center_x + glint_shift_right(dy, 4) * g->to_center_y;
    p->dx = glint_shift_either(dx, up);
    p->dy = glint_shift_either(dy, up);
    p->start = glint_add_wrap(a0 * length, glint_shift_either(to_center, up));
}

static inline int32_t glint_magnitude(int32_t x) {
    return x < 0 ? -x : x;
}

/* From the least to the most of three numbers: half the sum of their differences. */
static inline int32_t glint_range_of(int32_t a, int32_t b, int32_t c) {
    return (glint_magnitude(b - a) + glint_magnitude(c - a) + glint_magnitude(c - b)) / 2;
}

/* Across the screen, as |dx| + |dy|. */
static inline int32_t glint_extent_of(const glint_vertex *const v[3]) {
    return glint_range_of(v[0]->x, v[1]->x, v[2]->x) + glint_range_of(v[0]->y, v[1]->y, v[2]->y);
}

/*
 * Twice the area, 28.4 squared, from which on a triangle with a highlight is large: its squared deviation is stepped.
 * Below, set-up takes more than that spares.
 */
#define GLINT_LARGE_AREA (512 * 64)

/* Bits that a stepped square has below 1. */
#define GLINT_SQUARE_BITS 2

/* Magnitudes of a deviation's slopes, ORed. */
static inline uint32_t glint_slope_bits(const glint_plane *x, const glint_plane *y) {
    return glint_magnitude_bits(x->dx) | glint_magnitude_bits(x->dy) | glint_magnitude_bits(y->dx) |
           glint_magnitude_bits(y->dy);
}

/*
 * Can a large triangle's squared deviation be stepped? Narrow ones have no side of 64 pixels, and no slope of 2^15,
 * which would wrap: corners that are 31,000 apart make 2 31000 64 / (2 64). Of these, slopes are below 2^11.
 */
static inline int glint_square_fits(const glint_gradients *g, const glint_fast_planes *planes) {
    return g->reciprocal && !(glint_slope_bits(&planes->x, &planes->y) >> (11 + 16));
}

/*
 * The sum of (E + dx x + dy y)^2 over both coordinates of a deviation: E whole, the slopes 14 bits and a sign, so that
 * a deviation is off by at most 1/2 and 2^-7 of its largest slope. x and y are at most 64: rounding down takes at most
 * 2 64 + 3 64^2 from the sum, 1/10 of a table's entry. This is added, and no sum is below 0. None that is drawn reaches
 * 2^31, as no corner's deviation reaches 16384 in x or y.
 */
static inline glint_quadratic glint_square_begin(const glint_plane *x, const glint_plane *y) {
    const unsigned zeros = glint_leading_zeros(glint_slope_bits(x, y)), size = zeros < 18 ? 18 - zeros : 0;
    const int32_t half = (1 << size) >> 1;
    const int32_t e = glint_shift_right(glint_add_wrap(x->start, 1 << 15), 16);
    const int32_t f = glint_shift_right(glint_add_wrap(y->start, 1 << 15), 16);
    const int32_t e_x = glint_shift_right(x->dx + half, size), e_y = glint_shift_right(x->dy + half, size);
    const int32_t f_x = glint_shift_right(y->dx + half, size), f_y = glint_shift_right(y->dy + half, size);
    return (glint_quadratic){((uint32_t)(e * e) + (uint32_t)(f * f)) * 4 + (2 * 64 + 3 * 64 * 64),
                             (uint32_t)glint_shift_right(e * e_x + f * f_x, 13 - size),
                             (uint32_t)glint_shift_right(e * e_y + f * f_y, 13 - size),
                             (uint32_t)glint_shift_right(e_x * e_x + f_x * f_x, 30 - 2 * size),
                             (uint32_t)glint_shift_right(e_x * e_y + f_x * f_y, 29 - 2 * size),
                             (uint32_t)glint_shift_right(e_y * e_y + f_y * f_y, 30 - 2 * size)};
}

/* Planes of a triangle that is lit all over and may show a highlight. */
static inline glint_fast_kind glint_begin_highlight(const glint_draw *draw, const glint_vertex *const v[3],
                                                    const glint_gradients *g, int32_t turn, const glint_w_range *w,
                                                    glint_fast_planes *planes) {
    const glint_fast_terms *fast = draw->shading->fast;
    if (4 * (int32_t)g->reach + 4 > fast->extent && glint_extent_of(v) > fast->extent)
        return GLINT_FAST_UNFIT;
    const int16_t *a = glint_fast_terms_of(draw, v[0]), *b = glint_fast_terms_of(draw, v[1]),
                  *c = glint_fast_terms_of(draw, v[2]);
    GLINT_OPAQUE(a); /* one address each, not one for each term */
    GLINT_OPAQUE(b);
    GLINT_OPAQUE(c);
    const int32_t change = glint_range_of(a[1], b[1], c[1]) + glint_range_of(a[2], b[2], c[2]);
    if ((uint32_t)change * w->change > fast->slant * w->least)
        return GLINT_FAST_UNFIT;
    const int32_t longer = glint_find_longer(turn);
    glint_begin_term(&planes->cosine, g, longer, a[0], b[0], c[0]);
    glint_begin_term(&planes->x, g, longer, a[1], b[1], c[1]);
    glint_begin_term(&planes->y, g, longer, a[2], b[2], c[2]);
    return GLINT_FAST_SPECULAR;
}

/* Is N.L that of the first corner, as on flat faces, or near enough? */
static inline int glint_is_even(int32_t even, int32_t a, int32_t b, int32_t c) {
    const int32_t most = a + even;
    return (uint32_t)(most - b) <= (uint32_t)(2 * even) && (uint32_t)(most - c) <= (uint32_t)(2 * even);
}

/** How to draw a triangle, and the planes that it takes. */
static inline glint_fast_kind glint_fast_begin(const glint_draw *draw, const glint_triangle *triangle,
                                               const glint_part *part, glint_fast_planes *planes) {
    const glint_fast_terms *fast = draw->shading->fast;
    const glint_vertex *const *v = triangle->corners;
    const uint32_t all = v[0]->flags & v[1]->flags & v[2]->flags, any = v[0]->flags | v[1]->flags | v[2]->flags;
    /* corners made by clipping are not lit */
    if (!(all & GLINT_VERTEX_LIT) || any & GLINT_VERTEX_UNFIT)
        return GLINT_FAST_UNFIT;
    if (all & GLINT_VERTEX_DARK)
        return GLINT_FAST_AMBIENT;
    const int shows = !(all & GLINT_VERTEX_ANY_OUTSIDE);
    const int32_t turn = glint_turn_of(v);
    const glint_w_range w = glint_find_w_range(v);
    if (!glint_fast_fits(shows ? fast->turn_specular : fast->turn, turn, w))
        return GLINT_FAST_UNFIT;
    if (shows)
        return any & (GLINT_VERTEX_DIM | GLINT_VERTEX_FAR)
                   ? GLINT_FAST_UNFIT
                   : glint_begin_highlight(draw, v, &part->gradients, turn, &w, planes);
    const int32_t longer = glint_find_longer(turn);
    const int32_t a = *glint_fast_terms_of(draw, v[0]), b = *glint_fast_terms_of(draw, v[1]),
                  c = *glint_fast_terms_of(draw, v[2]);
    if (glint_is_even(fast->even, a, b, c)) {
        planes->cosine.start = a * ((1 << 16) + 2 * longer);
        return GLINT_FAST_EVEN;
    }
    glint_begin_term(&planes->cosine, &part->gradients, longer, a, b, c);
    return any & GLINT_VERTEX_DIM ? GLINT_FAST_GATED : GLINT_FAST_DIFFUSE;
}

#endif
