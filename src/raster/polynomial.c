/* SPDX-License-Identifier: MIT */
/* Polynomial: a quadratic over the screen through six nodes of a triangle, its corners and the middles of its edges. */
#include "polynomial.h"

#include "setup.h"

/* 2^n, |n| below 32. */
static inline glint_scale_by scale(int32_t n) {
    return (glint_scale_by){n < 0 ? (uint32_t)-n : 0, n > 0 ? (uint32_t)n : 0};
}

/* x times a scale modulo 2^32, rounded down. */
static inline uint32_t shift(int32_t x, glint_scale_by by) {
    return (uint32_t)glint_shift_right(x, by.right) << by.left;
}

/* A side of at most `size` bits, up to 11, times 1/area: 15 bits. */
static inline int32_t to_15_bits(int32_t side, int32_t reciprocal, int32_t size) {
    return glint_shift_right(side * reciprocal + (1 << size), (unsigned)size + 1);
}

void glint_barycentric_begin(glint_barycentric *barycentric, const glint_gradients *g, int32_t unit) {
    int32_t bits = g->shift; /* of the sides times 1/area */
    barycentric->g = g;
    barycentric->unit = (uint32_t)unit;
    if (!g->reciprocal) {
        barycentric->x1 = glint_shift_right(g->x1, 15), barycentric->y1 = glint_shift_right(g->y1, 15);
        barycentric->x2 = glint_shift_right(g->x2, 15), barycentric->y2 = glint_shift_right(g->y2, 15);
    } else {
        const int32_t size = 32 - (int32_t)glint_leading_zeros(g->reach + 1);
        barycentric->x1 = to_15_bits(g->x1, g->reciprocal, size),
        barycentric->y1 = to_15_bits(g->y1, g->reciprocal, size);
        barycentric->x2 = to_15_bits(g->x2, g->reciprocal, size),
        barycentric->y2 = to_15_bits(g->y2, g->reciprocal, size);
        bits += 11 - size;
        barycentric->slope = scale(unit - g->shift);
    }
    barycentric->curve = scale(unit + 15 - 2 * bits);
}

/* What slopes in x and y make from the first corner to the anchor's centre, half of it. */
static inline int32_t to_anchor(int32_t x, int32_t y, const glint_gradients *g) {
    return glint_shift_right(x, 5) * g->to_center_x + glint_shift_right(y, 5) * g->to_center_y;
}

/* A plane that is 0 at the first corner, d1 and d2 at the others, times 2^unit. */
static inline void begin_slope(glint_quadratic *q, const glint_barycentric *barycentric, int32_t d1, int32_t d2) {
    const glint_gradients *g = barycentric->g;
    if (!g->reciprocal) {
        glint_plane plane; /* of a quarter: differences have 17 bits */
        glint_plane_begin(&plane, g, 0, d1 * (1 << (barycentric->unit - 2)), d2 * (1 << (barycentric->unit - 2)));
        q->start = (uint32_t)plane.start << 2;
        q->dx = (uint32_t)plane.dx << 2;
        q->dy = (uint32_t)plane.dy << 2;
        return;
    }
    const int32_t dx = glint_slope_of(d1 * g->x1 + d2 * g->x2, g->reciprocal, 12);
    const int32_t dy = glint_slope_of(d1 * g->y1 + d2 * g->y2, g->reciprocal, 12);
    q->start = shift(to_anchor(dx, dy, g), barycentric->slope) * 2;
    q->dx = shift(dx, barycentric->slope);
    q->dy = shift(dy, barycentric->slope);
}

void glint_form_begin(glint_quadratic *q, const glint_barycentric *barycentric, const glint_form *f) {
    const glint_gradients *g = barycentric->g;
    const int32_t x1 = barycentric->x1, y1 = barycentric->y1, x2 = barycentric->x2, y2 = barycentric->y2;
    /* half the form's gradients along l1 and l2, each along x and y */
    const int32_t u_x = glint_shift_right(f->both * x2, 1) - f->b1 * x1,
                  v_x = glint_shift_right(f->both * x1, 1) - f->b2 * x2;
    const int32_t u_y = glint_shift_right(f->both * y2, 1) - f->b1 * y1,
                  v_y = glint_shift_right(f->both * y1, 1) - f->b2 * y2;
    const int32_t xx = glint_sum_of_products(u_x, x1, v_x, x2), yy = glint_sum_of_products(u_y, y1, v_y, y2);
    const int32_t xy = glint_sum_of_products(u_x, y1, v_x, y2);
    begin_slope(q, barycentric, f->d1, f->d2);
    q->dxx = shift(xx, barycentric->curve);
    q->dxy = 2 * shift(xy, barycentric->curve);
    q->dyy = shift(yy, barycentric->curve);
    /* the polynomial is the corner's, the anchor's centre lies beside it */
    const int32_t x = to_anchor(xx, xy, g), y = to_anchor(xy, yy, g);
    q->start += ((uint32_t)f->a << barycentric->unit) + 4 * shift(to_anchor(x, y, g), barycentric->curve);
    q->dx += 4 * shift(x, barycentric->curve);
    q->dy += 4 * shift(y, barycentric->curve);
}

/* The quadratic of a term that is a at the corners, with the bulges b of edges; its value in the high half. */
void glint_polynomial_begin(glint_quadratic *q, const glint_barycentric *barycentric, const int32_t a[3],
                            const int32_t b[3]) {
    const glint_form f = {a[0], a[1] - a[0] + b[0], a[2] - a[0] + b[2], b[0], b[2], b[1] - b[0] - b[2]};
    glint_form_begin(q, barycentric, &f);
}
