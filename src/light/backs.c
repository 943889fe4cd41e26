/* SPDX-License-Identifier: MIT */
/*
 * Backs: triangles of double-sided objects that are lit at fragments or nodes. One that is seen from the back is drawn
 * as one seen from the front whose corners have the opposite normals, and are lit for it alone.
 */
#include "../raster/runs.h"
#include "../raster/setup.h"
#include "evaluation.h"

/* What the corners of one triangle have of a draw. */
typedef struct own_corners {
    glint_vertex corner[3];
    int16_t terms[3][3], nodes[3 * GLINT_KEPT_MAX];
} own_corners;

/* Turns a triangle's corners over. @return are they whole: not made by clipping? */
static int turn_over(const glint_triangle *triangle, own_corners *to) {
    uint32_t flags = GLINT_VERTEX_NORMAL;
    for (int i = 0; i < 3; i++) {
        glint_vertex *const corner = &to->corner[i];
        *corner = *triangle->corners[i];
        flags &= corner->flags;
        corner->flags &= GLINT_VERTEX_NORMAL;
        for (int c = 0; c < 3; c++)
            corner->attribute[c] = (int16_t)-corner->attribute[c];
    }
    return flags != 0;
}

/* Twice the area, 28.4 squared, from which on lighting corners takes less than fragments: of 16 pixels, measured. */
#define LEAST_AREA (16 * 512)

static GLINT_NOINLINE void draw_back(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                     const glint_triangle *triangle, const glint_part *part) {
    static const uint16_t indices[1][3] = {{0, 1, 2}};
    glint_triangle front = *triangle;
    glint_draw alone;
    own_corners own;
    const int is_whole = turn_over(triangle, &own);
    for (int i = 0; i < 3; i++)
        front.corners[i] = &own.corner[i];
    if (!is_whole || triangle->area < LEAST_AREA || glint_is_deep(triangle)) {
        glint_kernel_of(frame, draw)(frame, workspace, draw, &front, part);
        return;
    }
    if (!glint_is_visible(frame, workspace, part)) { /* then no corner is lit */
        glint_count(workspace, GLINT_KERNEL_GENERAL, workspace->drawn ? glint_covered_by(part) : 0);
        return;
    }
    alone = *draw;
    alone.triangles = indices;
    alone.vertices = own.corner;
    alone.terms = draw->terms ? own.terms : 0;
    alone.nodes = own.nodes;
    glint_light_of(frame, draw)(frame, &alone, &draw->transform, 0);
    glint_kernel_of(frame, draw)(frame, workspace, &alone, &front, part);
}

void glint_draw_sides(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                      const glint_triangle *triangle, const glint_part *part) {
    if (triangle->back)
        draw_back(frame, workspace, draw, triangle, part);
    else
        glint_kernel_of(frame, draw)(frame, workspace, draw, triangle, part);
}
