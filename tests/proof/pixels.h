/* SPDX-License-Identifier: MIT */
/**
 * @file pixels.h
 * Fragments in a tile, and the planes they take their attributes from.
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

/* From an anchor that the guard band holds, with the screen. */
static void any_planes(glint_attributes *attributes) {
    for (int c = 0; c < 3; c++) {
        any_plane(&attributes->main[c]);
        any_plane(&attributes->extra[c]);
    }
    attributes->x = ANY(-2047, 2047);
    attributes->y = ANY(-2047, 2047);
}

/* So many fragments of a tile of up to 64 pixels a side. */
static void any_tile(glint_frame *frame, glint_fragments *fragments, uint32_t count) {
    frame->config.width = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    frame->config.height = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    frame->config.tile_width = (uint16_t)ANY(8, 64);
    frame->tile_shift_x = (uint8_t)ANY(3, 6);
    fragments->count = count;
    fragments->tile_x = ANY(0, GLINT_SIZE_MAX - 1);
    fragments->tile_y = ANY(0, GLINT_SIZE_MAX - 1);
    fragments->scale = ANY_UNSIGNED(0, 30);
    for (int i = 0; i < GLINT_FRAGMENTS_MAX; i++) {
        fragments->offset[i] = (uint16_t)ANY(0, GLINT_TILE_MAX * GLINT_TILE_MAX - 1);
        fragments->inverse_w[i] = ANY(0, INT32_MAX);
    }
}

#endif
