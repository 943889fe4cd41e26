/* SPDX-License-Identifier: MIT */
/**
 * @file varied_scene.h
 * The random scenes of tests/stability/, one to a seed, in more formats, evaluations and projections than their
 * generators choose.
 */
#ifndef GLINT_EQUIVALENCE_VARIED_SCENE_H
#define GLINT_EQUIVALENCE_VARIED_SCENE_H

#include "picture.h"
#include "stability/large_scene.h"
#include "stability/random_scene.h"

/** A scene and all it points to; not to be moved once made. */
typedef struct varied_scene {
    uint64_t seed;
    const char *kind; /**< What its generator calls such scenes. */
    int is_closed;    /**< No pixel shows the background. */
    int width, height;
    const glint_format *format;
    glint_scene scene;
    random_scene any; /**< One of the two is the scene. */
    large_scene large;
} varied_scene;

void varied_scene_make(varied_scene *to, uint64_t seed);

/** How a scene is drawn: with output tables and samples, now and then, and with layers and over a painted background
 * where it may need them. */
picture_options varied_scene_options(const varied_scene *s);

/** A number below `count` for a seed, another one for each use. */
uint32_t varied_pick(uint64_t seed, uint32_t use, uint32_t count);

#endif
