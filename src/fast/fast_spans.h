/* SPDX-License-Identifier: MIT */
/**
 * @file fast_spans.h
 * Kernels of fast lighting: depth test, lighting and store in one loop over a span. What they store is a constant where
 * they are inlined.
 */
#ifndef GLINT_FAST_SPANS_H
#define GLINT_FAST_SPANS_H

#include "../pixel/format.h"
#include "../raster/spans.h"
#include "fast_begin.h"

/** What kernels store: pixels of 16 bits, in the core's byte order or the high byte first; or words, which the format
 * makes pixels of. */
typedef enum glint_fast_store { GLINT_STORES_565, GLINT_STORES_565_BE, GLINT_STORES_SPREAD } glint_fast_store;

/** What kernels share. Words go where rows do, which has room for those of three of the tile's rows. */
typedef struct glint_fast_spans {
    glint_spans of;
    const glint_frame *frame; /* of words, and */
    const glint_workspace *workspace;
} glint_fast_spans;

static GLINT_INLINE glint_fast_spans glint_fast_spans_of(const glint_frame *frame, const glint_workspace *workspace,
                                                         const glint_part *part, glint_fast_store stores) {
    glint_fast_spans s = {glint_spans_of(frame, workspace, part), 0, 0};
    if (stores == GLINT_STORES_SPREAD) {
        s.frame = frame;
        s.workspace = workspace;
    }
    return s;
}

/** Where a part's words go. */
static inline glint_spread *glint_words_of(const glint_fast_spans *s) {
    return (glint_spread *)(void *)s->workspace->row;
}

/** Makes pixels of words. */
static inline void glint_store_words(const glint_fast_spans *s, const glint_spread *words, const glint_spread *end) {
    s->frame->config.format->store_spread(s->of.pixels, s->of.shift, words, end);
}

/** Where the pixels of a part go. */
typedef struct glint_fast_output {
    ptrdiff_t to_pixels;   /* from a pixel's depth, or a pixel ahead of it, to it; */
    const uint16_t *ahead; /* of words: glint_ahead_of, */
    glint_spread *next;    /* and where the next one goes */
} glint_fast_output;

static GLINT_INLINE glint_fast_output glint_output_begin(const glint_fast_spans *s, glint_fast_store stores) {
    glint_fast_output to = {0, 0, 0};
    if (stores == GLINT_STORES_SPREAD) {
        to.ahead = glint_ahead_of(&s->of);
        to.next = glint_words_of(s);
    } else {
        to.to_pixels = s->of.pixels - (uint8_t *)s->of.depth - GLINT_AHEAD;
    }
    return to;
}

/** Stores 16 bits. */
static GLINT_INLINE void glint_put_565(uint8_t *pixel, uint32_t colour, glint_fast_store stores) {
    if (stores == GLINT_STORES_565) {
        *(uint16_t *)(void *)pixel = (uint16_t)colour;
        return;
    }
    pixel[0] = (uint8_t)(colour >> 8);
    pixel[1] = (uint8_t)colour;
}

/** Stores the pixel whose depth was tested last. */
static GLINT_INLINE void glint_output_put(glint_fast_output *to, const glint_fast_spans *s, uint8_t *depth,
                                          uint32_t colour, glint_fast_store stores) {
    if (stores == GLINT_STORES_SPREAD)
        *to->next++ = (glint_spread){glint_offset_of(&s->of, to->ahead, depth), colour};
    else
        glint_put_565(depth + to->to_pixels, colour, stores);
}

/** Ends a row: makes pixels of words if there is no room for those of another. */
static GLINT_INLINE void glint_output_end_row(glint_fast_output *to, const glint_fast_spans *s,
                                              glint_fast_store stores) {
    if (stores != GLINT_STORES_SPREAD || to->next <= glint_words_of(s) + 2 * s->frame->config.tile_width)
        return;
    glint_store_words(s, glint_words_of(s), to->next);
    to->next = glint_words_of(s);
}

/** Ends a part. */
static GLINT_INLINE void glint_output_end(const glint_fast_output *to, const glint_fast_spans *s,
                                          glint_fast_store stores) {
    if (stores == GLINT_STORES_SPREAD)
        glint_store_words(s, glint_words_of(s), to->next);
}

/** The colour of a word, as it is stored; those that may be beyond 1 are clamped. */
static GLINT_INLINE uint32_t glint_colour_of(uint32_t word, int clamped, glint_fast_store stores) {
    return stores == GLINT_STORES_SPREAD ? word : glint_spread_pack(clamped ? glint_spread_clamp(word) : word);
}

/** An entry of `diffuse_stored`. */
static GLINT_INLINE uint32_t glint_colour_at(const void *stored, uint32_t level, glint_fast_store stores) {
    return stores == GLINT_STORES_SPREAD ? ((const uint32_t *)stored)[level] : ((const uint16_t *)stored)[level];
}

static GLINT_INLINE uint32_t glint_ambient_of(const glint_fast_terms *fast, glint_fast_store stores) {
    return stores == GLINT_STORES_SPREAD ? fast->ambient_word : fast->ambient;
}

/*
 * The loops carry the planes' values from the end of a span to the start of the next: that takes fewer registers than
 * keeping what they are where rows begin.
 */

/* The light of one colour all over. */
static inline void glint_draw_constant(const glint_fast_spans *s, uint32_t colour, glint_fast_store stores) {
    const glint_part *part = s->of.part;
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    const ptrdiff_t stride = 2 << s->of.shift;
    glint_fast_output to = glint_output_begin(s, stores);
    const uint32_t z_dx = (uint32_t)part->depth.dx;
    uint32_t z = glint_first_row(part, &part->depth) + GLINT_DEPTH_BIAS, column = 0;
    uint8_t *depth = (uint8_t *)(s->of.depth + (part->top << s->of.shift));
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
                    glint_output_put(&to, s, depth, colour, stores);
                }
                glint_step(&depth);
                z += z_dx;
            } while (depth != end);
            column = right;
            glint_output_end_row(&to, s, stores);
        }
        depth += stride;
        z += (uint32_t)part->depth.dy;
    } while (span != last);
    glint_output_end(&to, s, stores);
}

/* Diffuse light only; gated, ambient light alone where N.L <= 0. */
static inline void glint_draw_diffuse(const glint_fast_spans *s, const glint_fast_terms *fast,
                                      const glint_plane *cosine, int gated, glint_fast_store stores) {
    const glint_part *part = s->of.part;
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    const ptrdiff_t stride = 2 << s->of.shift;
    glint_fast_output to = glint_output_begin(s, stores);
    const void *const stored = fast->diffuse_stored;
    const uint32_t z_dx = (uint32_t)part->depth.dx, level_dx = (uint32_t)cosine->dx;
    uint32_t z = glint_first_row(part, &part->depth) + GLINT_DEPTH_BIAS, level = glint_first_row(part, cosine);
    uint32_t column = 0;
    uint8_t *depth = (uint8_t *)(s->of.depth + (part->top << s->of.shift));
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
                    glint_output_put(&to, s, depth,
                                     gated && (int32_t)level <= 0 ? glint_ambient_of(fast, stores)
                                                                  : glint_colour_at(stored, level >> 22, stores),
                                     stores);
                }
                glint_step(&depth);
                z += z_dx;
                level += level_dx;
            } while (depth != end);
            column = right;
            glint_output_end_row(&to, s, stores);
        }
        depth += stride;
        z += (uint32_t)part->depth.dy;
        level += (uint32_t)cosine->dy;
    } while (span != last);
    glint_output_end(&to, s, stores);
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
static GLINT_INLINE void glint_draw_highlight(const glint_fast_spans *s, const glint_fast_terms *fast,
                                              const glint_fast_planes *planes, glint_fast_store stores) {
    const glint_part *part = s->of.part;
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    const ptrdiff_t stride = 2 << s->of.shift;
    glint_fast_output to = glint_output_begin(s, stores);
    const uint32_t *const diffuse = fast->diffuse;
    const void *const stored = fast->diffuse_stored;
    const unsigned early = GLINT_SPLIT_PRODUCTS ? 0 : 15; /* a shift tests the sign too; not so ARMv6-M's compiler */
    uint32_t less_end = 0u - fast->specular_end;
    GLINT_OPAQUE(less_end);
    const uint32_t z_dx = (uint32_t)part->depth.dx, level_dx = (uint32_t)planes->cosine.dx;
    const uint32_t x_dx = (uint32_t)planes->x.dx, y_dx = (uint32_t)planes->y.dx;
    uint32_t z = glint_first_row(part, &part->depth) + GLINT_DEPTH_BIAS;
    uint32_t level = glint_first_row(part, &planes->cosine);
    uint32_t x = glint_first_row(part, &planes->x), y = glint_first_row(part, &planes->y);
    uint32_t column = 0;
    uint8_t *depth = (uint8_t *)(s->of.depth + (part->top << s->of.shift));
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
                        glint_output_put(
                            &to, s, depth,
                            glint_colour_of(*word + diffuse[glint_shift_right(beyond, 15 - early)], 1, stores), stores);
                    else
                        glint_output_put(&to, s, depth, glint_colour_at(stored, level >> 22, stores), stores);
                }
                glint_step(&depth);
                z += z_step;
                level += level_step;
                x += x_step;
                y += y_step;
            } while (depth != end);
            column = right;
            glint_output_end_row(&to, s, stores);
        }
        depth += stride;
        z += (uint32_t)part->depth.dy;
        level += (uint32_t)planes->cosine.dy;
        x += (uint32_t)planes->x.dy;
        y += (uint32_t)planes->y.dy;
    } while (span != last);
    glint_output_end(&to, s, stores);
}

/* The same, its squared deviation stepped. */
static inline void glint_draw_stepped(const glint_fast_spans *s, const glint_fast_terms *fast,
                                      const glint_fast_planes *planes, glint_fast_store stores) {
    const glint_part *part = s->of.part;
    const glint_quadratic square = glint_square_begin(&planes->x, &planes->y);
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    const ptrdiff_t stride = 2 << s->of.shift;
    glint_fast_output to = glint_output_begin(s, stores);
    const uint32_t *const diffuse = fast->diffuse;
    const void *const stored = fast->diffuse_stored;
    const uint32_t z_dx = (uint32_t)part->depth.dx, level_dx = (uint32_t)planes->cosine.dx, x = (uint32_t)part->x;
    uint32_t z = glint_first_row(part, &part->depth) + GLINT_DEPTH_BIAS;
    uint32_t level = glint_first_row(part, &planes->cosine), y = (uint32_t)part->y + part->top, column = 0;
    glint_stride beyond = glint_stride_begin(&square, part->x, (int32_t)y);
    beyond.value -= fast->specular_end << GLINT_SQUARE_BITS;
    uint8_t *depth = (uint8_t *)(s->of.depth + (part->top << s->of.shift));
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
                        glint_output_put(&to, s, depth, glint_colour_of(*word + diffuse[entry], 1, stores), stores);
                    else
                        glint_output_put(&to, s, depth, glint_colour_at(stored, level >> 22, stores), stores);
                }
                glint_step(&depth);
                z += z_step;
                level += level_step;
                glint_stride_next(&beyond, &square);
            } while (depth != end);
            column = right;
            glint_output_end_row(&to, s, stores);
        }
        depth += stride;
        z += (uint32_t)part->depth.dy;
        level += (uint32_t)planes->cosine.dy;
        glint_stride_down(&beyond, &square, x + column, y);
        y++;
    } while (span != last);
    glint_output_end(&to, s, stores);
}

/* A large triangle with a highlight. Out of line, where it has all registers for itself. */
static GLINT_NOINLINE void glint_draw_large(const glint_frame *frame, const glint_workspace *workspace,
                                            const glint_draw *draw, const glint_part *part,
                                            const glint_fast_planes *planes, glint_fast_store stores) {
    const glint_fast_spans spans = glint_fast_spans_of(frame, workspace, part, stores);
    if (glint_square_fits(&part->gradients, planes))
        glint_draw_stepped(&spans, draw->shading->fast, planes, stores);
    else
        glint_draw_highlight(&spans, draw->shading->fast, planes, stores);
}

/* Stores one pixel of a tile. */
static GLINT_INLINE void glint_put_at(const glint_fast_spans *s, uint32_t offset, uint32_t word,
                                      glint_fast_store stores) {
    const glint_spread one = {offset, word};
    if (stores == GLINT_STORES_SPREAD)
        glint_store_words(s, &one, &one + 1);
    else
        glint_put_565(s->of.pixels + 2 * offset, glint_colour_of(word, 1, stores), stores);
}

/* All of these, with words that are computed. */
static GLINT_NOINLINE void glint_draw_without_tables(const glint_frame *frame, const glint_workspace *workspace,
                                                     const glint_draw *draw, const glint_triangle *triangle,
                                                     const glint_part *part, const glint_fast_planes *planes,
                                                     glint_fast_kind kind, glint_fast_store stores) {
    const glint_shading *shading = draw->shading;
    const glint_fast_spans s = glint_fast_spans_of(frame, workspace, part, stores);
    const int is_stepped = kind == GLINT_FAST_SPECULAR && triangle->area >= GLINT_LARGE_AREA &&
                           glint_square_fits(&part->gradients, planes);
    glint_quadratic sum = {0, 0, 0, 0, 0, 0};
    if (is_stepped)
        sum = glint_square_begin(&planes->x, &planes->y);
    for (uint32_t row = part->top; row < part->bottom; row++) {
        const glint_span span = part->spans[row];
        for (uint32_t column = span.left; column < span.right; column++) {
            const int32_t x = part->x + (int32_t)column, y = part->y + (int32_t)row;
            const uint32_t offset = (row << s.of.shift) + column;
            if (!glint_is_nearest((uint8_t *)(s.of.depth + offset),
                                  (uint32_t)glint_plane_at(&part->depth, x, y) + GLINT_DEPTH_BIAS))
                continue;
            const int32_t level = glint_plane_at(&planes->cosine, x, y);
            uint32_t square = UINT32_MAX;
            if (is_stepped)
                square = glint_stride_begin(&sum, x, y).value >> GLINT_SQUARE_BITS;
            else if (kind == GLINT_FAST_SPECULAR)
                square = glint_high_square((uint32_t)glint_plane_at(&planes->x, x, y)) +
                         glint_high_square((uint32_t)glint_plane_at(&planes->y, x, y));
            glint_put_at(&s, offset, glint_fast_word(shading, level, square), stores);
        }
    }
}

#endif
