/* SPDX-License-Identifier: MIT */
/**
 * @file backs.h
 * Triangles of double-sided objects that are lit at fragments or nodes. One that is seen from the back is drawn as one
 * seen from the front whose corners have the opposite normals, and are lit for it alone.
 */
#ifndef GLINT_BACKS_H
#define GLINT_BACKS_H

#include "../raster/runs.h"
#include "../raster/setup.h"
#include "evaluation.h"

/** Twice the area, 28.4 squared, from which on lighting corners takes less than fragments: of 16 pixels, measured. */
#define GLINT_BACKS_LEAST_AREA (16 * 512)

/** Turns a triangle's corners over. @return are they whole: not made by clipping? */
static inline int glint_turn_over(const glint_triangle *triangle, glint_vertex to[3]) {
    uint32_t flags = GLINT_VERTEX_NORMAL;
    for (int i = 0; i < 3; i++) {
        to[i] = *triangle->corners[i];
        flags &= to[i].flags;
        to[i].flags &= GLINT_VERTEX_NORMAL;
        for (int c = 0; c < 3; c++)
            to[i].attribute[c] = (int16_t)-to[i].attribute[c];
    }
    return flags != 0;
}

/** Draws a triangle that is seen from the back. @param nodes room for what three corners keep, where draws have nodes
 */
static GLINT_INLINE void glint_draw_back(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                         const glint_triangle *triangle, const glint_part *part, int16_t *nodes) {
    static const uint16_t indices[1][3] = {{0, 1, 2}};
    glint_triangle front = *triangle;
    glint_vertex corners[3];
    int16_t terms[3][3];
    glint_draw alone;
    const int is_deep = glint_is_deep(triangle);
    if (!is_deep && !glint_is_visible(frame, workspace, part)) { /* then no corner is lit */
        glint_count(workspace, GLINT_KERNEL_GENERAL, workspace->drawn ? glint_covered_by(part) : 0);
        return;
    }
    const int is_whole = glint_turn_over(triangle, corners);
    for (int i = 0; i < 3; i++)
        front.corners[i] = &corners[i];
    if (!is_whole || is_deep || triangle->area < GLINT_BACKS_LEAST_AREA) {
        glint_kernel_of(frame, draw)(frame, workspace, draw, &front, part);
        return;
    }
    alone = *draw;
    alone.triangles = indices;
    alone.vertices = corners;
    alone.terms = draw->terms ? terms : 0;
    alone.nodes = nodes;
    glint_light_of(frame, draw)(frame, &alone, &draw->transform, 0);
    glint_kernel_of(frame, draw)(frame, workspace, &alone, &front, part);
}

#endif
