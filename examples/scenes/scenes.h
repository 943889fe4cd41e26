/* SPDX-License-Identifier: MIT */
/**
 * @file scenes.h
 * The example scenes, as data for glint: freestanding, so that the host, the tests and the boards draw the same bits.
 */
#ifndef GLINT_EXAMPLE_SCENES_H
#define GLINT_EXAMPLE_SCENES_H

#include "glint_extras.h"

/** Most objects of a scene. */
#define EXAMPLE_OBJECTS_MAX 32

/** What a scene is built in; owned by the caller, and not to be moved while the scene is drawn. */
typedef struct example_stage {
    glint_scene scene;
    glint_light lights[GLINT_LIGHTS_MAX];
    glint_object objects[EXAMPLE_OBJECTS_MAX];
    glint_material materials[EXAMPLE_OBJECTS_MAX];
    glint_mesh mesh;                 /**< Of others' arrays, where a scene changes one. */
    glint_fog fog;                   /**< What the scene points to, where it has fog. */
    const glint_layer_stage *layers; /**< What a configuration needs to draw it, */
    const glint_sampling *samples;   /**< and is to have; or null. */
} example_stage;

/** A word beside a picture's subject, for people; the scene itself does not hold it. Pixels as the scene is composed.
 */
typedef struct example_label {
    const char *text;    /**< ASCII; '\n' begins a new line. */
    uint16_t x, y;       /**< Its middle. */
    uint16_t to_x, to_y; /**< A line leads from it to this point; both 0 for none. */
} example_label;

/** A named way to draw a scene. */
typedef struct example_variant {
    const char *name;
    const char *look_for;        /**< One sentence: what to look for. */
    const example_label *labels; /**< Or null. */
    uint32_t label_count;
} example_variant;

typedef struct example_scene {
    const char *name;
    const char *summary; /**< One sentence. */
    const example_variant *variants;
    uint32_t variant_count; /**< 1 or more; the first is the default. */
    uint32_t frames;        /**< After so many frames it repeats; 1 when it does not move. */
    uint16_t width, height; /**< What it is composed for. */
    /** Builds a frame of a variant, both counted from 0, in `stage`. */
    void (*build)(example_stage *stage, uint32_t variant, uint32_t frame);
} example_scene;

/**
 * Fits a scene that was built in `stage` to a display of other proportions: on a taller one the field of view widens
 * until the scene is as wide as it was composed, and more is seen above and below; on a wider one more is seen beside
 * it.
 */
void example_fit(example_stage *stage, const example_scene *scene, uint16_t width, uint16_t height);

/** All of them, in the order of the texts. */
#define EXAMPLE_SCENES 7
extern const example_scene *const example_scenes[EXAMPLE_SCENES];

extern const example_scene example_shaders, example_three_spheres, example_halloween, example_teapot,
    example_phong_lighting, example_surfaces, example_still_life;

#endif
