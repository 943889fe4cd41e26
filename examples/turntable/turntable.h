/* SPDX-License-Identifier: MIT */
/**
 * @file turntable.h
 * Two turning models as scenes, frame by frame: what firmware shows on a panel and what the tests compare it with. The
 * same code runs on both, so both draw the same bits.
 */
#ifndef GLINT_TURNTABLE_H
#define GLINT_TURNTABLE_H

#include "glint.h"

/** Size of the panel that these scenes are set up for, in pixels. */
#define TURNTABLE_WIDTH 128
#define TURNTABLE_HEIGHT 64

/** Frames of a turn; frame numbers beyond go on turning. */
#define TURNTABLE_FRAMES 10

typedef enum turntable_model {
    TURNTABLE_TORUS,  /**< 576 triangles, shiny, seen with the local viewer. */
    TURNTABLE_TEAPOT, /**< 2256 triangles, seen with the infinite viewer, lit by two lights. */
    TURNTABLE_MODELS
} turntable_model;

/** How many of them a program has, from the first; boards of little flash have fewer (port/boards.mk). */
#ifndef TURNTABLE_SHOWN
#define TURNTABLE_SHOWN TURNTABLE_MODELS
#endif

/** A scene with what it points to: not to be copied. */
typedef struct turntable {
    glint_scene scene;
    glint_object object;
    glint_material material;
    glint_light lights[2];
} turntable;

/** "torus576" or "teapot". */
const char *turntable_name(turntable_model model);

/** Sets up frame 0, 1, ... of a model. */
void turntable_frame(turntable *table, turntable_model model, uint32_t frame);

/** Widens the field of view on a display that is not much wider than high, which would cut off a teapot's handle and
 * spout. */
void turntable_fit(turntable *table, uint16_t width, uint16_t height);

#endif
