/* SPDX-License-Identifier: MIT */
/** @file fast_exact_spans.h Kernels of exact lighting, as those of fast_spans.h are. */
#ifndef GLINT_FAST_EXACT_SPANS_H
#define GLINT_FAST_EXACT_SPANS_H

#include "../light/evaluation.h"
#include "fast_exact.h"
#include "fast_interpolated_spans.h"

/* Diffuse light; ambient light alone where N.L <= 0. */
static inline void glint_draw_curved_diffuse(const glint_fast_spans *s, const glint_fast_terms *fast,
                                             const glint_exact_light *light, glint_fast_store stores) {
    const glint_part *part = s->of.part;
    glint_fast_output to = glint_output_begin(s, stores);
    const void *const stored = fast->diffuse_stored;
    const uint16_t *const root = glint_root_table;
    const uint32_t z_dx = (uint32_t)part->depth.dx, a_dx = (uint32_t)light->cosine.dx;
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    uint8_t *row = (uint8_t *)(s->of.depth + (part->top << s->of.shift));
    for (int32_t y = part->y + (int32_t)part->top; span != last; span++, y++, row += 2 << s->of.shift) {
        const uint32_t left = span->left, right = span->right;
        if (left >= right)
            continue;
        const int32_t x = part->x + (int32_t)left;
        uint32_t z = glint_at(&part->depth, x, y) + GLINT_DEPTH_BIAS, a = glint_at(&light->cosine, x, y);
        glint_stride c = glint_stride_begin(&light->square, x, y);
        uint8_t *depth = row + 2 * left;
        const uint8_t *const end = row + 2 * right;
        do {
            if (glint_next_is_nearest(&depth, z))
                glint_output_put(&to, s, depth,
                                 (int32_t)a <= 0
                                     ? glint_ambient_of(fast, stores)
                                     : glint_colour_at(stored, (a >> 15) * root[c.value >> 22] >> 22, stores),
                                 stores);
            glint_step(&depth);
            z += z_dx;
            a += a_dx;
            glint_stride_next(&c, &light->square);
        } while (depth != end);
        glint_output_end_row(&to, s, stores);
    }
    glint_output_end(&to, s, stores);
}

/* Half a plane's value, 1 = 2^15, squared. */
static inline uint32_t glint_middle_square(uint32_t value) {
    const uint32_t middle = (uint32_t)glint_shift_right((int32_t)value, 15);
    return middle * middle;
}

/* The colour of a lit fragment: M.L, 1 / |M| and the squared deviation over w. */
static inline uint32_t glint_exact_lit(const glint_fast_terms *fast, uint32_t a, uint32_t inverse, uint32_t square,
                                       glint_fast_store stores) {
    const uint32_t level = (a >> 15) * inverse >> 22;
    if (square < fast->exact.limit) {
        square = (square >> fast->exact.shift) * (inverse * inverse >> 16);
        if (square < fast->exact.end)
            return glint_colour_of(fast->diffuse[level] + fast->specular[square >> 20], 1, stores);
    }
    return glint_colour_at(fast->diffuse_stored, level, stores);
}

/* Diffuse and specular light. */
static inline void glint_draw_curved_specular(const glint_fast_spans *s, const glint_fast_terms *fast,
                                              const glint_exact_light *light, glint_fast_store stores) {
    const glint_part *part = s->of.part;
    glint_fast_output to = glint_output_begin(s, stores);
    const uint32_t z_dx = (uint32_t)part->depth.dx, a_dx = (uint32_t)light->cosine.dx;
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    uint8_t *row = (uint8_t *)(s->of.depth + (part->top << s->of.shift));
    for (int32_t y = part->y + (int32_t)part->top; span != last; span++, y++, row += 2 << s->of.shift) {
        const uint32_t left = span->left, right = span->right;
        if (left >= right)
            continue;
        const int32_t x = part->x + (int32_t)left;
        uint32_t z = glint_at(&part->depth, x, y) + GLINT_DEPTH_BIAS, a = glint_at(&light->cosine, x, y);
        glint_stride c = glint_stride_begin(&light->square, x, y);
        glint_stride ex = glint_stride_begin(&light->x, x, y), ey = glint_stride_begin(&light->y, x, y);
        uint8_t *depth = row + 2 * left;
        const uint8_t *const end = row + 2 * right;
        do {
            if (glint_next_is_nearest(&depth, z)) {
                uint32_t colour = glint_ambient_of(fast, stores);
                if ((int32_t)a > 0)
                    colour = glint_exact_lit(fast, a, glint_root_table[c.value >> 22],
                                             glint_middle_square(ex.value) + glint_middle_square(ey.value), stores);
                glint_output_put(&to, s, depth, colour, stores);
            }
            glint_step(&depth);
            z += z_dx;
            a += a_dx;
            glint_stride_next(&c, &light->square);
            glint_stride_next(&ex, &light->x);
            glint_stride_next(&ey, &light->y);
        } while (depth != end);
        glint_output_end_row(&to, s, stores);
    }
    glint_output_end(&to, s, stores);
}

/* The word of a fragment, computed. */
static inline uint32_t glint_interpolated_word(const glint_shading *shading, const glint_interpolation *light,
                                               int shows, int32_t x, int32_t y) {
    uint32_t square = UINT32_MAX;
    if (shows)
        square = glint_high_square(glint_stride_begin(&light->x, x, y).value) +
                 glint_high_square(glint_stride_begin(&light->y, x, y).value);
    return glint_fast_word(shading, (int32_t)glint_stride_begin(&light->cosine, x, y).value, square);
}

/* The same for exact lighting. */
static inline uint32_t glint_exact_word(const glint_shading *shading, const glint_exact_light *light, int shows,
                                        int32_t x, int32_t y) {
    const glint_exact_limits *limits = &shading->fast->exact;
    const uint32_t a = (uint32_t)glint_plane_at(&light->cosine, x, y);
    const uint32_t inverse = glint_root_table[glint_stride_begin(&light->square, x, y).value >> 22];
    uint32_t square = UINT32_MAX;
    if ((int32_t)a <= 0)
        return shading->fast->ambient_word;
    if (shows) {
        square = glint_middle_square(glint_stride_begin(&light->x, x, y).value) +
                 glint_middle_square(glint_stride_begin(&light->y, x, y).value);
        square = square < limits->limit ? (square >> limits->shift) * (inverse * inverse >> 16) : UINT32_MAX;
    }
    /* one step of N.L is as good as none */
    return glint_fast_word(shading, (int32_t)((a >> 15) * inverse) | 1,
                           square < limits->end ? square >> 5 : UINT32_MAX);
}

/* All of these, without tables; one of `light` and `interpolation` is null. */
static GLINT_NOINLINE void glint_draw_curved_without_tables(const glint_fast_spans *s, const glint_shading *shading,
                                                            const glint_exact_light *light,
                                                            const glint_interpolation *interpolation, int shows,
                                                            glint_fast_store stores) {
    const glint_part *part = s->of.part;
    for (uint32_t row = part->top; row < part->bottom; row++) {
        const glint_span span = part->spans[row];
        for (uint32_t column = span.left; column < span.right; column++) {
            const int32_t x = part->x + (int32_t)column, y = part->y + (int32_t)row;
            const uint32_t offset = (row << s->of.shift) + column;
            const uint32_t here = ((uint32_t)glint_plane_at(&part->depth, x, y) + (1u << 15)) >> 15;
            if (here <= s->of.depth[offset])
                continue;
            s->of.depth[offset] = (uint16_t)here;
            glint_put_at(s, offset,
                         light ? glint_exact_word(shading, light, shows, x, y)
                               : glint_interpolated_word(shading, interpolation, shows, x, y),
                         stores);
        }
    }
}

static inline void glint_draw_curved_kind(const glint_workspace *workspace, const glint_fast_spans *s,
                                          const glint_shading *shading, const glint_exact_light *light,
                                          glint_exact_kind kind, glint_fast_store stores) {
    const glint_fast_terms *fast = shading->fast;
    if (workspace->drawn)
        glint_count(workspace, (glint_kernel_name)kind, glint_fast_covered(s->of.part));
    if (kind == GLINT_EXACT_AMBIENT)
        glint_draw_constant(s, glint_ambient_of(fast, stores), stores);
    else if (!fast->diffuse)
        glint_draw_curved_without_tables(s, shading, light, 0, kind == GLINT_EXACT_SPECULAR, stores);
    else if (kind == GLINT_EXACT_DIFFUSE)
        glint_draw_curved_diffuse(s, fast, light, stores);
    else
        glint_draw_curved_specular(s, fast, light, stores);
}

static inline void glint_draw_interpolated(const glint_workspace *workspace, const glint_fast_spans *s,
                                           const glint_shading *shading, const glint_interpolation *light,
                                           glint_exact_kind kind, glint_fast_store stores) {
    if (workspace->drawn)
        glint_count(workspace, (glint_kernel_name)kind, glint_fast_covered(s->of.part));
    if (!shading->fast->diffuse)
        glint_draw_curved_without_tables(s, shading, 0, light, kind == GLINT_EXACT_SPECULAR, stores);
    else if (kind == GLINT_EXACT_DIFFUSE && (GLINT_SMALL || light->gated))
        glint_draw_interpolated_gated(s, shading->fast, light, stores);
    else if (kind == GLINT_EXACT_DIFFUSE)
        glint_draw_interpolated_lit(s, shading->fast, light, stores);
    else if (GLINT_SMALL || light->clamped)
        glint_draw_interpolated_clamped(s, shading->fast, light, stores);
    else
        glint_draw_interpolated_unclamped(s, shading->fast, light, stores);
}

/* The rows and spans of a part up to half a side from a middle. @return 0 where that is nothing */
static inline int glint_cut_square(glint_part *out, const glint_part *part, const glint_square *square, int32_t half) {
    const int32_t x = square->x - half - glint_shift_right(part->window.left, 4);
    const int32_t y = square->y - half - glint_shift_right(part->window.top, 4);
    int covers = 0;
    out->top = (uint32_t)glint_most((int32_t)part->top, y);
    out->bottom = (uint32_t)glint_most(glint_least((int32_t)part->bottom, y + 2 * half), 0);
    for (uint32_t row = out->top; row < out->bottom; row++) {
        int32_t left = part->spans[row].left, right = part->spans[row].right;
        left = left > x ? left : x;
        right = right < x + 2 * half ? right : x + 2 * half;
        covers |= left < right;
        out->spans[row].left = (uint8_t)left;
        out->spans[row].right = (uint8_t)(right > left ? right : left);
    }
    return covers;
}

/* A triangle that is drawn square by square. */
typedef struct glint_squares {
    const glint_frame *frame;
    glint_workspace *workspace;
    const glint_draw *draw;
    const glint_triangle *triangle;
    const glint_part *part;
    glint_part *cut; /* of it, all but rows and spans */
    glint_exact_light *light;
} glint_squares;

/* Draws what a square of 2^cell pixels holds. @return 0 where it is to be divided: its half vector bends too much */
static GLINT_NOINLINE int glint_draw_square(const glint_squares *s, int32_t x, int32_t y, uint32_t cell,
                                            glint_fast_store stores) {
    const glint_shading *shading = s->draw->shading;
    const int32_t half = 1 << cell >> 1;
    glint_square square = {x + half, y + half, 24 * half, 1};
    if (!glint_cut_square(s->cut, s->part, &square, half))
        return 1;
    const glint_exact_kind kind = glint_exact_bend(shading->fast, s->triangle, s->part, &square, s->light);
    const int fits = kind == GLINT_EXACT_DIFFUSE || (kind != GLINT_EXACT_UNFIT && square.is_small);
    if (!fits && cell > shading->fast->exact.cell)
        return 0;
    const glint_fast_spans spans = glint_fast_spans_of(s->frame, s->workspace, s->cut, stores);
    if (kind == GLINT_EXACT_UNFIT)
        glint_draw_any(s->frame, s->workspace, s->draw, s->triangle, s->cut);
    else
        glint_draw_curved_kind(s->workspace, &spans, shading, s->light, kind, stores);
    return 1;
}

/* Draws a triangle by squares, where the half vector bends too much: of twice the side that always fits, or quarters.
 */
static GLINT_NOINLINE void glint_draw_squares(const glint_frame *frame, glint_workspace *workspace,
                                              const glint_draw *draw, const glint_triangle *triangle,
                                              const glint_part *part, glint_exact_light *light,
                                              glint_fast_store stores) {
    const uint32_t least = draw->shading->fast->exact.cell;
    const uint32_t cell = (int32_t)least + light->size < GLINT_EXACT_MOST_TURN ? least + 1 : least;
    const int32_t side = 1 << cell, left = glint_shift_right(part->window.left, 4);
    const int32_t half = side / 2, top = glint_shift_right(part->window.top, 4);
    glint_part cut = *part;
    const glint_squares s = {frame, workspace, draw, triangle, part, &cut, light};
    for (int32_t y = (top + (int32_t)part->top) & -side; y < top + (int32_t)part->bottom; y += side)
        for (int32_t x = left & -side; x < left + part->window.width; x += side)
            if (!glint_draw_square(&s, x, y, cell, stores))
                for (int32_t i = 0; i < 4; i++)
                    glint_draw_square(&s, x + (i & 1) * half, y + (i >> 1) * half, least, stores);
}

/* @return 0 where nothing is drawn: the triangle does not fit */
static inline int glint_draw_exactly(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                     const glint_triangle *triangle, const glint_part *part, glint_fast_store stores) {
    const glint_fast_terms *fast = draw->shading->fast;
    const glint_fast_spans spans = glint_fast_spans_of(frame, workspace, part, stores);
    glint_exact_light light;
    glint_square square;
    glint_exact_kind kind = glint_exact_begin(draw, triangle, part, &light);
    if (kind == GLINT_EXACT_UNFIT)
        return 0;
    if (kind == GLINT_EXACT_SPECULAR && fast->local_viewer) {
        glint_exact_square(fast, triangle, &square);
        kind = glint_exact_bend(fast, triangle, part, &square, &light);
        if (square.is_small ? kind == GLINT_EXACT_UNFIT : kind != GLINT_EXACT_DIFFUSE) {
            const uint32_t cell = fast->exact.cell;
            if (square.is_small || cell < GLINT_EXACT_LEAST_CELL || (int32_t)cell + light.size > GLINT_EXACT_MOST_TURN)
                return 0;
            glint_draw_squares(frame, workspace, draw, triangle, part, &light, stores);
            return 1;
        }
    }
    glint_draw_curved_kind(workspace, &spans, draw->shading, &light, kind, stores);
    return 1;
}

/* A triangle that turns: interpolated where that fits, else exactly. @return 0 where nothing is drawn */
static inline int glint_draw_curved(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                    const glint_triangle *triangle, const glint_part *part, glint_fast_store stores) {
    const glint_fast_spans spans = glint_fast_spans_of(frame, workspace, part, stores);
    glint_interpolation own;
    const glint_interpolation *const light = glint_interpolation_find(workspace, draw, triangle, part, &own);
    if (light->kind == GLINT_EXACT_UNFIT)
        return glint_draw_exactly(frame, workspace, draw, triangle, part, stores);
    glint_draw_interpolated(workspace, &spans, draw->shading, light, light->kind, stores);
    return 1;
}

#endif
