/* SPDX-License-Identifier: MIT */
/** @file setup.h Attributes of a triangle as planes over the screen. */
#ifndef GLINT_SETUP_H
#define GLINT_SETUP_H

#include "frame.h"

/**
 * Planes of a triangle whose corners run clockwise on the screen, y down; area is twice its area, above 0.
 * Also sets what is common to the triangle's fragments.
 */
void glint_setup(glint_attributes *attributes, glint_fragments *fragments, const glint_draw *draw,
                 const glint_triangle *triangle, int32_t area, int back);

/** A plane's value at a pixel, x and y from the anchor. */
static inline int32_t glint_plane_at(const glint_plane *p, int32_t x, int32_t y) {
    return glint_add_wrap(p->start, glint_add_wrap(glint_multiply_wrap(p->dx, x), glint_multiply_wrap(p->dy, y)));
}

/** Pixel of fragment i, from the anchor. */
static inline void glint_fragment_place(const glint_frame *frame, const glint_fragments *fragments, uint32_t i,
                                        int32_t *x, int32_t *y) {
    const uint32_t offset = fragments->offset[i], mask = (uint32_t)frame->config.tile_width - 1;
    *x = fragments->tile_x + (int32_t)(offset & mask) - fragments->attributes->anchor_x;
    *y = fragments->tile_y + (int32_t)(offset >> frame->tile_shift_x) - fragments->attributes->anchor_y;
}

#endif
