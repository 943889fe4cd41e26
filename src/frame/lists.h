/* SPDX-License-Identifier: MIT */
/** @file lists.h Lists of the triangles that tiles may show. */
#ifndef GLINT_LISTS_H
#define GLINT_LISTS_H

#include "frame.h"

/** What the reference count may come to. */
static inline uint32_t glint_most_references(const glint_frame *frame) {
    const size_t most =
        (size_t)((const uint8_t *)frame->clipped - (const uint8_t *)frame->references) / sizeof(glint_reference);
    return most < GLINT_LIST_END ? (uint32_t)most : GLINT_LIST_END;
}

/** A triangle's reference at the end of a list, as one word. */
static inline uint32_t glint_reference_to(uint32_t triangle) {
    return triangle << 16 | GLINT_LIST_END;
}

/** Puts a reference, number `here`, behind a tile's list. */
static inline void glint_list_put(glint_reference *references, uint32_t here, uint32_t tile, uint32_t reference) {
    GLINT_OPAQUE(reference); /* else its halves are stored one by one */
    references[here].next = (uint16_t)reference;
    references[here].triangle = (uint16_t)(reference >> 16);
    references[references[tile].triangle].next = (uint16_t)here;
    GLINT_OPAQUE(here); /* else it is cut to a half first */
    references[tile].triangle = (uint16_t)here;
}

/** Appends a reference to a tile's list, counted in the pass; there is room. */
static inline void glint_list_append(glint_frame *frame, uint32_t tile, uint32_t reference) {
    const uint32_t here = frame->reference_count;
    frame->reference_count = here + 1;
    glint_list_put(frame->references, here, tile, reference);
}

/** Lights a triangle that is going to be seen, as far as that comes before it is drawn, unless its corners are lit. */
static inline void glint_list_light(const glint_frame *frame, glint_draw *draw, const glint_vertex *const v[3],
                                    uint32_t triangle) {
    if (draw->light && !(v[0]->flags & v[1]->flags & v[2]->flags & GLINT_VERTEX_NORMAL))
        draw->light(frame, draw, &draw->transform, triangle);
}

/** Bins a triangle that is whole and faces the eye, wherever it lies. @return 0 when the arena is full. */
int glint_bin_whole(glint_frame *frame, glint_draw *draw, uint32_t triangle);

/** glint_bin_some of a draw that is nowhere clipped, in tiles from the screen's first on. */
int glint_bin_plain(glint_frame *frame, glint_draw *draw, uint32_t next, uint32_t end);

#endif
