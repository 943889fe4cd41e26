/* SPDX-License-Identifier: MIT */
/**
 * @file found.h
 * What has been found of a triangle in one tile, kept for those that follow: its light does not depend on the tile that
 * draws it. It lies in a ring in the bytes that a pass leaves free, the oldest in the way of the newest. A library
 * built for size finds all of it anew.
 */
#ifndef GLINT_FOUND_H
#define GLINT_FOUND_H

#include "raster.h"

/** May tiles before this one have drawn the triangle? */
static inline int glint_was_drawn(const glint_triangle *triangle, const glint_window *window) {
    const glint_vertex *const *v = triangle->corners;
    return glint_least_of(v[0]->x, v[1]->x, v[2]->x) < window->left ||
           glint_least_of(v[0]->y, v[1]->y, v[2]->y) < window->top;
}

/** May tiles behind this one? */
static inline int glint_goes_on(const glint_triangle *triangle, const glint_window *window) {
    const glint_vertex *const *v = triangle->corners;
    return glint_most_of(v[0]->x, v[1]->x, v[2]->x) >= window->left + 16 * window->width ||
           glint_most_of(v[0]->y, v[1]->y, v[2]->y) >= window->top + 16 * window->height;
}

/** What is kept by this key, or null. */
const void *glint_ring_find(const glint_workspace *workspace, uint32_t key);

/** Room for so many bytes, or null. */
void *glint_ring_begin(glint_workspace *workspace, size_t most);

/** Keeps the first bytes of what stands there now. */
void glint_ring_keep(glint_workspace *workspace, uint32_t key, size_t size);

static inline uint32_t glint_found_key(const glint_triangle *triangle, uint32_t piece) {
    return piece << 16 | triangle->number;
}

/** What an earlier tile kept of a triangle, piece 0, or of a piece of it; or null. */
static inline const void *glint_found_find(const glint_workspace *workspace, const glint_triangle *triangle,
                                           const glint_part *part, uint32_t piece) {
    return !GLINT_SMALL && glint_was_drawn(triangle, &part->window)
               ? glint_ring_find(workspace, glint_found_key(triangle, piece))
               : 0;
}

/** Where to put what is found for later tiles, at most so many bytes; or null, where there are none or there is no
 * room. */
static inline void *glint_found_begin(glint_workspace *workspace, const glint_triangle *triangle,
                                      const glint_part *part, size_t most) {
    return !GLINT_SMALL && glint_goes_on(triangle, &part->window) ? glint_ring_begin(workspace, most) : 0;
}

/** Keeps so many bytes of what has been put there last. */
static inline void glint_found_keep(glint_workspace *workspace, const glint_triangle *triangle, uint32_t piece,
                                    size_t size) {
    glint_ring_keep(workspace, glint_found_key(triangle, piece), size);
}

#endif
