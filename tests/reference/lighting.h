/* SPDX-License-Identifier: MIT */
/**
 * @file lighting.h
 * The reference's lights and materials, in double precision, from the formulas that glint.h states.
 */
#ifndef GLINT_REFERENCE_LIGHTING_H
#define GLINT_REFERENCE_LIGHTING_H

#include "glint.h"

/** Lights in camera space. */
typedef struct reference_lights {
    double position[GLINT_LIGHTS_MAX][3];  /**< From the eye; of point lights and spots. */
    double direction[GLINT_LIGHTS_MAX][3]; /**< Unit; of directional lights and spots. */
    double pixel;                          /**< A pixel's width, 1 before the eye; of parallel rays anywhere. */
    int is_parallel;
} reference_lights;

/** A point to be lit, in camera space. */
typedef struct reference_surface {
    double place[3];
    double normal[3]; /**< Any length. */
    double colour[3]; /**< Of the mesh, 1 where it has none. */
} reference_surface;

/** What was found at a point. */
typedef struct reference_light {
    double colour[3]; /**< Clamped to 0..1. */
    double grazing;   /**< Distance to the nearest jump: the smallest |N.L| where a highlight is gated, half the
                         highlight's cosine where p < 1, the distance of the cosine from that of a cone without soft edge,
                         0 where a light touches the point: is within a pixel of it; 1 when there is none. */
} reference_light;

/** For an image so many pixels high. */
void reference_prepare_lights(reference_lights *lights, const glint_scene *scene, int height);

/** Sets the way from a place, in camera space, to a light; that to a directional one is unit. */
void reference_find_way(const glint_light *light, const reference_lights *lights, uint32_t index, const double place[3],
                        double way[3]);

reference_light reference_shade(const glint_scene *scene, const reference_lights *lights,
                                const glint_material *material, const reference_surface *surface);

/** A vertex's position as the mesh has it, in extents from its offset; its normal, of any length; and a triangle's
 * corners: from the mesh's arrays, or where these are null, decoded from its layout. */
void reference_mesh_position(const glint_mesh *mesh, uint32_t index, double extents[3]);
void reference_mesh_normal(const glint_mesh *mesh, uint32_t index, double normal[3]);
void reference_mesh_corners(const glint_mesh *mesh, uint32_t triangle, uint32_t corners[3]);

/** Red, green and blue of a vertex as the mesh has them, 1 where it has none. */
void reference_mesh_colour(const glint_mesh *mesh, uint32_t index, double colour[3]);

/* ---- Vectors ------------------------------------------------------------------------------------------------- */

static inline double reference_dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** Makes a vector unit; zero stays zero. @return its length before. */
double reference_normalise(double v[3]);

/** World to camera: the inverse of a rotation is its transpose. */
void reference_to_camera(const glint_camera *camera, const double world[3], double result[3]);

/** A Q16.16 number. */
static inline double reference_real(glint_q16 value) {
    return value / 65536.0;
}

#endif
