/* SPDX-License-Identifier: MIT */
/** @file ways.h Ways to draw a scene that all give the same bits. */
#ifndef GLINT_EQUIVALENCE_WAYS_H
#define GLINT_EQUIVALENCE_WAYS_H

#include "picture.h"

/** A way to draw. */
typedef struct way {
    const char *name;
    /**
     * @param wanted the scene's picture
     * @param how it was drawn
     * @param choice any number, which settles the rest: which tiles, how much arena
     * @return whether the picture becomes the same, each pixel being sent once
     */
    int (*draws_same)(const picture *wanted, const glint_scene *scene, const picture_options *how, uint32_t choice);
} way;

extern const way ways[];
extern const unsigned way_count;

#endif
