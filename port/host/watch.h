/* SPDX-License-Identifier: MIT */
/**
 * @file watch.h
 * How the library lit a scene: of every pixel in which way, and where the nodes lie. Calls from one of its files to
 * another are watched, which counts.c leads through here; what they do is the library's own.
 */
#ifndef GLINT_HOST_WATCH_H
#define GLINT_HOST_WATCH_H

#include "light/fragments.h"
#include "nodes/shapes.h"

/** How a pixel was lit; watch_looks has its name and its colour. */
typedef enum way {
    WAY_NONE, /* background */
    WAY_FAST,
    WAY_EVEN, /* one colour: no light reaches the object */
    WAY_PLANES,
    WAY_QUADRATICS,
    WAY_OVER_LENGTH,
    WAY_PIECES,
    WAY_SQUARES_16,
    WAY_SQUARES_8,
    WAY_SQUARES_4,
    WAY_ONE_BY_ONE,
    WAY_CORNERS, /* per vertex */
    WAY_FACET,
    WAYS
} way;

/** What shows of a way. */
typedef struct way_look {
    const char *name;
    uint8_t colour[3];
} way_look;

extern const way_look watch_looks[WAYS];

/** A point of the screen, sixteenths of a pixel. */
typedef struct node_place {
    int x, y;
} node_place;

/** Most nodes of an area. */
#define WATCH_NODES 9

/** Most areas of a picture. */
#define WATCH_AREAS_MAX (1 << 17)

/** A triangle's part in a tile, a piece of a triangle or a square of the lattice; and what polynomials go through. */
typedef struct lit_area {
    node_place corners[3]; /* of the piece, else of the triangle */
    node_place nodes[WATCH_NODES];
    int node_count, size; /* pixels of a square across; 0 for a triangle or a piece */
} lit_area;

/** What is seen of a picture of so many pixels. */
typedef struct watched {
    int width, height;
    uint8_t *ways; /* a `way` a pixel */
    int *owners;   /* of each pixel: the number of the area it is lit in, -1 for none; null where areas are not noted */
    lit_area *areas; /* WATCH_AREAS_MAX of them, or null */
    int area_count;
} watched;

/** Notes what is drawn from now on, one frame at a time, until `seen` is null. What `seen` points to is the caller's.
 */
void watch_into(watched *seen);

/* What counts.c calls in place of the library's functions; each calls the library's own. */
int watch_render_tile(const glint_frame *frame, glint_workspace *workspace, uint32_t tile);
void watch_gathering_store(const glint_gathering *gathering);
void watch_draw_facet(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                      const glint_triangle *triangle, const glint_part *part);
void watch_draw_lit(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                    const glint_triangle *triangle, const glint_part *part);
void watch_nodes_light(const glint_frame *frame, const glint_shading *shading, glint_fragments *at, uint32_t lights,
                       uint32_t lobes, int tells, glint_node *const nodes[]);
int watch_terms_begin(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                      const glint_part *part, glint_terms *terms, glint_polynomials *polynomials, glint_reach *reach);
int watch_shape_begin(const glint_frame *frame, const glint_draw *draw, const glint_shape *shape,
                      glint_node *const nodes[], glint_terms *terms, glint_polynomials *polynomials);
void watch_terms_draw_part(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                           const glint_triangle *triangle, const glint_part *part, const glint_terms *terms,
                           const glint_polynomials *polynomials);

#endif
