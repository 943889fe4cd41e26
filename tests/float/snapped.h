/* SPDX-License-Identifier: MIT */
/**
 * @file snapped.h
 * The reference's picture for the vertices as the float renderer snaps them.
 */
#ifndef FLOAT_SNAPPED_H
#define FLOAT_SNAPPED_H

#include "reference.h"
#include "renderer.h"

/** Draws a scene of at most BOXES_MAX objects in double precision; `exact` has a pixel for each of the screen. */
void float_draw_reference(const float_screen *screen, float_memory *memory, const glint_scene *scene,
                          reference_pixel *exact);

#endif
