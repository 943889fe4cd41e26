/* SPDX-License-Identifier: MIT */
/**
 * @file reference.h
 * The judge of glint's images: a renderer in double precision that shares nothing with src/ but the public header.
 *
 * It reads the same quantised data (Q16.16 scene, int16 mesh) and takes every later step in double precision: pose,
 * near-plane clipping, perspective-correct position, unit normal and colours, lighting with libm. Only coverage is
 * decided in integers: exact edge functions on 28.4 screen positions, pixel centres, top-left rule.
 *
 * The screen positions may be those of the renderer under judgement. Coverage is then to agree in every pixel, and
 * colours differ by what shading alone got wrong.
 */
#ifndef GLINT_REFERENCE_H
#define GLINT_REFERENCE_H

#include "glint.h"

/** A screen position in 28.4; `known` is 0 where the renderer under judgement has none. */
typedef struct reference_position {
    int32_t x, y;
    int known;
} reference_position;

/** A vertex in double precision. */
typedef struct reference_vertex {
    double place[3];  /**< Camera space. */
    double normal[3]; /**< Camera space, unit length, or 0. */
    double x, y;      /**< Screen position in pixels; only where w is above 0. */
    double w;         /**< Distance along the camera's axis. */
} reference_vertex;

/** Farther than all that parallel rays see. */
#define REFERENCE_FAR 1048576.0

typedef struct reference_pixel {
    double colour[3]; /**< Clamped to 0..1, not rounded. */
    double nearest;   /**< 1/w of the surface seen, or REFERENCE_FAR - w for parallel rays; 0 for background. */
    double second;    /**< 1/w of the next surface behind it, 0 when there is none. */
    double grazing;   /**< How near a jump of the colour is: the smallest |N.L| where a highlight is gated, half the
                         highlight's cosine where p < 1, the distance of a cosine from that of a cone without soft edge, 0
                         where a light touches: is within a pixel; 1 without any. */
    int covered;      /**< Whether any surface is seen. */
    int rounded[2];   /**< Whether a corner of the triangle that is seen was rounded here, and of that behind it. */
    int uncertain;    /**< Within 1.5/16 of a pixel of an edge that was rounded here, which another may round apart. */
} reference_pixel;

/** An image; `pixels` belongs to the caller, width times height, row by row. */
typedef struct reference_image {
    int width, height;
    reference_pixel *pixels;
} reference_image;

/** Vertex `index` of an object of the scene, for a screen of the given size. */
reference_vertex reference_transform(const glint_scene *scene, uint32_t object, uint32_t index, int width, int height);

/**
 * Draws a scene.
 * @param positions per object, screen positions of its vertices; null, or null for an object, to round its own. A
 * triangle that crosses the near plane, or has a vertex without a known position, is clipped here, and what has none
 * rounded.
 */
void reference_render(const reference_image *image, const glint_scene *scene,
                      const reference_position *const *positions);

#endif
