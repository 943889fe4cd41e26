/* SPDX-License-Identifier: MIT */
/**
 * @file pixels.h
 * Fragments of a row, and the planes they take their attributes from.
 */
#ifndef GLINT_PIXELS_H
#define GLINT_PIXELS_H

#include "../../src/frame.h"
#include "proof.h"

/*@ assigns \result \from indirect: *shading, indirect: cosine, indirect: square; */
uint32_t glint_deviation_pixel(const glint_shading *shading, int32_t cosine, uint32_t square);

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
}

/* So many fragments that follow each other, in a triangle whose anchor the guard band holds, with the screen. */
static void any_run(glint_frame *frame, glint_fragments *fragments, uint32_t count) {
    frame->config.width = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    frame->config.height = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    fragments->count = count;
    fragments->x = ANY(-8192, 8192);
    fragments->y = ANY(-8192, 8192);
    fragments->at_x = ANY(-4096, 4096);
    fragments->at_y = ANY(-4096, 4096);
    fragments->scale = ANY_UNSIGNED(0, 30);
    for (int i = 0; i < GLINT_FRAGMENTS_MAX; i++)
        fragments->inverse_w[i] = ANY(0, INT32_MAX);
}

#endif
