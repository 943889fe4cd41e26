/* SPDX-License-Identifier: MIT */
/** @file corners.h A triangle on its way to terms, and what its corners tell of its light. */
#ifndef GLINT_CORNERS_H
#define GLINT_CORNERS_H

#include "terms.h"

/** Corners at the ends of edges, and the node between them. */
static const uint8_t glint_ends[3][2] = {{0, 1}, {1, 2}, {0, 2}};

/** A triangle on its way to terms. */
typedef struct glint_candidate {
    const int16_t *kept[3];          /* of its corners */
    int32_t sum[6][3], shine[6][3];  /* at its corners, and the middles of its edges */
    glint_node middle[3];            /* unless they are found from the corners */
    int32_t apart[3];                /* |Na - Nb|^2 of an edge, Q26 */
    int32_t share[3][2];             /* of an edge's ends in what lies between them, Q15 */
    uint8_t has_surface, is_between; /* are middles found from the corners? */
    int16_t surface[6][3];           /* the surface's colours, Q14 */
    glint_region region;
} glint_candidate;

/** Sets a triangle's region from what its corners keep. @return 0 where no polynomials fit */
int glint_find_region(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                      glint_candidate *t);

#endif
