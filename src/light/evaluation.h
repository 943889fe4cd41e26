/* SPDX-License-Identifier: MIT */
/** @file evaluation.h Where light is found, and what draws pixels. */
#ifndef GLINT_EVALUATION_H
#define GLINT_EVALUATION_H

#include "../geometry/draw.h"
#include "../pixel/format.h"
#include "shading.h"

/** Where colours are found. */
typedef enum glint_lit_at { GLINT_LIT_AT_FRAGMENTS, GLINT_LIT_AT_VERTICES, GLINT_LIT_AT_FACETS } glint_lit_at;

/** What evaluations that light nodes link. */
typedef struct glint_node_stage {
    /** Behind all shadings: what each material makes of the frame's lights. Adds to frame->least_room. */
    glint_status (*prepare)(glint_frame *frame);
    /** Bytes that a vertex keeps of light in one material. @return 0 where nodes do not fit it, or none are lit of it
     */
    size_t (*measure)(const glint_frame *frame, const glint_shading *shading);
    size_t size; /* bytes that what a material makes of the lights takes */
} glint_node_stage;

struct glint_evaluation {
    uint8_t lit_at;                /* glint_lit_at */
    uint8_t has_terms;             /* do vertices keep the terms of fast lighting? */
    glint_light_triangle *light;   /* what comes before a triangle is drawn */
    glint_kernel *kernel, *sides;  /* and of double-sided objects */
    const glint_node_stage *nodes; /* or null */
};

/** The kernel for everything: fragments that pass the depth test are lit; those of backs by the opposite normals. */
glint_kernel glint_draw_any;

/** Kernels of triangles of one colour, and of those with colours at their corners. */
glint_kernel glint_draw_facet, glint_draw_unlit, glint_draw_lit;

#endif
