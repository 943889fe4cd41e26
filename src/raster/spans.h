/* SPDX-License-Identifier: MIT */
/**
 * @file spans.h
 * Loops over the pixels of a triangle's spans in a tile: depth test, colour and store in one. A format makes them its
 * own by its `pack` and `put`, which are constants where they are inlined.
 */
#ifndef GLINT_SPANS_H
#define GLINT_SPANS_H

#include "setup.h"

/** What a triangle's loops over pixels share. */
typedef struct glint_spans {
    const glint_part *part;
    uint16_t *depth;
    uint8_t *pixels;
    unsigned shift; /* binary logarithm of the tile's width */
} glint_spans;

static inline glint_spans glint_spans_of(const glint_frame *frame, const glint_workspace *workspace,
                                         const glint_part *part) {
    return (glint_spans){part, workspace->depth, workspace->pixels, frame->tile_shift_x};
}

/** A plane's value at the first column of the triangle's first row. */
static inline uint32_t glint_first_row(const glint_part *part, const glint_plane *plane) {
    return (uint32_t)glint_plane_at(plane, part->x, part->y + (int32_t)part->top);
}

/** From 1/w to depth, in their own steps: the farthest surfaces still count as nearer than nothing. */
#define GLINT_DEPTH_BIAS (1u << 15)

/** Tests depth at `place`, and stores it. @return 0 for what is hidden */
static inline int glint_is_nearest(uint8_t *place, uint32_t z) {
    uint16_t *depth = (uint16_t *)(void *)place;
    if (z >> 15 <= *depth)
        return 0;
    *depth = (uint16_t)(z >> 15);
    return 1;
}

/*
 * Most cores read and step on in one instruction: there the loops below step as they test depth, and are so many bytes
 * ahead when they store. ARMv6-M, whose stores reach nothing that lies behind, steps when it has stored.
 * glint_next_is_nearest is glint_is_nearest and the step of those ahead, glint_step that of the others.
 */
#if GLINT_SPLIT_PRODUCTS
#define GLINT_AHEAD 0

static inline int glint_next_is_nearest(uint8_t **place, uint32_t z) {
    return glint_is_nearest(*place, z);
}

static inline void glint_step(uint8_t **place) {
    *place += 2;
    GLINT_OPAQUE(*place);
}
#else
#define GLINT_AHEAD 2

static inline int glint_next_is_nearest(uint8_t **place, uint32_t z) {
    const uint32_t there = *(const uint16_t *)(const void *)*place;
    *place += GLINT_AHEAD;
    GLINT_OPAQUE(*place);
    if (z >> 15 <= there)
        return 0;
    *(uint16_t *)(void *)(*place - GLINT_AHEAD) = (uint16_t)(z >> 15);
    return 1;
}

static inline void glint_step(uint8_t **place) {
    (void)place;
}
#endif

/** Where a loop is that has tested the depth of a tile's first pixel. Compilers are not to find it anew for each. */
static inline const uint16_t *glint_ahead_of(const glint_spans *s) {
    const uint16_t *ahead = s->depth + GLINT_AHEAD / 2;
    if (GLINT_AHEAD)
        GLINT_OPAQUE(ahead);
    return ahead;
}

/** The pixel of a tile whose depth was tested last. As a difference of pixels: formats of 16 bits need no shifts then.
 */
static inline uint32_t glint_offset_of(const glint_spans *s, const uint16_t *ahead, const uint8_t *place) {
    return (uint32_t)((const uint16_t *)(const void *)place - (GLINT_AHEAD ? ahead : s->depth));
}

/** A plane's step, for one loop over a span: ARMv6-M's compiler keeps it in a register there, if not from row to row.
 */
static inline uint32_t glint_hold(uint32_t step) {
#if GLINT_SPLIT_PRODUCTS
    GLINT_OPAQUE(step);
#endif
    return step;
}

#endif
