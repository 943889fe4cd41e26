/* SPDX-License-Identifier: MIT */
/**
 * @file fast_exact.h
 * Exact lighting of fragments under one directional light, for triangles that turn too far for fast.h: with
 * M = N/w linear on the screen, M.L is linear and M.M quadratic, and so, with the half vector, is the deviation over w.
 * Polynomials of whole numbers, stepped from pixel to pixel by forward differences.
 */
#ifndef GLINT_FAST_EXACT_H
#define GLINT_FAST_EXACT_H

#include "../raster/polynomial.h"
#include "fast.h"

/** Triangles whose rays are no further apart, over the focal length, Q14, lie so near to the screen where they show. */
#define GLINT_NEAR_EXTENT 4096

/** Turns that are interpolated are below this whatever it costs, Q15: the series below, and differences in 15 bits, are
 * made for it. */
#define GLINT_INTERPOLATE_TURN 19661

/** How a triangle, or a square of it, is drawn. */
typedef enum glint_exact_kind {
    GLINT_EXACT_UNFIT,                                  /* not by these kernels */
    GLINT_EXACT_AMBIENT = GLINT_KERNEL_AMBIENT,         /* faces away from the light all over */
    GLINT_EXACT_DIFFUSE = GLINT_KERNEL_CURVED_DIFFUSE,  /* without highlight */
    GLINT_EXACT_SPECULAR = GLINT_KERNEL_CURVED_SPECULAR /* with one */
} glint_exact_kind;

/** A triangle's lighting. Below, 1/w is 1 at its nearest corner, or a little less. */
typedef struct glint_exact_light {
    glint_plane normal[3];  /* M = N/w, Q30 */
    glint_plane cosine;     /* M.L, Q30 */
    glint_quadratic square; /* M.M, Q32, less 1/4: from 0 to below 3/4 */
    glint_quadratic x, y;   /* deviation over w, scaled, Q30 */
    int is_dim;             /* somewhere highlights do not just add to what tables hold */
    int32_t size;           /* the steps of M take this and 14 bits, and a sign */
} glint_exact_light;

/** What a material and the frame's viewer ask for; behind all else of `deviation`. */
void glint_exact_prepare(glint_fast_terms *fast, const glint_frame *frame, const glint_shading *shading);

/**
 * A triangle's lighting, but for the deviation of the local viewer.
 * @return whether highlights may show; with the local viewer glint_exact_bend tells more
 */
glint_exact_kind glint_exact_begin(const glint_draw *draw, const glint_triangle *triangle, const glint_part *part,
                                   glint_exact_light *light);

/** Smaller squares are not worth it: 2^2 pixels. */
#define GLINT_EXACT_LEAST_CELL 2

/** In a square of 2^c pixels M stays below 2 where c and light.size are no more than this together. */
#define GLINT_EXACT_MOST_TURN 16

/** Pixels around a middle. */
typedef struct glint_square {
    int32_t x, y;   /* the middle, on the screen */
    int32_t extent; /* none lies further from it, in sixteenths */
    int is_small;   /* the half vector is linear all over it */
} glint_square;

/** What is around a triangle. */
void glint_exact_square(const glint_fast_terms *fast, const glint_triangle *triangle, glint_square *square);

/**
 * The deviation of the local viewer in a square; a half vector that bends there more than straight before the light
 * makes it not small.
 * @return whether highlights show in it
 */
glint_exact_kind glint_exact_bend(const glint_fast_terms *fast, const glint_triangle *triangle, const glint_part *part,
                                  glint_square *square, glint_exact_light *light);

/** An edge from corner a to b: where its middle on the screen lies between the normals, and how these turn. */
typedef struct glint_interpolation_edge {
    int32_t across;  /* how much more than half a's weight is there, Q15 */
    int32_t turn;    /* |Na - Nb|^2, Q15 */
    int32_t shorter; /* 1 / |M| - 1 there, Q15 */
} glint_interpolation_edge;

/** Quadratics that interpolate a triangle's lighting, and what they are made of. */
typedef struct glint_interpolation {
    glint_exact_kind kind;
    int gated;              /* N.L may be below 0 */
    int clamped;            /* with its highlight, light may pass 1 */
    glint_quadratic cosine; /* N.L, Q30 */
    glint_quadratic x, y;   /* scaled deviation in the high half, as that of glint_fast_planes */
    /* what these are made of */
    glint_interpolation_edge edges[3]; /* from corner 0 to 1, from 1 to 2, from 0 to 2 */
    glint_barycentric gradients;
} glint_interpolation;

/** What a material asks for; behind all else of `deviation`. */
void glint_interpolate_prepare(glint_fast_terms *fast, const glint_frame *frame, const glint_shading *shading);

/**
 * A triangle's lighting by interpolation; x and y only where highlights may show.
 * @return GLINT_EXACT_UNFIT where normals or half vectors turn too far for it
 */
glint_exact_kind glint_interpolate_begin(const glint_draw *draw, const glint_triangle *triangle, const glint_part *part,
                                         glint_interpolation *to);

/** The same, found in `own` unless another tile has found it. */
const glint_interpolation *glint_interpolation_find(glint_workspace *workspace, const glint_draw *draw,
                                                    const glint_triangle *triangle, const glint_part *part,
                                                    glint_interpolation *own);

/** Its x and y, once all else is there. @return 0 where it does not fit */
int glint_interpolate_highlight(const glint_draw *draw, const glint_triangle *triangle, glint_interpolation *to);

#endif
