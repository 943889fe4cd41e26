/* SPDX-License-Identifier: MIT */
/**
 * @file library_geometry.h
 * What the library made of a scene's vertices: the one place where image tests look inside it. The reference covers
 * the same pixels only when its corners lie on the same sixteenths of a pixel, which nothing public tells.
 */
#ifndef GLINT_LIBRARY_GEOMETRY_H
#define GLINT_LIBRARY_GEOMETRY_H

#include "glint.h"
#include "reference.h"

/** Most objects in a scene of the image tests. */
#define LIBRARY_OBJECTS_MAX 256

typedef struct library_geometry {
    uint32_t object_count;
    reference_position *positions[LIBRARY_OBJECTS_MAX]; /**< Snapped screen positions, per object and vertex. */
    double depth_scale;                                 /**< Depth steps per 1/w; of parallel rays, per w, */
    double farthest;                                    /**< and the w that has less than two of them. */
} library_geometry;

/**
 * Runs the library's geometry for a whole frame. Free with library_geometry_close, also after an error.
 * @return the library's error.
 */
glint_status library_geometry_open(library_geometry *geometry, const glint_config *config, const glint_scene *scene);

void library_geometry_close(library_geometry *geometry);

#endif
