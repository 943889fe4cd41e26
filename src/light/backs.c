/* SPDX-License-Identifier: MIT */
/* Backs: double-sided objects whose fragments are lit one by one, or by fast lighting. */
#include "backs.h"

static GLINT_NOINLINE void draw_back(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                     const glint_triangle *triangle, const glint_part *part) {
    glint_draw_back(frame, workspace, draw, triangle, part, 0);
}

void glint_draw_sides(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                      const glint_triangle *triangle, const glint_part *part) {
    if (triangle->back)
        draw_back(frame, workspace, draw, triangle, part);
    else
        glint_kernel_of(frame, draw)(frame, workspace, draw, triangle, part);
}
