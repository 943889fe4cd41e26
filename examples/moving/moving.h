/* SPDX-License-Identifier: MIT */
/**
 * @file moving.h
 * Two meshes in RAM that change each frame: a wave, which goes from one shape to another and back, and an arm of two
 * bones.
 */
#ifndef MOVING_H
#define MOVING_H

#include "glint.h"

/** Sets the meshes to where they are at an angle, degrees; after 360 they are where they were. Not while a frame is
 * drawn. */
glint_status moving_set(int degrees);

/** Sets them, and draws them. @return GLINT_OK or an error of the library */
glint_status moving_draw(glint_renderer *renderer, int degrees);

#endif
