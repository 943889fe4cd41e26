/* SPDX-License-Identifier: MIT */
/** @file draw.h What a pass draws: objects, or runs of their triangles. */
#ifndef GLINT_DRAW_H
#define GLINT_DRAW_H

#include "../glint_extras.h"
#include "geometry.h"

struct glint_draw;
struct glint_triangle;
struct glint_part;
struct glint_shading;

/**
 * A colour in the levels of a format, as two words that are interpolated: blue in the high half of one and red in its
 * low half, green in the other. Of each half, and of the whole word of green, the high bits are the level, as many as
 * the format has for the channel; the rest is its fraction. Formats of luma have that in place of green. What is added
 * to a colour before it is cut off, half a level or a threshold of dithering, never carries into the next channel.
 */
typedef struct glint_lanes {
    uint32_t red_blue, green;
} glint_lanes;

struct glint_row_walk;

/** Draws the pixels of a row of the tile from column `left` to before `right`; there is at least one. */
typedef void glint_draw_span(struct glint_row_walk *walk, int32_t row, int32_t left, int32_t right);

/** Lights triangle i of a draw. */
typedef void glint_light_triangle(const glint_frame *frame, struct glint_draw *draw, const glint_transform *transform,
                                  uint32_t i);

/** An object, or a part of its triangles. */
typedef struct glint_draw {
    struct glint_draw *next;
    glint_position *positions; /* null unless the object may be clipped or is lit before it is drawn */
    int16_t (*extra)[3];       /* null, or per vertex: the surface's colour, or the back's colour when lit */
    int16_t (*facets)[3];      /* null, or the levels of the triangles' colours */
    uint8_t *away; /* null, or which of the clusters face away, 1 or 0; not of parts, which leave their triangles out */
    const uint16_t *origin;         /* of parts: which triangles they are, from the first on */
    const uint16_t (*triangles)[3]; /* the first one's indices: what stands before them begins as 0 */
    glint_vertex *vertices;
    struct glint_sun_term *terms; /* what vertices keep of lights: light/suns.h */
    const int16_t (*normals)[3];  /* of the mesh */
    const glint_cull *cull;       /* null, or what drops the mesh's clusters */
    const struct glint_shading *shading;
    const glint_evaluation *evaluation;
    glint_light_triangle *light;                        /* what comes before a triangle is drawn, or null */
    void (*draw_triangle)(struct glint_row_walk *walk); /* draws the part of a triangle that lies in a tile */
    uint32_t vertex_count;
    uint32_t unreached;      /* lights of its shading that do not reach it, by bits */
    uint32_t object;         /* index in the scene */
    uint32_t first_triangle; /* of the mesh: all are from it on, */
    uint32_t end;            /* and before this */
    uint16_t first;          /* number in the pass of its first triangle */
    uint16_t count;
    uint8_t mirrored, double_sided;
    uint8_t is_wide;   /* 1/w of a triangle may differ by a factor above 8, or rays are parallel */
    uint8_t is_costly; /* lit by fragments: what is hidden is better not begun */
    glint_lanes flat;  /* of objects of one colour: that, and its pixel */
    uint32_t packed;
    glint_transform transform;
} glint_draw;

/** Brings a vertex's normal to camera space. */
void glint_transform_normal(const glint_draw *draw, glint_vertex *vertex);

/** Brings the normals of a triangle's corners to camera space, unless they are. */
glint_light_triangle glint_transform_normals;

#endif
