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
#include "sampling.h"

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
    double plain[3];  /**< The same as if all texels were white. */
    double nearest;   /**< 1/w of the surface seen, or REFERENCE_FAR - w for parallel rays; 0 for background. */
    double second;    /**< 1/w of the next surface behind it, 0 when there is none. */
    double grazing;   /**< How near a jump of the colour is: the smallest |N.L| where a highlight is gated, half the
                         highlight's cosine where p < 1, the distance of a cosine from that of a cone without soft edge, 0
                         where a light touches: is within a pixel; 1 without any. */
    double torn;      /**< 1/w of the nearest surface that may have a hole here, or none; 0 for none. */
    double keyed;     /**< 1/w of the nearest surface whose texture has holes, be they here or not; 0 for none. */
    int covered;      /**< Whether any surface is seen. */
    uint32_t object;  /**< The number of the object that is seen. */
    int rounded[2];   /**< Whether a corner of the triangle that is seen was rounded here, and of that behind it. */
    int uncertain; /**< Within 1.5/16 of a pixel of an edge that was rounded here, which another may round apart; or a
                      surface before what is seen, or this one, may have a hole here (sampling.h). */
    int unsettled; /**< Coordinates of the texture are not settled (sampling.h), or its level is not. */
    int is_level_open; /**< Its level is not. */
    int choice_count;  /**< Of the next. */
    /** Where a texture is seen, its colours within reach: those from `least` to `most`, channel by channel. */
    struct {
        double least[3], most[3];
    } choices[REFERENCE_TEXELS_MAX];
} reference_pixel;

/** An image; `pixels` belongs to the caller, width times height, row by row. */
typedef struct reference_image {
    int width, height;
    reference_pixel *pixels;
} reference_image;

/** Vertex `index` of an object of the scene, for a screen of the given size. */
reference_vertex reference_transform(const glint_scene *scene, uint32_t object, uint32_t index, int width, int height);

/**
 * Draws a scene without its fog and without objects that are blended.
 * @param positions per object, screen positions of its vertices; null, or null for an object, to round its own. A
 * triangle that crosses the near plane, or has a vertex without a known position, is clipped here, and what has none
 * rounded.
 */
void reference_render(const reference_image *image, const glint_scene *scene,
                      const reference_position *const *positions);

/** Lists the objects that are blended, in the order in which they are drawn. reference_render leaves them out.
 * @param layers room for scene->object_count @return how many */
uint32_t reference_find_layers(const glint_scene *scene, uint32_t *layers);

/** Draws one object alone, whether it is blended or not. */
void reference_render_object(const reference_image *image, const glint_scene *scene, uint32_t object,
                             const reference_position *const *positions);

/** Returns how much of a surface's colour fog takes, 0 to 1, at a depth along the camera's axis. */
double reference_fog(const glint_fog *fog, double depth);

/**
 * Finds, of all that a pixel may show, what is nearest to stored levels, in levels.
 * @param channels of the pixel's format; a single one is luma
 * @param most the highest level of each
 * @return whether it is another texel's than that at the exact coordinates
 */
int reference_find_wanted(const reference_pixel *pixel, int channels, const int most[3], const double stored[3],
                          double wanted[3]);

#endif
