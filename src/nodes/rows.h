/* SPDX-License-Identifier: MIT */
/** @file rows.h Pixels of runs on their way to colours. */
#ifndef GLINT_ROWS_H
#define GLINT_ROWS_H

#include "terms.h"

/** 1 / |M|, Q15, of pixels; or null: then it is 1. */
typedef const uint16_t *glint_inverses;

/** To the next pixel. */
static inline void glint_progress_next(glint_progress *p) {
    p->value += p->step;
    p->step += p->turn;
}

/** Pixels on their way, run after run. */
typedef struct glint_pixel_runs {
    const glint_run *runs, *end;
    glint_inverses inverse;
    int32_t (*row)[3];
    int is_curved;
} glint_pixel_runs;

/** A polynomial at a run's first pixel. */
static inline glint_progress glint_run_start(const glint_descent *p, const glint_run *run, const glint_pixel_runs *to) {
    if (to->is_curved)
        return glint_progress_at(p, run->x, run->y);
    return (glint_progress){p->row.value + p->row.step * run->x + p->down * run->y, p->row.step, 0};
}

/** Adds a light with terms of its own where it shines. */
void glint_row_add_side(const glint_terms *terms, const glint_apart *apart, const glint_descent *polynomials,
                        const glint_pixel_runs *to);

/** Adds its highlight. */
void glint_row_add_lobe(const glint_terms *terms, const glint_apart *apart, const glint_descent *polynomials,
                        const glint_pixel_runs *to);

#endif
