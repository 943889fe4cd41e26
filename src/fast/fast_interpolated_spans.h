/* SPDX-License-Identifier: MIT */
/** @file fast_interpolated_spans.h Kernels of interpolated lighting, as those of fast_spans.h are. */
#ifndef GLINT_FAST_INTERPOLATED_SPANS_H
#define GLINT_FAST_INTERPOLATED_SPANS_H

#include "fast_exact.h"
#include "fast_spans.h"

/* A plane at a pixel. */
static inline uint32_t glint_at(const glint_plane *plane, int32_t x, int32_t y) {
    return (uint32_t)glint_plane_at(plane, x, y);
}

/*
 * Loops of several quadratics find what a span begins with from the coefficients: with second differences, that takes
 * fewer instructions than carrying it on from the span above.
 */

/* Interpolated diffuse light; gated, ambient light alone where N.L <= 0. */
static GLINT_INLINE void glint_draw_interpolated_diffuse(const glint_fast_spans *s, const glint_fast_terms *fast,
                                                         const glint_interpolation *light, int gated,
                                                         glint_fast_store stores) {
    const glint_part *part = s->of.part;
    const ptrdiff_t stride = 2 << s->of.shift;
    glint_fast_output to = glint_output_begin(s, stores);
    const void *const stored = fast->diffuse_stored;
    const uint32_t z_dx = (uint32_t)part->depth.dx;
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    const uint32_t x = (uint32_t)part->x;
    uint32_t y = (uint32_t)part->y + part->top, column = 0;
    uint32_t z = glint_first_row(part, &part->depth) + GLINT_DEPTH_BIAS;
    glint_stride c = glint_stride_begin(&light->cosine, part->x, (int32_t)y);
    uint8_t *depth = (uint8_t *)(s->of.depth + (part->top << s->of.shift));
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
                    glint_output_put(&to, s, depth,
                                     gated && (int32_t)c.value <= 0 ? glint_ambient_of(fast, stores)
                                                                    : glint_colour_at(stored, c.value >> 22, stores),
                                     stores);
                glint_step(&depth);
                z += z_dx;
                glint_stride_next(&c, &light->cosine);
            } while (depth != end);
            column = right;
            glint_output_end_row(&to, s, stores);
        }
        depth += stride;
        z += (uint32_t)part->depth.dy;
        glint_stride_down(&c, &light->cosine, x + column, y);
        y++;
    } while (span != last);
    glint_output_end(&to, s, stores);
}

/* Interpolated diffuse and specular light; clamped, their sum may pass 1. */
static GLINT_INLINE void glint_draw_interpolated_specular(const glint_fast_spans *s, const glint_fast_terms *fast,
                                                          const glint_interpolation *light, int clamped,
                                                          glint_fast_store stores) {
    const glint_part *part = s->of.part;
    glint_fast_output to = glint_output_begin(s, stores);
    const uint32_t *const diffuse = fast->diffuse;
    const void *const stored = fast->diffuse_stored;
    const unsigned early = GLINT_SPLIT_PRODUCTS ? 0 : 15; /* as in glint_draw_highlight */
    uint32_t less_end = 0u - fast->specular_end;
    GLINT_OPAQUE(less_end);
    const uint32_t z_dx = (uint32_t)part->depth.dx;
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    uint8_t *row = (uint8_t *)(s->of.depth + (part->top << s->of.shift));
    for (int32_t y = part->y + (int32_t)part->top; span != last; span++, y++, row += 2 << s->of.shift) {
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
                    glint_output_put(&to, s, depth, glint_colour_of(word, clamped, stores), stores);
                } else {
                    glint_output_put(&to, s, depth, glint_colour_at(stored, level, stores), stores);
                }
            }
            glint_step(&depth);
            z += z_dx;
            glint_stride_next(&c, &light->cosine);
            glint_stride_next(&ex, &light->x);
            glint_stride_next(&ey, &light->y);
        } while (depth != end);
        glint_output_end_row(&to, s, stores);
    }
    glint_output_end(&to, s, stores);
}

/* Out of line, where each has all registers for itself. */
static GLINT_NOINLINE void glint_draw_interpolated_gated(const glint_fast_spans *s, const glint_fast_terms *fast,
                                                         const glint_interpolation *light, glint_fast_store stores) {
    glint_draw_interpolated_diffuse(s, fast, light, 1, stores);
}

static GLINT_NOINLINE void glint_draw_interpolated_lit(const glint_fast_spans *s, const glint_fast_terms *fast,
                                                       const glint_interpolation *light, glint_fast_store stores) {
    glint_draw_interpolated_diffuse(s, fast, light, 0, stores);
}

static GLINT_NOINLINE void glint_draw_interpolated_clamped(const glint_fast_spans *s, const glint_fast_terms *fast,
                                                           const glint_interpolation *light, glint_fast_store stores) {
    glint_draw_interpolated_specular(s, fast, light, 1, stores);
}

static GLINT_NOINLINE void glint_draw_interpolated_unclamped(const glint_fast_spans *s, const glint_fast_terms *fast,
                                                             const glint_interpolation *light,
                                                             glint_fast_store stores) {
    glint_draw_interpolated_specular(s, fast, light, 0, stores);
}

#endif
