/* SPDX-License-Identifier: MIT */
/** @file rows.h Pixels of runs on their way to colours. */
#ifndef GLINT_ROWS_H
#define GLINT_ROWS_H

#include "terms.h"

/** 1 / |M|, Q15, of pixels, which those of one chroma have in their third number; or null: then it is 1. */
typedef const uint16_t *glint_inverses;

/** Pixels on their way, run after run. */
typedef struct glint_pixel_runs {
    const glint_run *runs, *end;
    int32_t x, y; /* of the tile's first pixel, from the anchor */
    glint_inverses inverse;
    int32_t (*row)[3];
} glint_pixel_runs;

/** A polynomial from a run's first pixel on. */
static inline glint_progress glint_run_start(const glint_quadratic *q, const glint_run *run,
                                             const glint_pixel_runs *to) {
    return glint_progress_begin(q, to->x + run->x, to->y + run->y);
}

/** Adds a light with terms of its own where it shines. */
void glint_row_add_side(const glint_terms *terms, const glint_apart *apart, const glint_quadratic *polynomials,
                        const glint_pixel_runs *to);

/** Adds its highlight. */
void glint_row_add_lobe(const glint_terms *terms, const glint_apart *apart, const glint_quadratic *polynomials,
                        const glint_pixel_runs *to);

#endif
