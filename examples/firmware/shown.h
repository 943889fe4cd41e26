/* SPDX-License-Identifier: MIT */
/** @file shown.h Which frames of the example scenes the panel shows: the same list for firmware and for its test. */
#ifndef GLINT_EXAMPLE_SHOWN_H
#define GLINT_EXAMPLE_SHOWN_H

#include "scenes/scenes.h"

/** Frames of a variant that moves: the first, and one a third of its period later. */
#define SHOWN_FRAMES 2

/** Room for any name and its end. */
#define SHOWN_NAME_SIZE 64

typedef struct shown_frame {
    const example_scene *scene;
    uint32_t variant;
    uint32_t frame;
    char name[SHOWN_NAME_SIZE]; /**< "teapot-vertex": scene and variant, cut at its room. */
} shown_frame;

/** Finds frame 0, 1, ... of all that is shown. @return 1, or 0 when there are no more. */
int shown_find(shown_frame *shown, uint32_t index);

#endif
