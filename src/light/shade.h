/* SPDX-License-Identifier: MIT */
/** @file shade.h Fragments, and the light that falls on them. */
#ifndef GLINT_SHADE_H
#define GLINT_SHADE_H

#include "../raster/raster.h"
#include "shading.h"

struct glint_draw;

/** Fragments shaded together. */
#define GLINT_FRAGMENTS_MAX 9

/** Up to two triples: a normal over w or a lit colour, and the surface's own colour. */
typedef struct glint_attributes {
    glint_plane main[3], extra[3];
    glint_plane depth; /* 1/w 2^(scale - 1) of far triangles, below */
} glint_attributes;

/**
 * The scale, below, above which a triangle is far, its corners more than 16 times as far as the nearest geometry. A
 * plane of 1/w is off by up to a step for each pixel from the first corner, of up to 2^9: of others, whose 1/w has 28
 * bits and more, by 2^-18 at most.
 */
#define GLINT_FAR_SCALE 3

/** Fragments of one triangle in a tile; or vertices or a triangle's middle, which have no place. */
typedef struct glint_fragments {
    uint32_t count;
    const glint_part *part;
    int8_t column[GLINT_FRAGMENTS_MAX], row[GLINT_FRAGMENTS_MAX]; /* from the tile's first pixel */
    uint32_t scale;                                               /* attributes are interpolated over w 2^scale */
    uint32_t away;                                                /* known not to shine on the triangle: light bits */
    const glint_attributes *attributes;
    int32_t inverse_w[GLINT_FRAGMENTS_MAX];
    int32_t ray[GLINT_FRAGMENTS_MAX][3];     /* towards the eye: minus the position times 1/w, Q12 */
    int16_t normal[GLINT_FRAGMENTS_MAX][3];  /* unit */
    int16_t view[GLINT_FRAGMENTS_MAX][3];    /* unit, towards the eye */
    uint8_t is_gated;                        /* lights that they face away from need not be found */
    int16_t light[GLINT_FRAGMENTS_MAX][3];   /* unit, towards a light that has a position */
    uint16_t strength[GLINT_FRAGMENTS_MAX];  /* of that light, Q15 */
    uint32_t length[GLINT_FRAGMENTS_MAX];    /* distance to it in the ray's units, times UNIT / 2^15: this times */
    int8_t exponent[GLINT_FRAGMENTS_MAX];    /* 2^exponent; 0 where it is right there */
    int16_t surface[GLINT_FRAGMENTS_MAX][3]; /* colours of their own */
    uint32_t colour[GLINT_FRAGMENTS_MAX][3];
} glint_fragments;

/** Fragments of a triangle as they are gathered, and its attributes. */
typedef struct glint_gathered {
    glint_fragments fragments;
    glint_attributes attributes;
} glint_gathered;

/** Finds the colours of fragments that lie in a triangle of a draw, Q23. */
void glint_shade(const glint_frame *frame, glint_fragments *fragments, const struct glint_draw *draw);

/** Ambient and every light: colours of fragments with normals, rays, and colours of their own if has_surface. */
void glint_light_all(const glint_frame *frame, glint_fragments *fragments, const glint_shading *shading,
                     int has_surface);

/** A lit colour, clamped at 1, 1 = GLINT_COLOUR_ONE. */
void glint_clamp_colour(const uint32_t colour[3], int16_t out[3]);

/** V at fragments: towards the eye for the local viewer, straight back for the infinite one. */
void glint_find_view_vectors(const glint_view *view, glint_fragments *fragments);

/** Are rays towards the eye needed under these lights? */
int glint_needs_rays(const glint_view *view, const glint_shading *shading);

#endif
