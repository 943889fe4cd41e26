/* SPDX-License-Identifier: MIT */
/**
 * @file lines.h
 * A teapot in its box, with its axes, and beside it a torus with the edges of its triangles.
 */
#ifndef LINES_H
#define LINES_H

#include "glint.h"

/** Draws it. @param config its overlay is set here @return GLINT_OK or an error of the library */
glint_status lines_draw(const glint_config *config);

#endif
