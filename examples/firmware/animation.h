/* SPDX-License-Identifier: MIT */
/** @file animation.h The example scenes in motion, framed for a display: the same frames for firmware and for its test.
 */
#ifndef GLINT_EXAMPLE_ANIMATION_H
#define GLINT_EXAMPLE_ANIMATION_H

#include "scenes/scenes.h"

/** Frames of each scene, and after how many it would repeat. */
#define ANIMATION_FRAMES 4
#define ANIMATION_PERIOD 12

/**
 * Builds frame 0, 1, ... of all, scene by scene, for a display of this size. In scenes that do not move the lights go
 * round. @return the frame's scene; null when there are no more
 */
const example_scene *animation_build(example_stage *stage, uint32_t index, uint16_t width, uint16_t height);

/** @return the dithered twin of a display's format of 16 bits, or the format: with 32 levels a channel, bands are seen
 */
const glint_format *animation_format(const glint_format *format);

#endif
