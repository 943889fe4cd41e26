/* SPDX-License-Identifier: MIT */
/**
 * @file bench.h
 * The benchmark scenes: tori and a sphere, ten frames each, as constant data for glint. Built on a host, with libm.
 *
 * Geometry: torus(nu, nv) with radii 1 and 0.4, around the z axis; sphere(nu, nv) with radius 1 and its poles on z.
 * Frame k turns the mesh by Rx(-0.9 + 0.04 k) Ry(0.3 + 0.1 k) radians, Ry first, and moves it by (0, 0, -distance).
 */
#ifndef GLINT_BENCH_H
#define GLINT_BENCH_H

#include "glint.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Most vertices and triangles of a scene's mesh: those of torus(96, 48). */
#define BENCH_VERTICES_MAX 4608
#define BENCH_TRIANGLES_MAX 9216

/** Frames in a run. */
#define BENCH_FRAMES 10

typedef enum bench_shape { BENCH_TORUS, BENCH_SPHERE } bench_shape;

/** What makes one benchmark scene differ from another. */
typedef struct bench_definition {
    const char *name;
    bench_shape shape;
    uint32_t around; /**< nu: quads around the z axis. */
    uint32_t along;  /**< nv: quads around the tube, or from pole to pole. */
    double distance; /**< From the eye to the mesh's centre. */
} bench_definition;

/** The scenes: torus2304, torus576, torus9216, sphere960. */
#define BENCH_SCENES 4
extern const bench_definition bench_definitions[BENCH_SCENES];

/** A mesh and the arrays it points to. */
typedef struct bench_mesh {
    glint_mesh mesh;
    int16_t positions[BENCH_VERTICES_MAX][3];
    int16_t normals[BENCH_VERTICES_MAX][3];
    uint16_t triangles[BENCH_TRIANGLES_MAX][3];
} bench_mesh;

/** A scene and all it points to but the mesh. */
typedef struct bench_scene {
    glint_material material;
    glint_light light;
    glint_object object;
    glint_scene scene;
} bench_scene;

/** Fills `mesh` with a torus or a sphere, quantised; at most BENCH_VERTICES_MAX vertices. */
void bench_build_mesh(bench_mesh *mesh, bench_shape shape, uint32_t around, uint32_t along);

/** Fills `scene` with frame `frame` of a benchmark; the scene points into itself and to `mesh`, so it is not to move.
 */
void bench_build_scene(bench_scene *scene, const bench_definition *definition, const bench_mesh *mesh, int frame);

/** A turn about x by `about_x` radians after one about y by `about_y` radians. */
glint_pose bench_turn(double about_x, double about_y);

/** A number as Q16.16, rounded to nearest. */
glint_q16 bench_q16(double value);

#ifdef __cplusplus
}
#endif

#endif
