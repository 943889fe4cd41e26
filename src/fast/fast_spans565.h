/* SPDX-License-Identifier: MIT */
/**
 * @file fast_spans565.h
 * Kernels of fast lighting for pixels of 16 bits: depth test, lighting and store in one loop over a span.
 */
#ifndef GLINT_FAST_SPANS565_H
#define GLINT_FAST_SPANS565_H

#include "../raster/spans.h"
#include "fast_begin.h"

/** Stores 16 bits at `pixel`, in the core's byte order or the high byte first. */
static inline void glint_put_565(uint8_t *pixel, uint32_t value, int high_first) {
    if (!high_first) {
        *(uint16_t *)(void *)pixel = (uint16_t)value;
        return;
    }
    pixel[0] = (uint8_t)(value >> 8);
    pixel[1] = (uint8_t)value;
}

/*
 * The loops carry the planes' values from the end of a span to the start of the next: that takes fewer registers than
 * keeping what they are where rows begin.
 */

/* The light of one colour all over. */
static inline void glint_draw_constant(const glint_spans *s, uint32_t colour, int high_first) {
    const glint_part *part = s->part;
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    const ptrdiff_t to_pixels = s->pixels - (uint8_t *)s->depth - GLINT_AHEAD, stride = 2 << s->shift;
    const uint32_t z_dx = (uint32_t)part->depth.dx;
    uint32_t z = glint_first_row(part, &part->depth) + GLINT_DEPTH_BIAS, column = 0;
    uint8_t *depth = (uint8_t *)(s->depth + (part->top << s->shift));
    do {
        const uint32_t left = span->left, right = span->right;
        span++;
        GLINT_OPAQUE(span);
        if (left < right) {
            depth += 2 * (int32_t)(left - column);
            z += z_dx * (left - column);
            uint8_t *const end = depth + 2 * (right - left);
            do {
                if (glint_next_is_nearest(&depth, z)) {
                    glint_put_565(depth + to_pixels, colour, high_first);
                }
                glint_step(&depth);
                z += z_dx;
            } while (depth != end);
            column = right;
        }
        depth += stride;
        z += (uint32_t)part->depth.dy;
    } while (span != last);
}

/* Diffuse light only; gated, ambient light alone where N.L <= 0. */
static inline void glint_draw_diffuse(const glint_spans *s, const glint_fast_terms *fast, const glint_plane *cosine,
                                      int gated, int high_first) {
    const glint_part *part = s->part;
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    const ptrdiff_t to_pixels = s->pixels - (uint8_t *)s->depth - GLINT_AHEAD, stride = 2 << s->shift;
    const uint16_t *const table = fast->diffuse_pixel;
    const uint32_t z_dx = (uint32_t)part->depth.dx, level_dx = (uint32_t)cosine->dx;
    uint32_t z = glint_first_row(part, &part->depth) + GLINT_DEPTH_BIAS, level = glint_first_row(part, cosine);
    uint32_t column = 0;
    uint8_t *depth = (uint8_t *)(s->depth + (part->top << s->shift));
    do {
        const uint32_t left = span->left, right = span->right;
        span++;
        GLINT_OPAQUE(span);
        if (left < right) {
            depth += 2 * (int32_t)(left - column);
            z += z_dx * (left - column);
            level += level_dx * (left - column);
            uint8_t *const end = depth + 2 * (right - left);
            do {
                if (glint_next_is_nearest(&depth, z)) {
                    glint_put_565(depth + to_pixels, gated && (int32_t)level <= 0 ? fast->ambient : table[level >> 22],
                                  high_first);
                }
                glint_step(&depth);
                z += z_dx;
                level += level_dx;
            } while (depth != end);
            column = right;
        }
        depth += stride;
        z += (uint32_t)part->depth.dy;
        level += (uint32_t)cosine->dy;
    } while (span != last);
}

/* A square of the high half of a plane. */
static inline uint32_t glint_high_square(uint32_t value) {
    const int32_t high = glint_shift_right((int32_t)value, 16);
    return (uint32_t)(high * high);
}

/* The sum of the squares of the high halves of x and y, added to `sum`: products and sums in one where a core can. */
static inline int32_t glint_squares_from(uint32_t sum, uint32_t x, uint32_t y) {
    sum += glint_high_square(x);
    if (!GLINT_SPLIT_PRODUCTS)
        GLINT_OPAQUE(sum);
    return (int32_t)(sum + glint_high_square(y));
}

/* Diffuse and specular light. */
static GLINT_INLINE void glint_draw_highlight(const glint_spans *s, const glint_fast_terms *fast,
                                              const glint_fast_planes *planes, int high_first) {
    const glint_part *part = s->part;
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    const ptrdiff_t to_pixels = s->pixels - (uint8_t *)s->depth - GLINT_AHEAD, stride = 2 << s->shift;
    const uint32_t *const diffuse = fast->diffuse;
    const uint16_t *const packed = fast->diffuse_pixel;
    const unsigned early = GLINT_SPLIT_PRODUCTS ? 0 : 15; /* a shift tests the sign too; not so ARMv6-M's compiler */
    uint32_t less_end = 0u - fast->specular_end;
    GLINT_OPAQUE(less_end);
    const uint32_t z_dx = (uint32_t)part->depth.dx, level_dx = (uint32_t)planes->cosine.dx;
    const uint32_t x_dx = (uint32_t)planes->x.dx, y_dx = (uint32_t)planes->y.dx;
    uint32_t z = glint_first_row(part, &part->depth) + GLINT_DEPTH_BIAS;
    uint32_t level = glint_first_row(part, &planes->cosine);
    uint32_t x = glint_first_row(part, &planes->x), y = glint_first_row(part, &planes->y);
    uint32_t column = 0;
    uint8_t *depth = (uint8_t *)(s->depth + (part->top << s->shift));
    do {
        const uint32_t left = span->left, right = span->right;
        span++;
        GLINT_OPAQUE(span);
        if (left < right) {
            depth += 2 * (int32_t)(left - column);
            z += z_dx * (left - column);
            level += level_dx * (left - column);
            x += x_dx * (left - column);
            y += y_dx * (left - column);
            uint8_t *const end = depth + 2 * (right - left);
            const uint32_t z_step = glint_hold(z_dx), level_step = glint_hold(level_dx), x_step = glint_hold(x_dx),
                           y_step = glint_hold(y_dx);
            do {
                if (glint_next_is_nearest(&depth, z)) {
                    GLINT_BARRIER();
                    /* the highlight's table ends where the diffuse one begins */
                    const int32_t beyond = glint_shift_right(glint_squares_from(less_end, x, y), early);
                    const uint32_t *const word = diffuse + (level >> 22);
                    if (beyond < 0)
                        glint_put_565(depth + to_pixels,
                                      glint_spread_pack(
                                          glint_spread_clamp(*word + diffuse[glint_shift_right(beyond, 15 - early)])),
                                      high_first);
                    else
                        glint_put_565(depth + to_pixels, packed[level >> 22], high_first);
                }
                glint_step(&depth);
                z += z_step;
                level += level_step;
                x += x_step;
                y += y_step;
            } while (depth != end);
            column = right;
        }
        depth += stride;
        z += (uint32_t)part->depth.dy;
        level += (uint32_t)planes->cosine.dy;
        x += (uint32_t)planes->x.dy;
        y += (uint32_t)planes->y.dy;
    } while (span != last);
}

/* The same, its squared deviation stepped. */
static inline void glint_draw_stepped(const glint_spans *s, const glint_fast_terms *fast,
                                      const glint_fast_planes *planes, int high_first) {
    const glint_part *part = s->part;
    const glint_quadratic square = glint_square_begin(&planes->x, &planes->y);
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    const ptrdiff_t to_pixels = s->pixels - (uint8_t *)s->depth - GLINT_AHEAD, stride = 2 << s->shift;
    const uint32_t *const diffuse = fast->diffuse;
    const uint16_t *const packed = fast->diffuse_pixel;
    const uint32_t z_dx = (uint32_t)part->depth.dx, level_dx = (uint32_t)planes->cosine.dx, x = (uint32_t)part->x;
    uint32_t z = glint_first_row(part, &part->depth) + GLINT_DEPTH_BIAS;
    uint32_t level = glint_first_row(part, &planes->cosine), y = (uint32_t)part->y + part->top, column = 0;
    glint_stride beyond = glint_stride_begin(&square, part->x, (int32_t)y);
    beyond.value -= fast->specular_end << GLINT_SQUARE_BITS;
    uint8_t *depth = (uint8_t *)(s->depth + (part->top << s->shift));
    do {
        const uint32_t left = span->left, right = span->right;
        span++;
        GLINT_OPAQUE(span);
        if (left < right) {
            depth += 2 * (int32_t)(left - column);
            z += z_dx * (left - column);
            level += level_dx * (left - column);
            glint_stride_move(&beyond, &square, left - column);
            uint8_t *const end = depth + 2 * (right - left);
            const uint32_t z_step = glint_hold(z_dx), level_step = glint_hold(level_dx);
            do {
                if (glint_next_is_nearest(&depth, z)) {
                    GLINT_BARRIER();
                    /* the highlight's table ends where the diffuse one begins */
                    const int32_t entry = glint_shift_right((int32_t)beyond.value, 15 + GLINT_SQUARE_BITS);
                    const uint32_t *const word = diffuse + (level >> 22);
                    if (entry < 0)
                        glint_put_565(depth + to_pixels, glint_spread_pack(glint_spread_clamp(*word + diffuse[entry])),
                                      high_first);
                    else
                        glint_put_565(depth + to_pixels, packed[level >> 22], high_first);
                }
                glint_step(&depth);
                z += z_step;
                level += level_step;
                glint_stride_next(&beyond, &square);
            } while (depth != end);
            column = right;
        }
        depth += stride;
        z += (uint32_t)part->depth.dy;
        level += (uint32_t)planes->cosine.dy;
        glint_stride_down(&beyond, &square, x + column, y);
        y++;
    } while (span != last);
}

/* A large triangle with a highlight. Out of line, where it has all registers for itself. */
static GLINT_NOINLINE void glint_draw_large(const glint_frame *frame, const glint_workspace *workspace,
                                            const glint_draw *draw, const glint_part *part,
                                            const glint_fast_planes *planes, int high_first) {
    const glint_spans spans = {part, workspace->depth, workspace->pixels, frame->tile_shift_x};
    if (glint_square_fits(&part->gradients, planes))
        glint_draw_stepped(&spans, draw->shading->fast, planes, high_first);
    else
        glint_draw_highlight(&spans, draw->shading->fast, planes, high_first);
}

/* All of these, with words that are computed. */
static GLINT_NOINLINE void glint_draw_without_tables(const glint_frame *frame, const glint_workspace *workspace,
                                                     const glint_draw *draw, const glint_triangle *triangle,
                                                     const glint_part *part, const glint_fast_planes *planes,
                                                     glint_fast_kind kind, int high_first) {
    const glint_shading *shading = draw->shading;
    const glint_spans s = {part, workspace->depth, workspace->pixels, frame->tile_shift_x};
    const int is_stepped = kind == GLINT_FAST_SPECULAR && triangle->area >= GLINT_LARGE_AREA &&
                           glint_square_fits(&part->gradients, planes);
    glint_quadratic sum = {0, 0, 0, 0, 0, 0};
    if (is_stepped)
        sum = glint_square_begin(&planes->x, &planes->y);
    for (uint32_t row = part->top; row < part->bottom; row++) {
        const glint_span span = part->spans[row];
        for (uint32_t column = span.left; column < span.right; column++) {
            const int32_t x = part->x + (int32_t)column, y = part->y + (int32_t)row;
            const uint32_t offset = (row << s.shift) + column;
            if (!glint_is_nearest((uint8_t *)(s.depth + offset),
                                  (uint32_t)glint_plane_at(&part->depth, x, y) + GLINT_DEPTH_BIAS))
                continue;
            const int32_t level = glint_plane_at(&planes->cosine, x, y);
            uint32_t square = UINT32_MAX;
            if (is_stepped)
                square = glint_stride_begin(&sum, x, y).value >> GLINT_SQUARE_BITS;
            else if (kind == GLINT_FAST_SPECULAR)
                square = glint_high_square((uint32_t)glint_plane_at(&planes->x, x, y)) +
                         glint_high_square((uint32_t)glint_plane_at(&planes->y, x, y));
            glint_put_565(s.pixels + 2 * offset, glint_fast_pixel(shading, level, square), high_first);
        }
    }
}

#endif
