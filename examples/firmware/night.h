/* SPDX-License-Identifier: MIT */
/** @file night.h The README's moving picture: the same frames for firmware and for the host. */
#ifndef GLINT_EXAMPLE_NIGHT_H
#define GLINT_EXAMPLE_NIGHT_H

#include "scenes/stage.h"

/** Frames until the picture repeats, and frames of the scene from one to the next. */
#define NIGHT_FRAMES 16
#define NIGHT_STEP 3

/** Builds a frame, counted from 0, for a display of this size. */
static inline void night_build(example_stage *stage, uint32_t frame, uint16_t width, uint16_t height) {
    example_halloween.build(stage, 0, frame * NIGHT_STEP);
    example_fit(stage, &example_halloween, width, height);
}

#endif
