/* SPDX-License-Identifier: MIT */
/**
 * @file polynomial.h
 * Quadratics over the screen, of whole numbers, stepped from pixel to pixel by forward differences.
 */
#ifndef GLINT_POLYNOMIAL_H
#define GLINT_POLYNOMIAL_H

#include "raster.h"

/**
 * A quadratic function of the pixel, x and y from the anchor, modulo 2^32:
 * start + dx x + dy y + dxx x x + dxy x y + dyy y y.
 */
typedef struct glint_quadratic {
    uint32_t start, dx, dy, dxx, dxy, dyy;
} glint_quadratic;

/** The quadratic that is a plane. */
static inline void glint_quadratic_of(glint_quadratic *q, const glint_plane *plane) {
    *q = (glint_quadratic){(uint32_t)plane->start, (uint32_t)plane->dx, (uint32_t)plane->dy, 0, 0, 0};
}

/** Of a quadratic whose x and y count from another point: as from the anchor, where that point is x, y. */
static inline void glint_quadratic_move(glint_quadratic *q, int32_t x, int32_t y) {
    const uint32_t i = (uint32_t)x, j = (uint32_t)y;
    q->start += (q->dxx * i + q->dxy * j - q->dx) * i + (q->dyy * j - q->dy) * j;
    q->dx -= 2 * q->dxx * i + q->dxy * j;
    q->dy -= 2 * q->dyy * j + q->dxy * i;
}

/** A quadratic at a pixel, and its step to the next column. */
typedef struct glint_stride {
    uint32_t value, across;
} glint_stride;

static inline glint_stride glint_stride_begin(const glint_quadratic *q, int32_t x, int32_t y) {
    const uint32_t i = (uint32_t)x, j = (uint32_t)y, slope = q->dx + q->dxy * j + q->dxx * i;
    return (glint_stride){q->start + (q->dy + q->dyy * j) * j + slope * i, slope + q->dxx * (i + 1)};
}

static inline void glint_stride_next(glint_stride *s, const glint_quadratic *q) {
    s->value += s->across;
    s->across += 2 * q->dxx;
}

/** A number along a row: at a pixel, its step to the next, and the step's change. */
typedef struct glint_progress {
    uint32_t value, step, turn;
} glint_progress;

/** A quadratic along a row from a pixel on. */
static inline glint_progress glint_progress_begin(const glint_quadratic *q, int32_t x, int32_t y) {
    const glint_stride s = glint_stride_begin(q, x, y);
    return (glint_progress){s.value, s.across, 2 * q->dxx};
}

/** To the next pixel. */
static inline void glint_progress_next(glint_progress *p) {
    p->value += p->step;
    p->step += p->turn;
}

/** To another column. */
static inline void glint_stride_move(glint_stride *s, const glint_quadratic *q, uint32_t by) {
    s->value += s->across * by + 2 * q->dxx * (by * (by - 1) >> 1);
    s->across += 2 * q->dxx * by;
}

/** To the next row, from (x, y). */
static inline void glint_stride_down(glint_stride *s, const glint_quadratic *q, uint32_t x, uint32_t y) {
    s->value += q->dy + q->dyy * (2 * y + 1) + q->dxy * x;
    s->across += q->dxy;
}

/** A power of two: shifts to the right, and then to the left. */
typedef struct glint_scale_by {
    uint32_t right, left;
} glint_scale_by;

/** Changes of the second and the third corner's barycentric coordinates a pixel, 15 bits and a sign. */
typedef struct glint_barycentric {
    const glint_gradients *g;
    uint32_t unit; /* binary logarithm of what 1 is */
    int32_t x1, y1, x2, y2;
    glint_scale_by slope; /* of narrow triangles, from a slope to a quadratic's */
    glint_scale_by curve; /* from a product of two of these to a quadratic's second degree */
} glint_barycentric;

/** Twice their least area, 28.4 squared: sides have at most 2 bits more, which keeps gradients' squares in 32. */
#define GLINT_POLYNOMIAL_LEAST_AREA 8

/** @param unit from 2 to 16: polynomials are times 2^unit. */
void glint_barycentric_begin(glint_barycentric *barycentric, const glint_gradients *gradients, int32_t unit);

/**
 * A quadratic of the second and the third corner's barycentric coordinates l1 and l2,
 * a + d1 l1 + d2 l2 - b1 l1^2 - b2 l2^2 + both l1 l2: a 15 bits and a sign, d1 and d2 17, b1 and b2 14, both 15.
 */
typedef struct glint_form {
    int32_t a, d1, d2, b1, b2, both;
} glint_form;

/** The quadratic that a form is, times 2^unit. */
void glint_form_begin(glint_quadratic *q, const glint_barycentric *barycentric, const glint_form *form);

/**
 * The quadratic of what is a[i] at corner i, 15 bits and a sign, and at the middles of the edges from corner 0 to 1,
 * from 1 to 2 and from 0 to 2 the mean of their ends and b[i] / 4, 14 bits and a sign; times 2^unit.
 */
void glint_polynomial_begin(glint_quadratic *q, const glint_barycentric *barycentric, const int32_t a[3],
                            const int32_t b[3]);

#endif
