/* SPDX-License-Identifier: MIT */
/* Backs whose corners are lit, for fast lighting and for nodes. */
#include "backs.h"

#include "../raster/runs.h"
#include "../raster/setup.h"

/* Twice the area, 28.4 squared, from which on lighting corners takes less than fragments: of 16 pixels, measured. */
#define LEAST_AREA (16 * 512)

/* Turns a triangle's corners over. @return are they whole: not made by clipping? */
static inline int turn_over(const glint_triangle *triangle, glint_vertex to[3]) {
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

/* What it takes of stack is not there while fronts are drawn. */
GLINT_NOINLINE void glint_draw_back(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
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
    front.back = 0;
    const int is_whole = turn_over(triangle, corners);
    for (int i = 0; i < 3; i++)
        front.corners[i] = &corners[i];
    if (!is_whole || is_deep || triangle->area < LEAST_AREA) {
        draw->evaluation->kernel(frame, workspace, draw, &front, part);
        return;
    }
    alone = *draw;
    alone.triangles = indices;
    alone.vertices = corners;
    alone.terms = draw->terms ? terms : 0;
    alone.nodes = nodes;
    draw->evaluation->light(frame, &alone, &draw->transform, 0);
    draw->evaluation->kernel(frame, workspace, &alone, &front, part);
}

void glint_draw_sides(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                      const glint_triangle *triangle, const glint_part *part) {
    if (triangle->back)
        glint_draw_back(frame, workspace, draw, triangle, part, 0);
    else
        draw->evaluation->kernel(frame, workspace, draw, triangle, part);
}
