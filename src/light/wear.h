/* SPDX-License-Identifier: MIT */
/** @file wear.h What light asks of the texture that a surface wears. The stage that answers is linked with any type of
 * a texture: ../texture. */
#ifndef GLINT_WEAR_H
#define GLINT_WEAR_H

#include "../geometry/draw.h"
#include "../pixel/format.h"
#include "../raster/triangle.h"

/** Multiplies the words of a row's pixels by a texture's colours. `begin` is the offset of the row's first pixel. */
typedef void glint_multiply_words(const glint_row_walk *walk, int32_t row, uint32_t begin, glint_spread *p,
                                  const glint_spread *end);

struct glint_cell_rows;
struct glint_lit_fragment;

/** Draws the parts of cached spans in a square of 2^bits x 2^bits pixels between four nodes. */
typedef void glint_draw_patch(const struct glint_cell_rows *r, uint32_t x, uint32_t y, unsigned bits, const int16_t *a,
                              const int16_t *b, const int16_t *below_a, const int16_t *below_b);
glint_draw_patch glint_draw_worn_patch GLINT_IF_LINKED;

/** Sets node n of a row of cells from a fragment whose light is to be multiplied by a texture. */
typedef void glint_set_cell_node(struct glint_cell_rows *r, int k, uint32_t n, const struct glint_lit_fragment *f);
glint_set_cell_node glint_set_worn_node GLINT_IF_LINKED;

/** This stage is linked with any type of a texture. */
typedef struct glint_texture_stage {
    /** Checks the texture of an object. @return GLINT_ERROR_NULL, _FLAGS or _TEXTURE, or GLINT_OK */
    glint_status (*check)(const glint_material *material, const glint_mesh *mesh);
    /** Draws the part of a triangle that lies in a tile. */
    void (*draw)(glint_row_walk *walk);
    /** Draws that part in a light that is the same at all pixels, a spread word. */
    void (*draw_even)(glint_row_walk *walk, glint_begun begun, uint32_t light);
    /** Draw a span whose light is linear on the screen, walk->lanes; one where highlights, walk->gloss, are added to
     * that, and light may exceed 1; and one whose light is divided at each pixel. */
    glint_draw_span *smooth, *glowing, *divided;
    /** Leaves holes out of spans, once walk->draw_span has been chosen. */
    void (*leave_holes)(glint_row_walk *walk);
    /** Returns whether there is a hole at a pixel. */
    int (*is_hole)(glint_row_walk *walk, int32_t row, int32_t column);
    /** Finds the colour at a pixel, 1 = GLINT_COLOUR_ONE. */
    void (*find)(const glint_row_walk *walk, int32_t row, int32_t column, int16_t colour[3]);
    glint_multiply_words *multiply;
    /** Returns what draws the spans of a triangle under one sun in one loop, or null. */
    glint_draw_span *(*choose_sun)(const glint_row_walk *walk);
    /** Cells are linked with light at fragments: these are null elsewhere. */
    glint_set_cell_node *set_node;
    glint_draw_patch *draw_patch;
} glint_texture_stage;

/** Returns a texel of given number. */
typedef uint32_t glint_read_texel(const void *texels, const uint16_t *palette, uint32_t number);

/** Texels show as they are, times walk->lanes, or that plus walk->gloss. */
enum { TEXELS_UNLIT, TEXELS_SHADED, TEXELS_GLOWING, TEXELS_KINDS };

struct glint_texture_type {
    uint8_t bits; /* of a texel */
    uint8_t has_palette;
    glint_read_texel *read; /* as it is stored */
    /** Finds the colour at coordinates, 1 = GLINT_COLOUR_ONE. */
    void (*sample)(const struct glint_texture_map *map, uint32_t u, uint32_t v, int16_t colour[3]);
    /** Draw spans of RGB565 of each kind from the nearest texels of a texture that repeats, with bytes as they are and
     * swapped; and of walk->map's kind between four texels. Null where texels have other colours. */
    glint_draw_span *spans[TEXELS_KINDS][2], *mixed;
    /** Draw spans of RGB565 of such texels under one sun, as glint_draw_sun_list does; null in a library built for
     * size.
     */
    glint_draw_span *sun[2];
    /** Multiplies words by the nearest texels of a texture that repeats; null where texels have other colours. */
    glint_multiply_words *multiply;
    const glint_texture_stage *stage;
};

/** Corners and facets have half their light, and this more, where a texture multiplies it: so rounding never carries
 * from one of two numbers that are stepped in a word to the other. */
#define GLINT_WORN_MARGIN 128

/** Returns whether a draw wears a texture with holes. */
static inline int glint_has_holes(const glint_draw *draw) {
    return draw->texture && draw->texture->flags & GLINT_TEXTURE_HAS_KEY;
}

/** Leaves the holes of a texture out of spans, once walk->draw_span has been chosen. */
static inline void glint_leave_holes(glint_row_walk *walk) {
    if (walk->draw->texture)
        walk->draw->texture->type->stage->leave_holes(walk);
}

#endif
