/* SPDX-License-Identifier: MIT */
/** @file fast_draw.h Fast lighting's kernel: a file of its own says what it stores. */
#ifndef GLINT_FAST_DRAW_H
#define GLINT_FAST_DRAW_H

#include "../light/backs.h"
#include "fast_exact_spans.h"

/** The kernel; what it `stores` is a constant where this is inlined. */
static GLINT_INLINE void glint_draw_fast(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                         const glint_triangle *triangle, const glint_part *part,
                                         glint_fast_store stores) {
    const glint_fast_terms *fast = draw->shading->fast;
    glint_fast_planes planes;
    const glint_fast_kind kind = glint_fast_begin(draw, triangle, part, &planes);
    if (kind == GLINT_FAST_UNFIT) {
        if (!glint_draw_curved(frame, workspace, draw, triangle, part, stores))
            glint_draw_any(frame, workspace, draw, triangle, part);
        return;
    }
    if (workspace->drawn)
        glint_count(workspace, (glint_kernel_name)kind, glint_fast_covered(part));
    const glint_fast_spans spans = glint_fast_spans_of(frame, workspace, part, stores);
    if (kind == GLINT_FAST_AMBIENT)
        glint_draw_constant(&spans, glint_ambient_of(fast, stores), stores);
    else if (kind == GLINT_FAST_EVEN)
        glint_draw_constant(&spans, glint_colour_of(glint_fast_even(draw->shading, &planes), 0, stores), stores);
    else if (kind == GLINT_FAST_SPECULAR && fast->diffuse) {
        if (triangle->area >= GLINT_LARGE_AREA)
            glint_draw_large(frame, workspace, draw, part, &planes, stores);
        else
            glint_draw_highlight(&spans, fast, &planes, stores);
    } else if (!fast->diffuse)
        glint_draw_without_tables(frame, workspace, draw, triangle, part, &planes, kind, stores);
    else if (!GLINT_SMALL && kind == GLINT_FAST_DIFFUSE)
        glint_draw_diffuse(&spans, fast, &planes.cosine, 0, stores);
    else
        glint_draw_diffuse(&spans, fast, &planes.cosine, 1, stores);
}

/** Fast lighting that stores that. */
#define GLINT_DEFINE_FAST(name, stores)                                                                               \
    static void draw_##name(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,             \
                            const glint_triangle *triangle, const glint_part *part) {                                 \
        glint_draw_fast(frame, workspace, draw, triangle, part, stores);                                              \
    }                                                                                                                 \
    static const glint_evaluation evaluation_##name = {GLINT_LIT_AT_FRAGMENTS, 1, glint_fast_light, draw_##name,      \
                                                       glint_draw_sides,       0};                                    \
    const glint_fast glint_fast_##name = {glint_fast_serves, glint_fast_prepare, glint_fast_need, &evaluation_##name, \
                                          (stores) == GLINT_STORES_SPREAD}

#endif
