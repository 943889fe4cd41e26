/* SPDX-License-Identifier: MIT */
/**
 * @file found.h
 * What has been found of a triangle in one tile, kept for those that follow: terms are the triangle's, whichever tile
 * draws them. They lie in a ring in the bytes that a pass leaves free, the oldest ones in the way of new ones.
 */
#ifndef GLINT_FOUND_H
#define GLINT_FOUND_H

#include "terms.h"

/** Of a triangle, or of a piece of it. */
typedef struct glint_found {
    uint32_t key;      /* glint_found_key */
    uint32_t fits;     /* 0: it has no polynomials, and nothing but what comes next is known */
    glint_reach reach; /* of what is drawn in other ways */
    glint_terms terms;
    glint_polynomials polynomials; /* those in use */
} glint_found;

/** Piece 0 is the whole triangle. */
static inline uint32_t glint_found_key(const glint_triangle *triangle, uint32_t piece) {
    return piece << 16 | triangle->number;
}

/** May tiles before this one have drawn the triangle? */
static inline int glint_was_drawn(const glint_triangle *triangle, const glint_window *window) {
    const glint_vertex *const *v = triangle->corners;
    return glint_least_of(v[0]->x, v[1]->x, v[2]->x) < window->left ||
           glint_least_of(v[0]->y, v[1]->y, v[2]->y) < window->top;
}

/** May others draw it? */
static inline int glint_goes_on(const glint_triangle *triangle, const glint_window *window) {
    const glint_vertex *const *v = triangle->corners;
    return glint_most_of(v[0]->x, v[1]->x, v[2]->x) >= window->left + 16 * window->width ||
           glint_most_of(v[0]->y, v[1]->y, v[2]->y) >= window->top + 16 * window->height;
}

/** What is there by a key, or null. */
const glint_found *glint_found_find(const glint_workspace *workspace, uint32_t key);

/** Room for what is yet to be found, in the ring, or null. */
glint_found *glint_found_begin(glint_workspace *workspace);

/** Keeps what stands there now. */
void glint_found_keep(glint_workspace *workspace, const glint_found *found);

#endif
