/* SPDX-License-Identifier: MIT */
/**
 * @file compose.h
 * A user interface with 3D in it, and no framebuffer: a model over a picture, a label that follows a point of it, a
 * cursor that names the triangle below it, and beside it a clock whose hands are drawn in a region of their own.
 */
#ifndef COMPOSE_H
#define COMPOSE_H

#include "glint.h"

/** Pixels of the whole, which are of glint_format_rgb565_be. */
#define COMPOSE_WIDTH 320
#define COMPOSE_HEIGHT 240

/** Draws frame `number` of a turn of 60 with one renderer's arena. @return GLINT_OK or an error of the library */
glint_status compose_draw(glint_flush flush, void *arena, size_t arena_size, int number);

#endif
