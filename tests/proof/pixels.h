/* SPDX-License-Identifier: MIT */
/**
 * @file pixels.h
 * Fragments of a row, and the planes they take their attributes from.
 */
#ifndef GLINT_PIXELS_H
#define GLINT_PIXELS_H

#include "../../src/fast/fast.h"
#include "../../src/light/shade.h"
#include "proof.h"

/*@ assigns \result \from indirect: *shading, indirect: cosine, indirect: square; */
uint32_t glint_fast_word(const glint_shading *shading, int32_t cosine, uint32_t square);

static void any_plane(glint_plane *plane) {
    plane->start = ANY_INT;
    plane->dx = ANY_INT;
    plane->dy = ANY_INT;
}

static void any_planes(glint_attributes *attributes) {
    for (int c = 0; c < 3; c++) {
        any_plane(&attributes->main[c]);
        any_plane(&attributes->extra[c]);
    }
    any_plane(&attributes->depth);
}

/* So many fragments of a triangle whose anchor the guard band holds, anywhere in a tile of the screen, or by a
 * cell of the lattice beyond it. */
static void any_run(glint_frame *frame, glint_fragments *fragments, glint_part *part, uint32_t count) {
    frame->config.width = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    frame->config.height = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    part->window.left = ANY(8, 16 * GLINT_SIZE_MAX);
    part->window.top = ANY(8, 16 * GLINT_SIZE_MAX);
    part->x = ANY(-2047, 2047);
    part->y = ANY(-2047, 2047);
    fragments->part = part;
    fragments->count = count;
    fragments->scale = ANY_UNSIGNED(0, 30);
    for (int i = 0; i < GLINT_FRAGMENTS_MAX; i++) {
        fragments->column[i] = (int8_t)ANY(-16, GLINT_TILE_MAX + 16);
        fragments->row[i] = (int8_t)ANY(-16, GLINT_TILE_MAX + 16);
        fragments->inverse_w[i] = ANY(0, INT32_MAX);
    }
}

#endif
