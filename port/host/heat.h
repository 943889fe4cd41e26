/* SPDX-License-Identifier: MIT */
/**
 * @file heat.h
 * How far a picture is from the double-precision reference (tests/reference), pixel by pixel.
 */
#ifndef GLINT_HOST_HEAT_H
#define GLINT_HOST_HEAT_H

#include "framebuffer.h"
#include "settings.h"

/** Distances of a picture's pixels. Owns `steps`. */
typedef struct heat_map {
    uint32_t width, height;
    /**
     * Of each pixel: how far the channel that is farthest off is from the unrounded reference, in steps of the format.
     * A dithered level counts as the middle of what is rounded to it, so that 0.5 is what rounding takes. Negative
     * where reference and library may round apart: beside edges of triangles that were cut at the near plane, where two
     * surfaces are as near as makes no difference, and where a light's cosine is within rounding of a jump, such as
     * that where a highlight begins.
     */
    double *steps;
    double worst; /**< The largest, at... */
    uint32_t worst_x, worst_y;
    long judged, over_half, over_one; /**< Pixels in all, and more than 0.55 and 1 steps off. */
} heat_map;

/**
 * Draws the scene in double precision and holds a picture of it against that. Takes about a second for 320x240.
 * @param shown what view_draw drew of the same scene with the same settings
 * @param map set by this, the caller frees it with heat_free
 */
void heat_find(heat_map *map, const glint_scene *scene, const host_settings *settings, const framebuffer *shown);

void heat_free(heat_map *map);

/** The colour of a distance: black to blue is rounding, green to yellow up to 1 step, red up to 2, white beyond. */
void heat_colour(double steps, uint8_t colour[3]);

/** The whole map, 3 bytes a pixel; the caller frees it. */
uint8_t *heat_picture(const heat_map *map);

#endif
