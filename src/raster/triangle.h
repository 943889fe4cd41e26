/* SPDX-License-Identifier: MIT */
/** @file triangle.h Takes three corners on the screen to the rows of a triangle in a tile, and to its attributes as
 * planes. A function that draws one span colours the pixels; the walk calls it row by row, from the top. */
#ifndef GLINT_TRIANGLE_H
#define GLINT_TRIANGLE_H

#include "../geometry/draw.h"
#include "depth.h"

/** Tiles have this width and height where the configuration says 0. */
#define GLINT_TILE_DEFAULT 32

/** Tiles are at most so wide and high. */
#define GLINT_TILE_MAX 64

/** A plane is a linear function of the pixel: its value at the anchor, and its change per pixel in x and y. */
typedef struct glint_plane {
    int32_t start, dx, dy;
} glint_plane;

/**
 * Gradients make planes of values at the corners. Of a narrow triangle they are the sides across from the second and
 * the third corner, rotated by a right angle, in sixteenths, and 1/area = reciprocal 2^-(16 + shift). Of a wide one
 * they are these sides times 1/area, which is the change of the corners' barycentric coordinates per pixel, times
 * 2^shift, 31 bits; reciprocal is 0. Of a slender one that is not narrow they are the sides; reciprocal and shift are
 * 0.
 */
typedef struct glint_gradients {
    int32_t x1, y1, x2, y2;
    int32_t reciprocal, shift;
    uint32_t reach; /* distance of the other corners from the first in x or y, in sixteenths, less 1, or more */
    int32_t to_center_x, to_center_y; /* from the first corner to the anchor's centre, in sixteenths */
} glint_gradients;

/** A span is the pixels of one row of a tile from column `left` to before `right`. It is empty where they are equal. */
typedef struct glint_span {
    uint8_t left, right;
} glint_span;

/** A window is a tile on the screen: the centre of its first pixel in sixteenths, and its visible size in pixels. */
typedef struct glint_window {
    int32_t left, top, width, height;
    uint32_t origin; /* of corner words */
} glint_window;

/** A small triangle has at most so many rows. */
#define GLINT_SHORT_ROWS 31

/** With samples, slopes also serve triangles of up to so many rows, whose corners lie within so many sixteenths of a
 * pixel of the top one in x: sums of products of differences stay below 3 2^28. */
#define GLINT_LONG_ROWS 63
#define GLINT_LONG_DX 1536

/** A part of a triangle lies in one tile. Its anchor is the pixel of the triangle's first corner. */
typedef struct glint_part {
    glint_window window;
    int32_t x, y;      /* of the tile's first pixel, from the anchor: where planes are evaluated */
    glint_plane depth; /* 1/w, Q31 */
    glint_gradients gradients;
} glint_part;

/** This is a triangle to draw. */
typedef struct glint_triangle {
    const glint_vertex *corners[3]; /* counter-clockwise on the screen */
    const int16_t *extra[3];        /* null unless the draw has extra attributes */
    uint32_t index;                 /* in its draw */
    int32_t area;                   /* twice its area, 28.4 squared, above 0 */
    int back;                       /* whether it is seen from the back */
    uint32_t away;                  /* lights that do not shine on it, by bits */
} glint_triangle;

/** Begins a window that shows so many pixels from pixel x, y of the screen on. */
void glint_window_begin(glint_window *window, int x, int y, int width, int height);

/* ---- Planes ---- */

/** Sets gradients, area and depth plane of a triangle from its corners, counter-clockwise; the rest of the part
 * stays. */
void glint_setup(glint_part *part, glint_triangle *triangle);

/** Begins the plane of an attribute that is a0, a1, a2 at the corners; these are below 2^31 apart. Slivers have slopes
 * above 2^31, which wrap, as their values do. */
void glint_plane_begin(glint_plane *plane, const glint_gradients *gradients, int32_t a0, int32_t a1, int32_t a2);

/** Up to this slenderness a triangle's polynomials keep their digits. Planes of others use whole slopes. */
#define GLINT_SLENDER 7

/** Returns the slenderness: twice the bits of a triangle's longest side, less those of its area. An equilateral one has
 * at most 2. */
static inline int32_t glint_slenderness(const glint_gradients *gradients, int32_t area) {
    const int32_t side_bits = 32 - (int32_t)glint_leading_zeros(gradients->reach + 1);
    return 2 * side_bits - 31 + (int32_t)glint_leading_zeros((uint32_t)area);
}

/** Returns a plane's value at a pixel, x and y from the anchor. */
static inline int32_t glint_plane_at(const glint_plane *p, int32_t x, int32_t y) {
    return glint_add_wrap(p->start, glint_add_wrap(glint_multiply_wrap(p->dx, x), glint_multiply_wrap(p->dy, y)));
}

/** Returns the shift that brings the largest 1/w of the corners, none of them 0, to 2^30 .. 2^31. */
static inline unsigned glint_find_room(const glint_vertex *const v[3]) {
    return glint_leading_zeros((uint32_t)(v[0]->inverse_w | v[1]->inverse_w | v[2]->inverse_w)) - 1;
}

/** May rounding take the plane of 1/w below 0? It is off by 2^-10 of the corners' difference and some pixels' steps;
 * the test uses some times that. */
static inline int glint_is_deep(const glint_triangle *triangle) {
    const int32_t a = triangle->corners[0]->inverse_w, b = triangle->corners[1]->inverse_w,
                  c = triangle->corners[2]->inverse_w;
    const int32_t least = glint_least_of(a, b, c), most = glint_most_of(a, b, c);
    return least < 1 << 21 && least < glint_most(glint_shift_right(most, 6), 1 << 17);
}

/* ---- Rows ---- */

/**
 * A corner is one word, 2^16 y + 2^15 + x in sixteenths of a pixel, 15 more than from the centre of the tile's first
 * pixel. So the whole part of y is the first row of centres at or below the corner, and that of x the first column. The
 * 2^15 keeps an x left of the tile from borrowing from y.
 */
typedef int32_t glint_corner_word;

/** 1/area of a small triangle is reciprocal 2^(zeros - 47). Here area is twice the triangle's in 28.4 squared. */
typedef struct glint_area {
    int32_t reciprocal;
    uint32_t zeros;
} glint_area;

/** These are the words of a triangle's corners, counter-clockwise from the top one on. */
typedef struct glint_corners {
    glint_corner_word a, b, c;
    uint32_t top;    /* which of the triangle's corners is the top one: 0, 1 or 2 */
    glint_area area; /* of a small triangle that has slopes */
} glint_corners;

/**
 * Slopes give the change of an attribute of a small triangle per pixel. With d1 the difference between the second and
 * the first corner, and d2 that between the third and the first, it is (d1 x1 + d2 x2) 2^-14 in x, and likewise of y1
 * and y2 in y. Likewise start1 and start2 give the difference to the first corner at the centre of the pixel at or
 * after this corner. All are modulo 2^32, so that sums are right at the pixels of slivers too, where they fit. They are
 * off by half a step of 2^-14 of a difference a pixel.
 */
typedef struct glint_slopes {
    int32_t x1, y1, x2, y2, start1, start2;
    int32_t column, row; /* that pixel, in the tile */
} glint_slopes;

/** A side on its way down has the column where it crosses a row, Q20, and its change from row to row. */
typedef struct glint_side {
    int32_t x, slope;
} glint_side;

/** These rows of a small triangle are not drawn yet: from `row` to before `stop` between two sides, and from there to
 * before `end` with another one, which begins at that corner. */
typedef struct glint_small_rows {
    glint_side left, right; /* at `row` */
    int32_t row, stop, end; /* of the tile; `row` is before `stop` */
    glint_side third;       /* at `stop`, */
    int is_left;            /* and whether it takes the place of the left one */
} glint_small_rows;

/** glint_row_walk.has_slopes is this until glint_begin_depth has run. */
#define GLINT_SLOPES_UNKNOWN 2

/** A walk takes a triangle through a tile. It holds what the functions that draw spans need. */
typedef struct glint_row_walk {
    /* These belong to the tile. */
    const glint_frame *frame;
    glint_workspace *workspace;
    glint_part *part; /* its window; depth and gradients of the triangle where glint_setup has run */
    uint16_t *depth;
    void *pixels;
    uintptr_t from_depth; /* offset to pixels of 16 bits, from the position of a loop over depth (glint_ahead) */
    uint32_t shift;       /* binary logarithm of the tile's width */
    uint8_t colour_bits;  /* bits of colours at corners that are linear on the screen, or 0: all are divided */
    uint8_t is_exacting;  /* whether the format has little room for the rounding of such colours */
    /* These belong to the triangle. */
    const glint_draw *draw;
    glint_draw_span *draw_span; /* of glint_walk_triangle */
    glint_triangle triangle;    /* its corners, counter-clockwise on the screen */
    glint_corners corners;      /* the same from the top one on, set by glint_begin_triangle */
    glint_small_rows rows;      /* of a small triangle */
    glint_slopes slopes;        /* valid where has_slopes, set by glint_begin_depth */
    uint8_t has_slopes; /* whether slopes serve it, and z is valid; else gradients do, once glint_begin_depth has run */
    uint8_t is_deep;    /* whether rounding may take the plane of 1/w below 0 */
    const glint_vertex *from_top[3]; /* its corners in the order of `corners` */
    /* These belong to its pixels: values at the tile's first pixel, and changes per pixel in x and y. */
    glint_plane z;             /* 1/w, Q31, with GLINT_DEPTH_BIAS */
    uint32_t packed;           /* the pixel of a flat colour */
    glint_lanes lanes[3];      /* a colour; a flat one uses the first alone */
    glint_lanes gloss[2];      /* highlights on a texture, the same in all rows; light/cells.c */
    glint_plane w, channel[3]; /* of colours that are divided: light/draw.c; of normals: light/lamps.c */
    struct glint_lamp_list *list;
    struct glint_sun_triangle *suns;
    struct glint_texture_map *map; /* of a triangle that wears a texture */
    const glint_draw *lit;         /* the draw whose lights are in the workspace, or null */
} glint_row_walk;

/** Draws on this depth and these pixels from now on. */
static inline void glint_walk_on(glint_row_walk *walk, uint16_t *depth, void *pixels) {
    walk->depth = depth;
    walk->pixels = pixels;
    walk->from_depth = (uintptr_t)pixels - (uintptr_t)glint_ahead(depth);
}

/** Begins with the triangles of a tile, the part's window. */
static inline void glint_walk_begin_tile(glint_row_walk *walk, const glint_frame *frame, glint_workspace *workspace,
                                         glint_part *part) {
    walk->frame = frame;
    walk->workspace = workspace;
    walk->part = part;
    glint_walk_on(walk, workspace->depth, workspace->pixels);
    walk->shift = frame->tile_shift_x;
    walk->lit = 0;
}

/** A triangle has no rows in the tile, or it is small, or it is large. */
typedef enum glint_begun { GLINT_NO_ROWS, GLINT_IS_SMALL, GLINT_IS_LARGE } glint_begun;

/** Begins a triangle: finds its corners, the sides of a small one, and where slopes serve it, area and plane of 1/w. */
glint_begun glint_begin_triangle(glint_row_walk *walk);

/** Moves on to the first row of a small triangle that has a visible pixel. @return 0 where there is none */
int glint_find_visible_row(glint_row_walk *walk);

/** Walks the rows of a small triangle, from walk->rows on. */
void glint_walk_small(glint_row_walk *walk);

/** Returns 1/w, with GLINT_DEPTH_BIAS, of the tile's pixel at a row and a column; modulo 2^32. */
static GLINT_INLINE uint32_t glint_z_at(const glint_row_walk *walk, int32_t row, int32_t column) {
    return (uint32_t)walk->z.start + (uint32_t)walk->z.dy * (uint32_t)row + (uint32_t)walk->z.dx * (uint32_t)column;
}

/** Returns the interpolated colour of that pixel. */
static GLINT_INLINE glint_lanes glint_lanes_at(const glint_row_walk *walk, int32_t row, int32_t column) {
    const glint_lanes *l = walk->lanes;
    const uint32_t x = (uint32_t)column, y = (uint32_t)row;
    return (glint_lanes){l[0].red_blue + l[1].red_blue * x + l[2].red_blue * y,
                         l[0].green + l[1].green * x + l[2].green * y};
}

/** Returns the highlights on a texture at a column. */
static GLINT_INLINE glint_lanes glint_gloss_at(const glint_row_walk *walk, int32_t column) {
    const glint_lanes *g = walk->gloss;
    const uint32_t x = (uint32_t)column;
    return (glint_lanes){g[0].red_blue + g[1].red_blue * x, g[0].green + g[1].green * x};
}

/** Sets up 1/w of a triangle whose rows are walked: by slopes, or else by gradients. */
void glint_begin_depth(glint_row_walk *walk);

/**
 * Walks the rows of a triangle in its tile. Coverage is exact: an edge gives each row the first column whose centre is
 * not left of it, for left and right edges alike, so that a shared edge gives each pixel to one side.
 */
void glint_walk_triangle(glint_row_walk *walk);

/** Walks the rows of a triangle that has been begun. */
void glint_walk_begun(glint_row_walk *walk, glint_begun begun);

#endif
