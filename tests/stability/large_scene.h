/* SPDX-License-Identifier: MIT */
/**
 * @file large_scene.h
 * One of endlessly many scenes of large triangles with the eye among them, told by a seed alone: terrains, closed
 * rooms, loose triangles, and objects at distances up to 2^33 near planes. Integers only: a seed makes the same scene
 * on every machine.
 */
#ifndef GLINT_STABILITY_LARGE_SCENE_H
#define GLINT_STABILITY_LARGE_SCENE_H

#include "glint_extras.h"
#include "random_texture.h"

#define LARGE_OBJECTS_MAX 4
#define LARGE_VERTICES_MAX 96
#define LARGE_TRIANGLES_MAX 72

typedef struct large_mesh {
    glint_mesh mesh;
    int16_t positions[LARGE_VERTICES_MAX][3];
    int16_t normals[LARGE_VERTICES_MAX][3];
    uint16_t triangles[LARGE_TRIANGLES_MAX][3];
    uint8_t colours[LARGE_VERTICES_MAX][3];
    int16_t texture_coordinates[LARGE_VERTICES_MAX][2];
} large_mesh;

typedef enum large_kind { LARGE_TERRAIN, LARGE_ROOM, LARGE_LOOSE, LARGE_DEPTHS, LARGE_KINDS } large_kind;

/** A scene and all it points to; not to be moved once made. */
typedef struct large_scene {
    uint64_t seed;
    large_kind kind;
    int is_closed; /**< The eye stands in a closed room: no pixel shows the background. */
    int width, height;
    const glint_format *format;
    large_mesh meshes[LARGE_OBJECTS_MAX];
    glint_material materials[LARGE_OBJECTS_MAX];
    random_texture textures[LARGE_OBJECTS_MAX];
    glint_light lights[GLINT_LIGHTS_MAX];
    glint_object objects[LARGE_OBJECTS_MAX];
    glint_fog fog;
    glint_scene scene;
} large_scene;

/** What a kind is called. */
extern const char *const large_kind_names[LARGE_KINDS];

/** Makes the scene of a seed: of the kind seed modulo LARGE_KINDS. */
void large_scene_make(large_scene *scene, uint64_t seed);

#endif
