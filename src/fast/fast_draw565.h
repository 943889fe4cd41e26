/* SPDX-License-Identifier: MIT */
/** @file fast_draw565.h Fast lighting for pixels of 16 bits: a file of a format's own says which byte it stores first.
 */
#ifndef GLINT_FAST_DRAW565_H
#define GLINT_FAST_DRAW565_H

#include "../light/backs.h"
#include "../pixel/format.h"
#include "fast_exact565.h"

/** The kernel of a format; `high_first` is a constant where this is inlined. */
static GLINT_INLINE void glint_draw_565(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                        const glint_triangle *triangle, const glint_part *part, int high_first) {
    const glint_fast_terms *fast = draw->shading->fast;
    glint_fast_planes planes;
    const glint_fast_kind kind = glint_fast_begin(draw, triangle, part, &planes);
    if (kind == GLINT_FAST_UNFIT) {
        if (!glint_draw_curved(frame, workspace, draw, triangle, part, high_first))
            glint_draw_any(frame, workspace, draw, triangle, part);
        return;
    }
    if (workspace->drawn)
        glint_count(workspace, (glint_kernel_name)kind, glint_fast_covered(part));
    const glint_spans spans = {part, workspace->depth, workspace->pixels, frame->tile_shift_x};
    if (kind == GLINT_FAST_AMBIENT || kind == GLINT_FAST_EVEN)
        glint_draw_constant(
            &spans, kind == GLINT_FAST_AMBIENT ? fast->ambient : glint_fast_even(draw->shading, &planes), high_first);
    else if (kind == GLINT_FAST_SPECULAR && fast->diffuse) {
        if (triangle->area >= GLINT_LARGE_AREA)
            glint_draw_large(frame, workspace, draw, part, &planes, high_first);
        else
            glint_draw_highlight(&spans, fast, &planes, high_first);
    } else if (!fast->diffuse)
        glint_draw_without_tables(frame, workspace, draw, triangle, part, &planes, kind, high_first);
    else if (!GLINT_SMALL && kind == GLINT_FAST_DIFFUSE)
        glint_draw_diffuse(&spans, fast, &planes.cosine, 0, high_first);
    else
        glint_draw_diffuse(&spans, fast, &planes.cosine, 1, high_first);
}

/** Fast lighting of a format of that byte order. */
#define GLINT_DEFINE_FAST(name, high_first)                                                                      \
    static void draw_##name(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,        \
                            const glint_triangle *triangle, const glint_part *part) {                            \
        glint_draw_565(frame, workspace, draw, triangle, part, high_first);                                      \
    }                                                                                                            \
    static const glint_evaluation evaluation_##name = {GLINT_LIT_AT_FRAGMENTS, 1, glint_fast_light, draw_##name, \
                                                       glint_draw_sides,       0};                               \
    const glint_fast glint_fast_##name = {glint_fast_serves, glint_fast_prepare, glint_fast_need, &evaluation_##name}

#endif
