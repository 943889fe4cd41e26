/* SPDX-License-Identifier: MIT */
/**
 * @file scenes.h
 * Scenes beside the benchmark's, each for something that a renderer gets wrong: clipping, mirrors, extreme scales,
 * many lights, colours above 1, odd exponents, normals that cancel.
 */
#ifndef GLINT_SCENES_H
#define GLINT_SCENES_H

#include "bench.h"
#include "glint.h"

#define SCENE_OBJECTS_MAX 4

/** A scene and what it points to; not to be moved once built. */
typedef struct test_scene {
    glint_material materials[SCENE_OBJECTS_MAX];
    glint_light lights[GLINT_LIGHTS_MAX];
    glint_object objects[SCENE_OBJECTS_MAX];
    glint_scene scene;
} test_scene;

/** A named scene. */
typedef struct scene_definition {
    const char *name;
    void (*build)(test_scene *scene);
} scene_definition;

extern const scene_definition scene_definitions[];
extern const unsigned scene_count;

/** Builds one of endlessly many scenes of one to three objects, none of which crosses the near plane. */
void scene_build_random(test_scene *scene, uint32_t seed);

/** Builds a scene; its meshes are shared and built on first use. */
void scene_build(test_scene *scene, const scene_definition *definition);

/** Builds the scene of that name; ends the program when there is none. */
void scene_build_named(test_scene *scene, const char *name);

/** Makes a scene's camera orthographic: as high as what it sees at the first object's origin. */
void scene_make_parallel(glint_scene *scene);

/** Lights all objects by one evaluation. */
void scene_evaluate(test_scene *scene, const glint_evaluation *evaluation);

/** Lighting per fragment, per vertex, per facet. */
extern const glint_evaluation *const scene_evaluations[3];

/** A square across z that faces along it, so far from its middle to a side; its box is so deep. */
glint_mesh scene_square_mesh(glint_q16 half, glint_q16 depth);

/** The mesh of a benchmark scene, built on first use. */
const bench_mesh *scene_bench_mesh(int which);

/** The same in clusters, as all scenes of this file have it. */
const bench_mesh *scene_clustered_mesh(int which);

#endif
