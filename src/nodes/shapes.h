/* SPDX-License-Identifier: MIT */
/** @file shapes.h Shapes: regions whose nodes are all there. */
#ifndef GLINT_SHAPES_H
#define GLINT_SHAPES_H

#include "terms.h"

/** Nodes of a cell: three rows of three. */
#define GLINT_CELL_NODES 9

/** Nodes of a region, and how polynomials go through them. */
typedef struct glint_shape {
    uint8_t count, corners[4]; /* how many, and which lie at the corners: a triangle's last is there twice */
    uint32_t longest;          /* what two of its points lie apart at most, 28.4 */
    uint32_t lobes;            /* highlights that may show */
    const glint_part *part;    /* the whole triangle's */
    /** The polynomial through numbers of the nodes, times 2^unit. @return 0 where its own do not fit */
    int (*fit)(const struct glint_shape *shape, const int32_t n[], int unit, glint_quadratic *to);
    unsigned shift;                 /* of a cell: nodes are 2^shift pixels apart, */
    int32_t x, y;                   /* and the first lies here, from the anchor; */
    glint_barycentric *barycentric; /* of a piece of a triangle: this one's coordinates, */
    int32_t turned, first[2];       /* and how the piece's follow from these: pieces.c */
} glint_shape;

/** The shape of a cell from pixel x, y of the tile on, with nodes so far apart. */
void glint_shape_cell(const glint_part *part, uint32_t lobes, int32_t x, int32_t y, unsigned shift, glint_shape *shape);

/** Lights that are outside of their cones all over a region, from its corners' nodes. */
uint32_t glint_shape_away(const glint_draw *draw, const glint_shape *shape, glint_node *const nodes[]);

/** A region's light, from its nodes on. @return 0 where polynomials do not fit */
int glint_shape_begin(const glint_frame *frame, const glint_draw *draw, const glint_shape *shape,
                      glint_node *const nodes[], glint_terms *terms, glint_polynomials *polynomials);

/** Draws a triangle that is not deep by four pieces of its own. @return 0 where it is too small or too slender for them
 */
int glint_draw_pieces(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                      const glint_triangle *triangle, uint32_t lobes, const glint_part *part);

/** Draws a triangle by the cells of the lattice. @return 0 where it is too small or too deep for them */
int glint_draw_lattice(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                       const glint_triangle *triangle, uint32_t lobes, const glint_part *part);

#endif
