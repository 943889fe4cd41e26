/* SPDX-License-Identifier: MIT */
/** @file raster.h The part of a triangle that lies in a tile. */
#ifndef GLINT_RASTER_H
#define GLINT_RASTER_H

#include "../geometry/geometry.h"
#include "../scene/config.h"

/** A linear function of the pixel: value at the anchor, change per pixel in x and y. */
typedef struct glint_plane {
    int32_t start, dx, dy;
} glint_plane;

/**
 * How a triangle's planes come from values at its corners. Narrow: the sides across from the second and the third
 * corner, turned by a right angle, in sixteenths, and 1/area = reciprocal 2^-(16 + shift). Wide: these sides times
 * 1/area, the change of the corners' barycentric coordinates per pixel, times 2^shift, 31 bits; reciprocal is 0.
 * Slender, and not narrow: the sides; reciprocal and shift are 0.
 */
typedef struct glint_gradients {
    int32_t x1, y1, x2, y2;
    int32_t reciprocal, shift;
    uint32_t reach; /* no less than the other corners lie from the first in x or y, in sixteenths, less 1 */
    int32_t to_center_x, to_center_y; /* from the first corner to the anchor's centre, in sixteenths */
} glint_gradients;

/** Pixels of one row of a tile: from column `left` to before `right`, none where they are equal. */
typedef struct glint_span {
    uint8_t left, right;
} glint_span;

/** A tile on the screen: its first pixel's centre in sixteenths, and how much of it the screen shows, in pixels. */
typedef struct glint_window {
    int32_t left, top, width, height;
    uint32_t origin; /* of corner words: triangle.h */
} glint_window;

/** Most rows of a triangle that raster walks as a whole. */
#define GLINT_SHORT_ROWS 31

/** The part of a triangle that lies in one tile. Its anchor is the pixel of the triangle's first corner. */
typedef struct glint_part {
    glint_window window;
    int32_t x, y;      /* of the tile's first pixel, from the anchor: where planes are evaluated */
    glint_plane depth; /* 1/w, Q31 */
    glint_gradients gradients;
} glint_part;

/** A triangle to draw. */
typedef struct glint_triangle {
    const glint_vertex *corners[3]; /* counter-clockwise on the screen */
    const int16_t *extra[3];        /* where the draw has extra attributes */
    uint32_t index;                 /* in its draw */
    int32_t area;                   /* twice its area, 28.4 squared, above 0 */
    int back;                       /* seen from the back */
    uint32_t away;                  /* lights that are known not to shine on it, by bits */
} glint_triangle;

/** A window that shows so many pixels from pixel x, y of the screen on. */
void glint_window_begin(glint_window *window, int x, int y, int width, int height);

#endif
