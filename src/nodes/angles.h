/* SPDX-License-Identifier: MIT */
/** @file angles.h What a region turns by, and products of that. */
#ifndef GLINT_ANGLES_H
#define GLINT_ANGLES_H

#include "terms.h"

/** Angles beyond this, Q12, have no polynomial. */
#define GLINT_WIDEST (2 << 12)

/** Products of angles up to 2, Q12. */
static inline uint32_t glint_times(uint32_t a, uint32_t b) {
    return a * b >> 12;
}

/** a (a + b)^2, what quadratics err by where something turns by a, and 1/w changes by b. */
static inline uint32_t glint_cube(uint32_t a, uint32_t b) {
    return glint_times(glint_times(a, a + b), a + b);
}

/** How far a region's highlights turn about their axes, and these about them. */
static inline uint32_t glint_lobe_turn(const glint_shading *shading, const glint_region *region) {
    return shading->material->model->lobe == GLINT_LOBE_MIRROR ? 2 * region->turn : region->turn;
}

/** What L and V turn by. */
static inline uint32_t glint_turn_of_rays(const glint_frame *frame, const glint_region *region, uint32_t l) {
    return region->near_of[l] + (frame->view->local_viewer ? region->reach : 0);
}

#endif
