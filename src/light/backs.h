/* SPDX-License-Identifier: MIT */
/**
 * @file backs.h
 * Triangles of double-sided objects that fast lighting or nodes light. One that is seen from the back is drawn as one
 * seen from the front whose corners have the opposite normals, and are lit for it alone.
 */
#ifndef GLINT_BACKS_H
#define GLINT_BACKS_H

#include "../raster/raster.h"
#include "evaluation.h"

/**
 * Draws a triangle that is seen from the back. @param nodes room for what three corners keep, where draws have nodes
 */
void glint_draw_back(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                     const glint_triangle *triangle, const glint_part *part, int16_t *nodes);

/** The kernel of double-sided objects that fast lighting serves. */
glint_kernel glint_draw_sides;

#endif
