/* SPDX-License-Identifier: MIT */
/** @file variants.h The same scene told in another way. */
#ifndef GLINT_EQUIVALENCE_VARIANTS_H
#define GLINT_EQUIVALENCE_VARIANTS_H

#include "glint.h"

#define VARIANT_OBJECTS_MAX 8

/** What may decide otherwise in a variant than in the scene. */
typedef enum variant_freedom {
    FREEDOM_NONE,    /**< Nothing. */
    FREEDOM_TIES,    /**< Where depths are equal, which object is drawn first. */
    FREEDOM_LIGHT,   /**< Rounding of light. */
    FREEDOM_ROUNDING /**< Rounding of light, depth and corners, and the fill rule. */
} variant_freedom;

/** A variant and all it points to, apart from the scene's meshes and materials; not to be moved once made. */
typedef struct variant {
    glint_scene scene;
    int is_mirrored; /**< Its picture's columns run the other way. */
    /** Of each object, that of the scene and the number there of the mesh's first triangle. */
    uint32_t object_of[VARIANT_OBJECTS_MAX], triangle_of[VARIANT_OBJECTS_MAX];
    glint_object objects[VARIANT_OBJECTS_MAX];
    glint_light lights[GLINT_LIGHTS_MAX];
    glint_mesh meshes[2];
} variant;

/** One way to tell a scene. */
typedef struct variant_kind {
    const char *name;
    variant_freedom freedom;
    /** Changes a copy of the scene, by any number. @return 0 where the scene has nothing to be told otherwise */
    int (*change)(variant *of, uint32_t choice);
} variant_kind;

extern const variant_kind variant_kinds[];
extern const unsigned variant_kind_count;

/** Makes a variant of a scene. @return 0 where the scene has none */
int variant_make(variant *to, const variant_kind *kind, const glint_scene *scene, uint32_t choice);

#endif
