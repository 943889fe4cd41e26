/* SPDX-License-Identifier: MIT */
/** @file fast_exact565.h Kernels of exact lighting for pixels of 16 bits, as those of fast_spans565.h are. */
#ifndef GLINT_FAST_EXACT565_H
#define GLINT_FAST_EXACT565_H

#include "../light/evaluation.h"
#include "fast_exact.h"
#include "fast_spans565.h"

/* A plane at a pixel. */
static inline uint32_t glint_at(const glint_plane *plane, int32_t x, int32_t y) {
    return (uint32_t)glint_plane_at(plane, x, y);
}

/*
 * Loops of several quadratics find what a span begins with from the coefficients: with second differences, that takes
 * fewer instructions than carrying it on from the span above.
 */

/* Diffuse light; ambient light alone where N.L <= 0. */
static inline void glint_draw_curved_diffuse(const glint_spans *s, const glint_fast_terms *fast,
                                             const glint_exact_light *light, int high_first) {
    const glint_part *part = s->part;
    const ptrdiff_t to_pixels = s->pixels - (uint8_t *)s->depth - GLINT_AHEAD;
    const uint16_t *const table = fast->diffuse_pixel, *const root = glint_root_table;
    const uint32_t z_dx = (uint32_t)part->depth.dx, a_dx = (uint32_t)light->cosine.dx;
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    uint8_t *row = (uint8_t *)(s->depth + (part->top << s->shift));
    for (int32_t y = part->y + (int32_t)part->top; span != last; span++, y++, row += 2 << s->shift) {
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
                glint_put_565(depth + to_pixels,
                              (int32_t)a <= 0 ? fast->ambient : table[(a >> 15) * root[c.value >> 22] >> 22],
                              high_first);
            glint_step(&depth);
            z += z_dx;
            a += a_dx;
            glint_stride_next(&c, &light->square);
        } while (depth != end);
    }
}

/* Half a plane's value, 1 = 2^15, squared. */
static inline uint32_t glint_middle_square(uint32_t value) {
    const uint32_t middle = (uint32_t)glint_shift_right((int32_t)value, 15);
    return middle * middle;
}

/* The pixel of a lit fragment: M.L, 1 / |M| and the squared deviation over w. */
static inline uint32_t glint_exact_lit(const glint_fast_terms *fast, uint32_t a, uint32_t inverse, uint32_t square) {
    const uint32_t level = (a >> 15) * inverse >> 22;
    if (square < fast->exact.limit) {
        square = (square >> fast->exact.shift) * (inverse * inverse >> 16);
        if (square < fast->exact.end)
            return glint_spread_pack(glint_spread_clamp(fast->diffuse[level] + fast->specular[square >> 20]));
    }
    return fast->diffuse_pixel[level];
}

/* Diffuse and specular light. */
static inline void glint_draw_curved_specular(const glint_spans *s, const glint_fast_terms *fast,
                                              const glint_exact_light *light, int high_first) {
    const glint_part *part = s->part;
    const ptrdiff_t to_pixels = s->pixels - (uint8_t *)s->depth - GLINT_AHEAD;
    const uint32_t z_dx = (uint32_t)part->depth.dx, a_dx = (uint32_t)light->cosine.dx;
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    uint8_t *row = (uint8_t *)(s->depth + (part->top << s->shift));
    for (int32_t y = part->y + (int32_t)part->top; span != last; span++, y++, row += 2 << s->shift) {
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
                uint32_t pixel = fast->ambient;
                if ((int32_t)a > 0)
                    pixel = glint_exact_lit(fast, a, glint_root_table[c.value >> 22],
                                            glint_middle_square(ex.value) + glint_middle_square(ey.value));
                glint_put_565(depth + to_pixels, pixel, high_first);
            }
            glint_step(&depth);
            z += z_dx;
            a += a_dx;
            glint_stride_next(&c, &light->square);
            glint_stride_next(&ex, &light->x);
            glint_stride_next(&ey, &light->y);
        } while (depth != end);
    }
}

/* Interpolated diffuse light; gated, ambient light alone where N.L <= 0. */
static GLINT_INLINE void glint_draw_interpolated_diffuse(const glint_spans *s, const glint_fast_terms *fast,
                                                         const glint_interpolation *light, int gated, int high_first) {
    const glint_part *part = s->part;
    const ptrdiff_t to_pixels = s->pixels - (uint8_t *)s->depth - GLINT_AHEAD, stride = 2 << s->shift;
    const uint16_t *const table = fast->diffuse_pixel;
    const uint32_t z_dx = (uint32_t)part->depth.dx;
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    const uint32_t x = (uint32_t)part->x;
    uint32_t y = (uint32_t)part->y + part->top, column = 0;
    uint32_t z = glint_first_row(part, &part->depth) + GLINT_DEPTH_BIAS;
    glint_stride c = glint_stride_begin(&light->cosine, part->x, (int32_t)y);
    uint8_t *depth = (uint8_t *)(s->depth + (part->top << s->shift));
    do {
        const uint32_t left = span->left, right = span->right;
        span++;
        GLINT_OPAQUE(span);
        if (left < right) {
            depth += 2 * (int32_t)(left - column);
            z += z_dx * (left - column);
            glint_stride_move(&c, &light->cosine, left - column);
            uint8_t *const end = depth + 2 * (right - left);
            do {
                if (glint_next_is_nearest(&depth, z))
                    glint_put_565(depth + to_pixels,
                                  gated && (int32_t)c.value <= 0 ? fast->ambient : table[c.value >> 22], high_first);
                glint_step(&depth);
                z += z_dx;
                glint_stride_next(&c, &light->cosine);
            } while (depth != end);
            column = right;
        }
        depth += stride;
        z += (uint32_t)part->depth.dy;
        glint_stride_down(&c, &light->cosine, x + column, y);
        y++;
    } while (span != last);
}

/* Interpolated diffuse and specular light; clamped, their sum may pass 1. */
static GLINT_INLINE void glint_draw_interpolated_specular(const glint_spans *s, const glint_fast_terms *fast,
                                                          const glint_interpolation *light, int clamped,
                                                          int high_first) {
    const glint_part *part = s->part;
    const ptrdiff_t to_pixels = s->pixels - (uint8_t *)s->depth - GLINT_AHEAD;
    const uint32_t *const diffuse = fast->diffuse;
    const uint16_t *const packed = fast->diffuse_pixel;
    const unsigned early = GLINT_SPLIT_PRODUCTS ? 0 : 15; /* as in glint_draw_highlight */
    uint32_t less_end = 0u - fast->specular_end;
    GLINT_OPAQUE(less_end);
    const uint32_t z_dx = (uint32_t)part->depth.dx;
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    uint8_t *row = (uint8_t *)(s->depth + (part->top << s->shift));
    for (int32_t y = part->y + (int32_t)part->top; span != last; span++, y++, row += 2 << s->shift) {
        const uint32_t left = span->left, right = span->right;
        if (left >= right)
            continue;
        const int32_t x = part->x + (int32_t)left;
        uint32_t z = glint_at(&part->depth, x, y) + GLINT_DEPTH_BIAS;
        glint_stride c = glint_stride_begin(&light->cosine, x, y);
        glint_stride ex = glint_stride_begin(&light->x, x, y), ey = glint_stride_begin(&light->y, x, y);
        uint8_t *depth = row + 2 * left;
        const uint8_t *const end = row + 2 * right;
        do {
            if (glint_next_is_nearest(&depth, z)) {
                GLINT_BARRIER();
                /* the highlight's table ends where the diffuse one begins */
                const int32_t beyond = glint_shift_right(glint_squares_from(less_end, ex.value, ey.value), early);
                const uint32_t level = c.value >> 22;
                if (beyond < 0) {
                    const uint32_t word = diffuse[level] + diffuse[glint_shift_right(beyond, 15 - early)];
                    glint_put_565(depth + to_pixels, glint_spread_pack(clamped ? glint_spread_clamp(word) : word),
                                  high_first);
                } else {
                    glint_put_565(depth + to_pixels, packed[level], high_first);
                }
            }
            glint_step(&depth);
            z += z_dx;
            glint_stride_next(&c, &light->cosine);
            glint_stride_next(&ex, &light->x);
            glint_stride_next(&ey, &light->y);
        } while (depth != end);
    }
}

/* Out of line, where each has all registers for itself. */
static GLINT_NOINLINE void glint_draw_interpolated_gated(const glint_spans *s, const glint_fast_terms *fast,
                                                         const glint_interpolation *light, int high_first) {
    glint_draw_interpolated_diffuse(s, fast, light, 1, high_first);
}

static GLINT_NOINLINE void glint_draw_interpolated_lit(const glint_spans *s, const glint_fast_terms *fast,
                                                       const glint_interpolation *light, int high_first) {
    glint_draw_interpolated_diffuse(s, fast, light, 0, high_first);
}

static GLINT_NOINLINE void glint_draw_interpolated_clamped(const glint_spans *s, const glint_fast_terms *fast,
                                                           const glint_interpolation *light, int high_first) {
    glint_draw_interpolated_specular(s, fast, light, 1, high_first);
}

static GLINT_NOINLINE void glint_draw_interpolated_unclamped(const glint_spans *s, const glint_fast_terms *fast,
                                                             const glint_interpolation *light, int high_first) {
    glint_draw_interpolated_specular(s, fast, light, 0, high_first);
}

/* The pixel of a fragment, packed, with words that are computed. */
static inline uint32_t glint_interpolated_pixel(const glint_shading *shading, const glint_interpolation *light,
                                                int shows, int32_t x, int32_t y) {
    uint32_t square = UINT32_MAX;
    if (shows)
        square = glint_high_square(glint_stride_begin(&light->x, x, y).value) +
                 glint_high_square(glint_stride_begin(&light->y, x, y).value);
    return glint_fast_pixel(shading, (int32_t)glint_stride_begin(&light->cosine, x, y).value, square);
}

/* The same for exact lighting. */
static inline uint32_t glint_exact_pixel(const glint_shading *shading, const glint_exact_light *light, int shows,
                                         int32_t x, int32_t y) {
    const glint_exact_limits *limits = &shading->fast->exact;
    const uint32_t a = (uint32_t)glint_plane_at(&light->cosine, x, y);
    const uint32_t inverse = glint_root_table[glint_stride_begin(&light->square, x, y).value >> 22];
    uint32_t square = UINT32_MAX;
    if ((int32_t)a <= 0)
        return shading->fast->ambient;
    if (shows) {
        square = glint_middle_square(glint_stride_begin(&light->x, x, y).value) +
                 glint_middle_square(glint_stride_begin(&light->y, x, y).value);
        square = square < limits->limit ? (square >> limits->shift) * (inverse * inverse >> 16) : UINT32_MAX;
    }
    /* one step of N.L is as good as none */
    return glint_fast_pixel(shading, (int32_t)((a >> 15) * inverse) | 1,
                            square < limits->end ? square >> 5 : UINT32_MAX);
}

/* All of these, without tables; one of `light` and `interpolation` is null. */
static GLINT_NOINLINE void glint_draw_curved_without_tables(const glint_spans *s, const glint_shading *shading,
                                                            const glint_exact_light *light,
                                                            const glint_interpolation *interpolation, int shows,
                                                            int high_first) {
    const glint_part *part = s->part;
    for (uint32_t row = part->top; row < part->bottom; row++) {
        const glint_span span = part->spans[row];
        for (uint32_t column = span.left; column < span.right; column++) {
            const int32_t x = part->x + (int32_t)column, y = part->y + (int32_t)row;
            const uint32_t offset = (row << s->shift) + column;
            const uint32_t here = ((uint32_t)glint_plane_at(&part->depth, x, y) + (1u << 15)) >> 15;
            if (here <= s->depth[offset])
                continue;
            s->depth[offset] = (uint16_t)here;
            glint_put_565(s->pixels + 2 * offset,
                          light ? glint_exact_pixel(shading, light, shows, x, y)
                                : glint_interpolated_pixel(shading, interpolation, shows, x, y),
                          high_first);
        }
    }
}

static inline void glint_draw_curved_kind(const glint_workspace *workspace, const glint_spans *s,
                                          const glint_shading *shading, const glint_exact_light *light,
                                          glint_exact_kind kind, int high_first) {
    const glint_fast_terms *fast = shading->fast;
    if (workspace->drawn)
        glint_count(workspace, (glint_kernel_name)kind, glint_fast_covered(s->part));
    if (kind == GLINT_EXACT_AMBIENT)
        glint_draw_constant(s, fast->ambient, high_first);
    else if (!fast->diffuse)
        glint_draw_curved_without_tables(s, shading, light, 0, kind == GLINT_EXACT_SPECULAR, high_first);
    else if (kind == GLINT_EXACT_DIFFUSE)
        glint_draw_curved_diffuse(s, fast, light, high_first);
    else
        glint_draw_curved_specular(s, fast, light, high_first);
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
                                            int high_first) {
    const glint_shading *shading = s->draw->shading;
    const int32_t half = 1 << cell >> 1;
    glint_square square = {x + half, y + half, 24 * half, 1};
    if (!glint_cut_square(s->cut, s->part, &square, half))
        return 1;
    const glint_exact_kind kind = glint_exact_bend(shading->fast, s->triangle, s->part, &square, s->light);
    const int fits = kind == GLINT_EXACT_DIFFUSE || (kind != GLINT_EXACT_UNFIT && square.is_small);
    if (!fits && cell > shading->fast->exact.cell)
        return 0;
    const glint_spans spans = {s->cut, s->workspace->depth, s->workspace->pixels, s->frame->tile_shift_x};
    if (kind == GLINT_EXACT_UNFIT)
        glint_draw_any(s->frame, s->workspace, s->draw, s->triangle, s->cut);
    else
        glint_draw_curved_kind(s->workspace, &spans, shading, s->light, kind, high_first);
    return 1;
}

/* Draws a triangle by squares, where the half vector bends too much: of twice the side that always fits, or quarters.
 */
static GLINT_NOINLINE void glint_draw_squares(const glint_frame *frame, glint_workspace *workspace,
                                              const glint_draw *draw, const glint_triangle *triangle,
                                              const glint_part *part, glint_exact_light *light, int high_first) {
    const uint32_t least = draw->shading->fast->exact.cell;
    const uint32_t cell = (int32_t)least + light->size < GLINT_EXACT_MOST_TURN ? least + 1 : least;
    const int32_t side = 1 << cell, left = glint_shift_right(part->window.left, 4);
    const int32_t half = side / 2, top = glint_shift_right(part->window.top, 4);
    glint_part cut = *part;
    const glint_squares s = {frame, workspace, draw, triangle, part, &cut, light};
    for (int32_t y = (top + (int32_t)part->top) & -side; y < top + (int32_t)part->bottom; y += side)
        for (int32_t x = left & -side; x < left + part->window.width; x += side)
            if (!glint_draw_square(&s, x, y, cell, high_first))
                for (int32_t i = 0; i < 4; i++)
                    glint_draw_square(&s, x + (i & 1) * half, y + (i >> 1) * half, least, high_first);
}

static inline void glint_draw_interpolated(const glint_workspace *workspace, const glint_spans *s,
                                           const glint_shading *shading, const glint_interpolation *light,
                                           glint_exact_kind kind, int high_first) {
    if (workspace->drawn)
        glint_count(workspace, (glint_kernel_name)kind, glint_fast_covered(s->part));
    if (!shading->fast->diffuse)
        glint_draw_curved_without_tables(s, shading, 0, light, kind == GLINT_EXACT_SPECULAR, high_first);
    else if (kind == GLINT_EXACT_DIFFUSE && (GLINT_SMALL || light->gated))
        glint_draw_interpolated_gated(s, shading->fast, light, high_first);
    else if (kind == GLINT_EXACT_DIFFUSE)
        glint_draw_interpolated_lit(s, shading->fast, light, high_first);
    else if (GLINT_SMALL || light->clamped)
        glint_draw_interpolated_clamped(s, shading->fast, light, high_first);
    else
        glint_draw_interpolated_unclamped(s, shading->fast, light, high_first);
}

/* @return 0 where nothing is drawn: the triangle does not fit */
static inline int glint_draw_exactly(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                     const glint_triangle *triangle, const glint_part *part, int high_first) {
    const glint_fast_terms *fast = draw->shading->fast;
    const glint_spans spans = {part, workspace->depth, workspace->pixels, frame->tile_shift_x};
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
            glint_draw_squares(frame, workspace, draw, triangle, part, &light, high_first);
            return 1;
        }
    }
    glint_draw_curved_kind(workspace, &spans, draw->shading, &light, kind, high_first);
    return 1;
}

/* A triangle that turns: interpolated where that fits, else exactly. @return 0 where nothing is drawn */
static inline int glint_draw_curved(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                    const glint_triangle *triangle, const glint_part *part, int high_first) {
    const glint_spans spans = {part, workspace->depth, workspace->pixels, frame->tile_shift_x};
    glint_interpolation own;
    const glint_interpolation *const light = glint_interpolation_find(workspace, draw, triangle, part, &own);
    if (light->kind == GLINT_EXACT_UNFIT)
        return glint_draw_exactly(frame, workspace, draw, triangle, part, high_first);
    glint_draw_interpolated(workspace, &spans, draw->shading, light, light->kind, high_first);
    return 1;
}

#endif
