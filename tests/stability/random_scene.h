/* SPDX-License-Identifier: MIT */
/**
 * @file random_scene.h
 * One of endlessly many small scenes, told by a seed alone. A scene belongs to a region where methods fail; what the
 * region does not settle is random too.
 */
#ifndef GLINT_STABILITY_RANDOM_SCENE_H
#define GLINT_STABILITY_RANDOM_SCENE_H

#include "glint_extras.h"
#include "random_texture.h"

#define RANDOM_OBJECTS_MAX 3
#define RANDOM_LIGHTS_MAX 4
#define RANDOM_VERTICES_MAX 96
#define RANDOM_TRIANGLES_MAX 160

typedef struct random_mesh {
    glint_mesh mesh;
    int16_t positions[RANDOM_VERTICES_MAX][3];
    int16_t normals[RANDOM_VERTICES_MAX][3];
    uint16_t triangles[RANDOM_TRIANGLES_MAX][3];
    uint8_t colours[RANDOM_VERTICES_MAX][3];
    int16_t texture_coordinates[RANDOM_VERTICES_MAX][2];
} random_mesh;

/** A scene and all it points to; not to be moved once made. */
typedef struct random_scene {
    uint64_t seed;
    unsigned region; /**< Index into random_regions. */
    int width, height;
    const glint_format *format;       /**< RGB565, RGB888 or grey8. */
    uint16_t tile_width, tile_height; /**< Of the configuration. */
    random_mesh meshes[RANDOM_OBJECTS_MAX];
    glint_material materials[RANDOM_OBJECTS_MAX];
    random_texture textures[RANDOM_OBJECTS_MAX];
    glint_light lights[GLINT_LIGHTS_MAX]; /**< Most regions have RANDOM_LIGHTS_MAX at most. */
    glint_object objects[RANDOM_OBJECTS_MAX];
    glint_fog fog;
    glint_scene scene;
} random_scene;

typedef struct random_region {
    const char *name;
    int in_contract; /**< Whether every exponent is from 1 to 1024. */
} random_region;

extern const random_region random_regions[];
extern const unsigned random_region_count;

/** The regions from this one on are of rooms and terrains, the last one of all, but with textures. */
#define RANDOM_DEEP_REGION 21
#define RANDOM_DEEP_REGIONS 2
#define RANDOM_TEXTURED_REGION (RANDOM_DEEP_REGION + RANDOM_DEEP_REGIONS)

/** Makes the scene of a seed in a region: the same whatever other regions there are. */
void random_scene_make_in(random_scene *scene, unsigned region, uint64_t seed);

/** The same in the region that the seed picks: one seed of four, those of 3 modulo 4, is of rooms and terrains; none
 * has textures. */
void random_scene_make(random_scene *scene, uint64_t seed);

/** Lets most objects wear textures. */
void random_scene_wear(random_scene *scene, uint64_t seed);

/** FNV-1a (Fowler, Noll and Vo) over all that a scene says: tells whether a seed still makes the scene it made. */
uint64_t random_scene_checksum(const random_scene *scene);

#endif
