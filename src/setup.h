/* SPDX-License-Identifier: MIT */
/** @file setup.h Attributes of a triangle as planes over the screen. */
#ifndef GLINT_SETUP_H
#define GLINT_SETUP_H

#include "frame.h"

/** A linear function of the pixel: value at the anchor, change per pixel in x and y. */
typedef struct glint_plane {
    int32_t start, dx, dy;
} glint_plane;

/** Depth, and up to two triples: a normal over w or a lit colour, and the surface's own colour. */
typedef struct glint_attributes {
    glint_plane depth, main[3], extra[3];
    uint8_t has_main, has_extra;
    int32_t anchor_x, anchor_y; /* pixel */
} glint_attributes;

/**
 * Planes of a triangle whose corners run clockwise on the screen, y down; area is twice its area, above 0.
 * Also sets what is common to the triangle's fragments.
 */
void glint_setup(glint_attributes *attributes, glint_fragments *fragments, const glint_draw *draw,
                 const glint_triangle *triangle, int32_t area, int back);

#endif
