/* SPDX-License-Identifier: MIT */
/** @file drawing.h Scenes made of an input's bytes, with all that they point to. */
#ifndef GLINT_FUZZ_DRAWING_H
#define GLINT_FUZZ_DRAWING_H

#include "glint_extras.h"
#include "source.h"

#define DRAWING_MESHES 2
#define DRAWING_OBJECTS 4
#define DRAWING_LEVELS 10

/** A scene; not to be moved once made. Arrays of meshes are of the size that these state, for reads beyond to be seen.
 */
typedef struct drawing {
    glint_mesh meshes[DRAWING_MESHES];
    glint_mesh_layout layouts[DRAWING_MESHES]; /**< Of those that have one, */
    void *stored[DRAWING_MESHES][4];           /**< and what they point to. */
    int is_loose;                              /**< How it looks may depend on the arena. */
    glint_material materials[DRAWING_OBJECTS];
    glint_texture textures[DRAWING_OBJECTS];                         /**< Of those that wear one, */
    const void *texels[DRAWING_OBJECTS], *palettes[DRAWING_OBJECTS]; /**< and what they point to. */
    glint_texture levels[DRAWING_OBJECTS][DRAWING_LEVELS];           /**< And levels of their own. */
    glint_light lights[GLINT_LIGHTS_MAX + 1];
    glint_object objects[DRAWING_OBJECTS];
    glint_fog fog;
    glint_scene scene;
} drawing;

/** Any values, out of range and without sense ones included. */
void take_any_scene(source *s, drawing *d);

/**
 * What users draw: generated meshes with smooth normals, seen from around them, lit by lights of which some stand where
 * they are awkward. Every value is one that the library takes; only an object may be out of range.
 * @param may_have_clusters half of the meshes have them then
 */
void take_usual_scene(source *s, drawing *d, int may_have_clusters);

/** Stores arrays of meshes in layouts, now and then: sound ones, or any. */
void take_layouts(source *s, drawing *d, int is_sound);

/** Lets materials wear textures, more often than not, and gives all meshes coordinates then: sound ones, or any. */
void take_textures(source *s, drawing *d, int is_sound);

/** Lets objects blend and lie in fog, more often than not: sound ones, or any. @return whether layers are to be had */
int take_layers(source *s, drawing *d, int is_sound);

/** Mesh colours, or none: 24 bits, 16 bits, or both. */
void take_mesh_colours(source *s, glint_mesh *mesh);

void free_drawing(drawing *d);

#endif
