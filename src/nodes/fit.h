/* SPDX-License-Identifier: MIT */
/** @file fit.h Planes through a number of a triangle's corners, and what quadratics tell of it. */
#ifndef GLINT_FIT_H
#define GLINT_FIT_H

#include "../raster/polynomial.h"
#include "../raster/setup.h"

/**
 * Does a light keep its side all over a triangle, whatever its polynomial is off by? By the control points of the
 * quadratic (Bezier triangles, Farin, 1986), twice: at the corners, and at the middles with what edges bulge by.
 */
static inline int glint_triangle_keeps_side(const int32_t n[3], const int32_t bulge[3], int32_t margin) {
    const int32_t a = bulge[0] + n[0] + n[1], b = bulge[1] + n[1] + n[2], c = bulge[2] + n[0] + n[2];
    const int32_t least = glint_least(2 * glint_least_of(n[0], n[1], n[2]), glint_least_of(a, b, c));
    const int32_t most = glint_most(2 * glint_most_of(n[0], n[1], n[2]), glint_most_of(a, b, c));
    return least > 2 * margin || most < -2 * margin;
}

/**
 * A plane of numbers times `by`, Q15, as a polynomial times 2^unit. Cut off is what is above 31 bits, and what is so
 * far below 0 that it is further from the largest than glint_plane_begin has room for.
 */
static inline void glint_fit_plane(glint_quadratic *to, const glint_gradients *g, const int32_t n[3], int32_t by,
                                   unsigned unit) {
    const int32_t range = INT32_MAX >> unit;
    const int32_t a = glint_least(n[0] * by >> 15, range), b = glint_least(n[1] * by >> 15, range),
                  c = glint_least(n[2] * by >> 15, range);
    const int32_t least = glint_least(glint_most_of(a, b, c) - range + (range >> 5), 0);
    glint_plane plane;
    glint_plane_begin(&plane, g, glint_shift_left(glint_most(a, least), unit),
                      glint_shift_left(glint_most(b, least), unit), glint_shift_left(glint_most(c, least), unit));
    glint_quadratic_of(to, &plane);
}

#endif
