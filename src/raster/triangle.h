/* SPDX-License-Identifier: MIT */
/**
 * @file triangle.h
 * From three corners on the screen to the rows of a triangle in a tile. Whatever colours its pixels is a function that
 * draws one span; the walk calls it row by row, from the top.
 */
#ifndef GLINT_TRIANGLE_H
#define GLINT_TRIANGLE_H

#include "../geometry/draw.h"
#include "depth.h"
#include "setup.h"

/**
 * A corner as one word, 2^16 y + 2^15 + x in sixteenths of a pixel, 15 more than from the centre of the tile's first
 * pixel: the whole part of y is then the first row of centres at or below the corner, and that of x the first column.
 * The 2^15 keeps an x left of the tile from borrowing from y.
 */
typedef int32_t glint_corner_word;

/** 1/area = reciprocal 2^(zeros - 47) of a small triangle, area being twice that in 28.4 squared. */
typedef struct glint_area {
    int32_t reciprocal;
    uint32_t zeros;
} glint_area;

/** A triangle's corners, counter-clockwise from the top one on: their words. */
typedef struct glint_corners {
    glint_corner_word a, b, c;
    uint32_t top;    /* which of the triangle's corners is the top one: 0, 1 or 2 */
    glint_area area; /* of a small triangle that has slopes */
} glint_corners;

/**
 * How an attribute of a small triangle changes per pixel, from its differences d1 and d2 between the second and the
 * first corner, and between the third and the first: (d1 x1 + d2 x2) 2^-14 in x, the same of y1 and y2 in y; and by how
 * much it differs from the first corner at the centre of the pixel at or after that: the same of start1 and start2. All
 * are modulo 2^32, so that sums are right at the pixels of slivers too, where they fit. Off by half a step of 2^-14 of
 * a difference a pixel.
 */
typedef struct glint_slopes {
    int32_t x1, y1, x2, y2, start1, start2;
    int32_t column, row; /* that pixel, in the tile */
} glint_slopes;

/** A side on its way down: the column where it crosses a row, Q20, and its change from row to row. */
typedef struct glint_side {
    int32_t x, slope;
} glint_side;

/**
 * The rows of a small triangle that are not drawn yet: from `row` to before `stop` between two sides, and from there to
 * before `end` with another one, which begins at that corner.
 */
typedef struct glint_small_rows {
    glint_side left, right; /* at `row` */
    int32_t row, stop, end; /* of the tile; `row` is before `stop` */
    glint_side third;       /* at `stop`, */
    int is_left;            /* and whether it takes the place of the left one */
} glint_small_rows;

/** glint_row_walk.has_slopes, until glint_begin_depth has run. */
#define GLINT_SLOPES_UNKNOWN 2

/** A triangle on its way through a tile: what the functions that draw its spans know. */
typedef struct glint_row_walk {
    /* Of the tile */
    const glint_frame *frame;
    glint_workspace *workspace;
    glint_part *part; /* its window; depth and gradients of the triangle where glint_setup has run */
    uint16_t *depth;
    void *pixels;
    uintptr_t from_depth; /* to pixels of 16 bits, from where a loop over them points to (glint_ahead) */
    uint32_t shift;       /* binary logarithm of the tile's width */
    uint8_t colour_bits;  /* of colours at corners that are linear on the screen, or 0: all are divided */
    uint8_t is_exacting;  /* the format has little room for what such colours are rounded by */
    /* Of the triangle */
    const glint_draw *draw;
    glint_draw_span *draw_span; /* of glint_walk_triangle */
    glint_triangle triangle;    /* its corners, counter-clockwise on the screen */
    glint_corners corners;      /* the same, from the top one on; of glint_begin_triangle */
    glint_small_rows rows;      /* of a small triangle */
    glint_slopes slopes;        /* where has_slopes, of glint_begin_depth */
    uint8_t has_slopes;         /* slopes serve it, and z is known; else gradients do, once glint_begin_depth ran */
    uint8_t is_deep;            /* rounding may take the plane of 1/w below 0 */
    const glint_vertex *from_top[3]; /* its corners in the order of `corners` */
    /* Of its pixels: from the tile's first pixel on, and changes per pixel in x and y */
    glint_plane z;             /* 1/w, Q31, with GLINT_DEPTH_BIAS */
    uint32_t packed;           /* the pixel of a flat colour */
    glint_lanes lanes[3];      /* a colour; a flat one has the first alone */
    glint_plane w, channel[3]; /* of colours that are divided: light/draw.c; of normals: light/lamps.c */
    struct glint_lamp_list *list;
    struct glint_sun_triangle *suns;
    const glint_draw *lit; /* the draw whose lights stand in the workspace, or null */
} glint_row_walk;

/** Begins with the triangles of a tile, the part's window. */
static inline void glint_walk_begin_tile(glint_row_walk *walk, const glint_frame *frame, glint_workspace *workspace,
                                         glint_part *part) {
    walk->frame = frame;
    walk->workspace = workspace;
    walk->part = part;
    walk->depth = workspace->depth;
    walk->pixels = workspace->pixels;
    walk->from_depth = (uintptr_t)walk->pixels - (uintptr_t)glint_ahead(walk->depth);
    walk->shift = frame->tile_shift_x;
    walk->lit = 0;
}

/** A triangle has no rows in the tile, it is small, or it is large. */
typedef enum glint_begun { GLINT_NO_ROWS, GLINT_IS_SMALL, GLINT_IS_LARGE } glint_begun;

/** Begins a triangle: finds its corners, of a small one the sides, and where slopes serve it, area and plane of 1/w. */
glint_begun glint_begin_triangle(glint_row_walk *walk);

/** Moves on to the first row of a small triangle that has a visible pixel. @return 0 where there is none */
int glint_find_visible_row(glint_row_walk *walk);

/** Walks the rows of a small triangle, from walk->rows on. */
void glint_walk_small(glint_row_walk *walk);

/** Returns 1/w, with GLINT_DEPTH_BIAS, of the tile's pixel at a row and a column; modulo 2^32. */
static inline uint32_t glint_z_at(const glint_row_walk *walk, int32_t row, int32_t column) {
    return (uint32_t)walk->z.start + (uint32_t)walk->z.dy * (uint32_t)row + (uint32_t)walk->z.dx * (uint32_t)column;
}

/** Returns the interpolated colour of that pixel. */
static inline glint_lanes glint_lanes_at(const glint_row_walk *walk, int32_t row, int32_t column) {
    const glint_lanes *l = walk->lanes;
    const uint32_t x = (uint32_t)column, y = (uint32_t)row;
    return (glint_lanes){l[0].red_blue + l[1].red_blue * x + l[2].red_blue * y,
                         l[0].green + l[1].green * x + l[2].green * y};
}

/** Sets up 1/w of a triangle whose rows are walked: by slopes, or else by gradients. */
void glint_begin_depth(glint_row_walk *walk);

/**
 * Walks the rows of a triangle in its tile. Coverage is exact: an edge gives each row the first column whose centre is
 * not left of it, for left and right edges alike, so that a shared edge gives each pixel to one side.
 */
void glint_walk_triangle(glint_row_walk *walk);

/** The same of one that has been begun. */
void glint_walk_begun(glint_row_walk *walk, glint_begun begun);

#endif
