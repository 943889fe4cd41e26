/* SPDX-License-Identifier: MIT */
/** @file corners.h A triangle on its way to terms, and what its corners tell of its light. */
#ifndef GLINT_CORNERS_H
#define GLINT_CORNERS_H

#include "terms.h"

/** Corners at the ends of edges, and the node between them. */
static const uint8_t glint_ends[3][2] = {{0, 1}, {1, 2}, {0, 2}};

/** A triangle on its way to terms. */
typedef struct glint_candidate {
    const int16_t *kept[3];         /* of its corners */
    int32_t sum[6][3], shine[6][3]; /* at its corners, and the middles of its edges */
    glint_node middle[3];
    int32_t apart[3];    /* |Na - Nb|^2 of an edge, Q26 */
    int32_t share[3][2]; /* of an edge's ends in how it bulges between them, Q15 */
    uint8_t has_surface;
    uint8_t is_mixed, is_between; /* are numbers at the middles found from the corners; and those of highlights? */
    uint8_t is_straight;          /* and are they linear, times the normal's length? */
    int16_t surface[6][3];        /* the surface's colours, Q14 */
    glint_region region;
} glint_candidate;

/** Sets a triangle's region from what its corners keep. @return 0 where no polynomials fit */
int glint_find_region(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                      glint_candidate *t);

/** What such a region tells of its lights, where there are several; else any may shine on it. @param is_known may
 * polynomials fit? */
glint_reach glint_reach_of(const glint_draw *draw, const glint_region *region, int is_known);

/** How far an edge bulges between such numbers of its ends, where its middle is found from them. */
static inline int32_t glint_mix_bulge(const glint_candidate *t, int e, int32_t a, int32_t b) {
    return glint_shift_right(t->share[e][0] * a + t->share[e][1] * b + (1 << 14), 15);
}

/** Sets the corners' sums of the lights that all of them face. */
void glint_sum_corners(const glint_shading *shading, glint_candidate *t);

/** Finds what polynomials take of the nodes between corners. @return 0 where these do not fit */
int glint_find_middles(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                       glint_candidate *t);

#endif
