/* SPDX-License-Identifier: MIT */
/**
 * @file texture.h
 * Textures: which texel a pixel shows.
 *
 * Coordinates over w are linear on the screen, as 1/w is (Heckbert, 1989). Over small triangles coordinates are
 * quadratics on the screen: linear ones less their product with the change of 1/w. Over others they are divided
 * once for each run of 4 to 32 aligned columns, in which they are quadratics of the column, or at each pixel. Neither
 * tiles nor what is hidden change that.
 *
 * | quantity | format |
 * | --- | --- |
 * | coordinate of a texture | uint32, its width or height being 2^32: they repeat by themselves |
 * | 1/w, and coordinates over w, on the screen | int32, in a unit of the triangle: 1/w is at most 2^30 to 2^31 |
 */
#ifndef GLINT_TEXTURE_H
#define GLINT_TEXTURE_H

#include "../light/suns.h"
#include "../light/wear.h"
#include "../pixel/format.h"
#include "../raster/triangle.h"

/** A run of pixels of a row has coordinates that are quadratics: value + slope x + curve x^2, x columns from an origin.
 */
typedef struct glint_texture_run {
    uint32_t value, slope, curve;
} glint_texture_run;

/** The map of a triangle takes pixels of its tile to coordinates. */
typedef struct glint_texture_map {
    const glint_texture *texture;
    uint32_t across, down, rows;   /* for glint_texel_number */
    glint_stepped_quadratic at[2]; /* u and v at a pixel */
    uint32_t bend[2];
    glint_texture_run run[2];
    int32_t row, left, right, origin; /* of the run: its row, the columns that it serves, and that of x = 0 */
    int32_t x;                        /* the tile's first column on the screen */
    union {
        struct {
            glint_quadratic of[2];
            int32_t row; /* their first one */
        } quadratic;
        struct {
            uint32_t first[2];          /* coordinates of the first corner, and a quotient, Q28, times 2^up; */
            glint_plane over[2], under; /* its numerators, and 1/w, from the tile's first pixel on */
            int32_t part;               /* the part of `row` that was looked at last */
            uint8_t up[2];
            uint8_t longest, shift; /* sizes of runs, binary logarithms: of parts, and in this one; 0 for pixels */
        } quotient;
    } by;
    uint8_t is_begun;
    uint8_t is_quadratic;     /* runs are rows of quadratics, else quotients */
    uint8_t is_even;          /* light is the same at all pixels, and known */
    uint8_t is_plain;         /* texels repeat, and the nearest one shows */
    uint8_t is_bilinear;      /* colours of four texels are mixed */
    uint8_t beyond[2];        /* coordinates are over 2^beyond, and signed, where the texture does not repeat; else 0 */
    int8_t to_texels[2];      /* coordinates shifted right by this are texels, 2^-8 */
    uint8_t is_packed;        /* pixels are those of RGB565, */
    uint8_t swaps;            /* whose bytes are swapped, */
    uint8_t is_quick;         /* and spans have functions of their own, */
    uint8_t kind;             /* which show texels of this kind: TEXELS_UNLIT... */
    int32_t light[3];         /* that light, Q27 */
    glint_draw_span *visible; /* draws spans without holes */
} glint_texture_map;

/** Begins the map of the walk's triangle, whose depth has been begun. */
void glint_begin_map(const glint_row_walk *walk, glint_texture_map *map);

/** Finds the run of a pixel, and does unless it is the last one. */
void glint_find_run(glint_texture_map *map, int32_t row, int32_t column);
static inline void glint_check_run(glint_texture_map *map, int32_t row, int32_t column) {
    if (row != map->row || column < map->left || column >= map->right)
        glint_find_run(map, row, column);
}

/** Finds the coordinates of a pixel, map->at, which may be stepped up to before column map->right. */
void glint_find_coordinates(glint_texture_map *map, int32_t row, int32_t column);

/** Returns the number of the texel at coordinates of a map that is plain. A texture of one column has u = 0. */
static inline uint32_t glint_texel_number(const glint_texture_map *map, uint32_t u, uint32_t v) {
    return (v >> map->down & map->rows) + (u >> map->across);
}

/** Returns a coordinate, x columns from the origin of a run. */
static inline uint32_t glint_coordinate_at(const glint_texture_run *run, uint32_t x) {
    return run->value + x * (run->slope + x * run->curve);
}

/** Returns a coordinate in texels, 2^-8. */
static inline int32_t glint_texel_position(const glint_texture_map *map, int k, uint32_t coordinate) {
    const int32_t down = map->to_texels[k];
    if (!map->beyond[k])
        return (int32_t)(coordinate >> down);
    if (down >= 0)
        return glint_shift_right((int32_t)coordinate, (unsigned)down);
    const int32_t most = 1 << (30 + down);
    return glint_most(glint_least((int32_t)coordinate, most), -most) * (1 << -down);
}

/** Return the number of a texel in its row, and that of the first texel of a row, beyond the edges or not. */
static inline uint32_t glint_texel_column(const glint_texture_map *map, int32_t x) {
    const int32_t last = map->texture->width - 1;
    return (uint32_t)(map->beyond[0] ? glint_least(glint_most(x, 0), last) : x & last);
}
static inline uint32_t glint_texel_row(const glint_texture_map *map, int32_t y) {
    const int32_t last = map->texture->height - 1;
    return (uint32_t)(map->beyond[1] ? glint_least(glint_most(y, 0), last) : y & last) * map->texture->width;
}

extern const glint_texture_stage glint_textures;

#endif
