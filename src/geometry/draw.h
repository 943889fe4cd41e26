/* SPDX-License-Identifier: MIT */
/** @file draw.h What a pass draws: objects, or runs of their triangles. */
#ifndef GLINT_DRAW_H
#define GLINT_DRAW_H

#include "geometry.h"

struct glint_draw;
struct glint_triangle;
struct glint_part;
struct glint_shading;

/** Draws the spans of a triangle: tests and stores depth, and stores the pixels that pass. */
typedef void glint_kernel(const glint_frame *frame, glint_workspace *workspace, const struct glint_draw *draw,
                          const struct glint_triangle *triangle, const struct glint_part *part);

/** Lights triangle i of a draw. */
typedef void glint_light_triangle(const glint_frame *frame, struct glint_draw *draw, const glint_transform *transform,
                                  uint32_t i);

/** An object, or a part of its triangles. */
typedef struct glint_draw {
    struct glint_draw *next;
    const uint16_t (*triangles)[3]; /* the first one's indices */
    glint_vertex *vertices;
    glint_position *positions;   /* null unless the object may be clipped or is lit before it is drawn */
    int16_t (*extra)[3];         /* null, or per vertex: the surface's colour, or the back's colour when lit */
    int16_t (*terms)[3];         /* null, or per vertex: the terms of fast lighting */
    int16_t *nodes;              /* null, or per vertex: what it keeps of light */
    int16_t (*facets)[3];        /* null, or colours of the triangles */
    const int16_t (*normals)[3]; /* of the mesh */
    const glint_cull *cull;      /* null, or what drops the mesh's clusters */
    uint8_t *away; /* null, or which of them face away, 1 or 0; not of parts, which leave their triangles out */
    const struct glint_shading *shading;
    const glint_evaluation *evaluation;
    glint_light_triangle *light; /* what comes before a triangle is drawn, or null */
    glint_kernel *kernel;
    glint_transform transform;
    uint32_t vertex_count;
    uint32_t unreached;      /* lights of its shading that do not reach it, by bits */
    uint32_t object;         /* index in the scene */
    uint32_t first_triangle; /* of the mesh: all are from it on, */
    uint32_t end;            /* and before this */
    const uint16_t *origin;  /* of parts: which triangles they are, from the first on */
    uint16_t first;          /* number in the pass of its first triangle */
    uint16_t count;
    uint8_t mirrored, double_sided;
    uint8_t is_costly; /* lit by fragments or nodes: what is hidden is better not begun */
    int32_t even[3];   /* of objects of one colour: that, finished */
} glint_draw;

/** Brings a vertex's normal to camera space. */
void glint_transform_normal(const glint_draw *draw, glint_vertex *vertex);

/** Brings the normals of a triangle's corners to camera space, unless they are. */
glint_light_triangle glint_transform_normals;

/** Adds a part that covers so many pixels to what a kernel drew, where that is counted. */
static inline void glint_count(const glint_workspace *workspace, glint_kernel_name kernel, uint32_t covered) {
    if (!workspace->drawn)
        return;
    workspace->drawn[kernel].parts++;
    workspace->drawn[kernel].covered += covered;
}

#endif
