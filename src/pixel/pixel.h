/* SPDX-License-Identifier: MIT */
/**
 * @file pixel.h
 * What the pixel formats share. A format says how it packs three channels into a number and where it puts that; its
 * loops over pixels are made of the two.
 */
#ifndef GLINT_PIXEL_H
#define GLINT_PIXEL_H

#include "../raster/polynomial.h"
#include "../raster/runs.h"
#include "format.h"
#include "spread.h"

/** Thresholds of ordered dithering over 8 x 8 pixels in 1/128 level: 1, 3 .. 127, row by row (Bayer, 1973). */
extern const uint8_t glint_dither_matrix[64];

/** The threshold that rounds to nearest. */
#define GLINT_NEAREST 64

/** A tile's pixels. */
typedef struct glint_target {
    void *pixels;
    unsigned shift; /* binary logarithm of the tile's width */
    int dithered;
} glint_target;

/** What a format packs channels into; the threshold is in 1/128 level. */
typedef uint32_t glint_pack(const int32_t colour[3], uint32_t threshold);

/** What a format packs a word of spread.h into, which the threshold is added to. */
typedef uint32_t glint_pack_spread(uint32_t word, uint32_t threshold);

/** Puts a packed pixel at `offset` of the tile. */
typedef void glint_put(const glint_target *target, uint32_t offset, uint32_t packed);

/** Can the core shift and clamp a number in one instruction? Both ways give the same bits. */
#if defined(__ARM_FEATURE_SAT) && defined(__OPTIMIZE__)
#define GLINT_SATURATES 1
#else
#define GLINT_SATURATES 0
#endif

/** floor(x / 2^shift), clamped to 0 and 2^bits - 1; both are constants. */
static GLINT_INLINE uint32_t glint_saturate(int32_t x, unsigned bits, unsigned shift) {
#if GLINT_SATURATES
    uint32_t level;
    __asm__("usat %0, %1, %2, asr %3" : "=r"(level) : "I"(bits), "r"(x), "I"(shift));
    return level;
#else
    const uint32_t most = (1u << bits) - 1;
    uint32_t level = (uint32_t)glint_shift_right(x, shift);
    if (level > most) /* one comparison for both ends: most channels are between */
        level = most & ~(uint32_t)glint_shift_right(x, 31);
    GLINT_OPAQUE(level); /* what follows is not to be there twice */
    return level;
#endif
}

/** The level of a channel in levels of so many bits, half a level included. */
static GLINT_INLINE uint32_t glint_level(int32_t channel, unsigned bits, uint32_t threshold) {
    const int32_t rest = ((int32_t)threshold - GLINT_NEAREST) * (1 << (GLINT_CHANNEL_BITS - 7 - bits));
    return glint_saturate(channel + rest, bits, GLINT_CHANNEL_BITS - bits);
}

/** A channel clamped to 0 and 1, Q15; 1 is 2^15 - 1. */
static GLINT_INLINE uint32_t glint_clamped(int32_t channel) {
    return glint_saturate(channel, 15, GLINT_CHANNEL_BITS - 15);
}

/** 0.299 R + 0.587 G + 0.114 B (ITU-R BT.601) of clamped channels that are not scaled, as one of 0 to `top` levels. */
static inline uint32_t glint_luma_level(const int32_t colour[3], uint32_t top, uint32_t threshold) {
    const uint32_t luma =
        (glint_clamped(colour[0]) * 9798 + glint_clamped(colour[1]) * 19235 + glint_clamped(colour[2]) * 3735) >> 12;
    return (luma * top + (threshold << 11)) >> 18; /* luma is Q18: off by at most 3.3e-5 */
}

/** Threshold of a pixel; tiles start at multiples of 8. */
static inline uint32_t glint_threshold(const glint_target *t, uint32_t offset) {
    return t->dithered ? glint_dither_matrix[(offset >> t->shift & 7) * 8 + (offset & 7)] : GLINT_NEAREST;
}

/** A format's `store`. */
static GLINT_INLINE void glint_store_runs(const glint_target *t, const glint_run *run, const glint_run *last,
                                          const int32_t (*colour)[3], glint_pack pack, glint_put put) {
    for (; run != last; run++) {
        uint32_t offset = ((uint32_t)run->y << t->shift) + run->x;
        for (const uint32_t end = offset + run->count; offset < end; offset++, colour++)
            put(t, offset, pack(*colour, glint_threshold(t, offset)));
    }
}

/** A format's `store_spread`. */
static GLINT_INLINE void glint_store_spread(const glint_target *t, const glint_spread *words, const glint_spread *end,
                                            glint_pack_spread pack, glint_put put) {
    for (ptrdiff_t left = end - words; left; left--, words++)
        put(t, words->offset, pack(words->colour, glint_threshold(t, words->offset)));
}

/** Copies the first `period` bytes all over the first `size`, which is a power of two times as many. */
void glint_repeat(void *bytes, size_t period, size_t size);

/** Does it matter which threshold is added to a colour? Levels grow with it. */
static GLINT_INLINE int glint_is_dithered(const glint_target *t, const int32_t colour[3], glint_pack pack) {
    return t->dithered && pack(colour, 1) != pack(colour, 127);
}

/** A format's `fill`: 8 pixels, repeated along their row, and this row, or 8 where they are dithered, down the tile. */
static GLINT_INLINE void glint_fill_tile(const glint_target *t, uint32_t height, const int32_t colour[3], uint32_t bits,
                                         glint_pack pack, glint_put put) {
    const uint32_t rows = glint_is_dithered(t, colour, pack) ? 8 : 1, row_bytes = bits << t->shift >> 3;
    for (uint32_t y = 0; y < rows; y++) {
        for (uint32_t x = 0; x < 8; x++)
            put(t, (y << t->shift) + x, pack(colour, glint_threshold(t, (y << t->shift) + x)));
        glint_repeat((uint8_t *)t->pixels + y * row_bytes, bits, row_bytes);
    }
    glint_repeat(t->pixels, rows * row_bytes, height * row_bytes);
}

/** A format's `draw_even`: the pixels of a part, all of one colour. */
static GLINT_INLINE void glint_draw_even_spans(const glint_spans *s, const glint_target *t, const int32_t colour[3],
                                               glint_pack pack, glint_put put) {
    const glint_part *part = s->part;
    const uint16_t *const ahead = glint_ahead_of(s);
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    const uint32_t z_dx = (uint32_t)part->depth.dx, packed = t->dithered ? 0 : pack(colour, GLINT_NEAREST);
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
                    const uint32_t offset = glint_offset_of(s, ahead, depth);
                    put(t, offset, t->dithered ? pack(colour, glint_threshold(t, offset)) : packed);
                }
                glint_step(&depth);
                z += z_dx;
            } while (depth != end);
            column = right;
        }
        depth += 2 << s->shift;
        z += (uint32_t)part->depth.dy;
    } while (span != last);
}

/* A channel on its way along a row. */
typedef struct glint_channel_walk {
    uint32_t value, step;
} glint_channel_walk;

static inline void glint_walk_begin(glint_channel_walk *w, const glint_quadratic *q, int32_t x, int32_t y,
                                    int is_curved) {
    if (is_curved) {
        const glint_stride s = glint_stride_begin(q, x, y);
        w->value = s.value;
        w->step = s.across;
    } else {
        w->value = q->start + q->dx * (uint32_t)x + q->dy * (uint32_t)y;
        w->step = q->dx;
    }
}

static inline void glint_walk_next(glint_channel_walk *w, uint32_t turn, int is_curved) {
    w->value += w->step;
    if (is_curved)
        w->step += turn;
}

/** A format's `draw_channels`: the pixels of a part, of three polynomials. */
static GLINT_INLINE void glint_draw_channel_spans(const glint_spans *s, const glint_target *t,
                                                  const glint_quadratic channel[3], int is_curved, glint_pack pack,
                                                  glint_put put) {
    const glint_part *part = s->part;
    const uint16_t *const ahead = glint_ahead_of(s);
    const uint32_t z_dx = (uint32_t)part->depth.dx;
    const uint32_t red_turn = 2 * channel[0].dxx, green_turn = 2 * channel[1].dxx, blue_turn = 2 * channel[2].dxx;
    for (uint32_t row = part->top; row < part->bottom; row++) {
        const glint_span span = part->spans[row];
        const int32_t x = part->x + span.left, y = part->y + (int32_t)row;
        if (span.left >= span.right)
            continue;
        uint32_t z = (uint32_t)glint_plane_at(&part->depth, x, y) + GLINT_DEPTH_BIAS;
        glint_channel_walk red, green, blue;
        glint_walk_begin(&red, &channel[0], x, y, is_curved);
        glint_walk_begin(&green, &channel[1], x, y, is_curved);
        glint_walk_begin(&blue, &channel[2], x, y, is_curved);
        uint8_t *depth = (uint8_t *)(s->depth + (row << s->shift) + span.left);
        uint8_t *const end = depth + 2 * ((uint32_t)span.right - span.left);
        do {
            if (glint_next_is_nearest(&depth, z)) {
                const uint32_t offset = glint_offset_of(s, ahead, depth);
                const int32_t colour[3] = {(int32_t)red.value, (int32_t)green.value, (int32_t)blue.value};
                put(t, offset, pack(colour, glint_threshold(t, offset)));
            }
            glint_step(&depth);
            z += z_dx;
            glint_walk_next(&red, red_turn, is_curved);
            glint_walk_next(&green, green_turn, is_curved);
            glint_walk_next(&blue, blue_turn, is_curved);
        } while (depth != end);
    }
}

/* A part's pixels, mixed of a polynomial. */
static GLINT_INLINE void glint_draw_mixed_inline(const glint_spans *s, const glint_target *t,
                                                 const glint_quadratic *light, const glint_mix *of, int has_least,
                                                 glint_pack pack, glint_put put) {
    const glint_part *part = s->part;
    const uint16_t *const ahead = glint_ahead_of(s);
    const glint_mix mix = *of;
    const uint32_t z_dx = (uint32_t)part->depth.dx, turn = 2 * light->dxx;
    for (uint32_t row = part->top; row < part->bottom; row++) {
        const glint_span span = part->spans[row];
        const int32_t x = part->x + span.left, y = part->y + (int32_t)row;
        if (span.left >= span.right)
            continue;
        uint32_t z = (uint32_t)glint_plane_at(&part->depth, x, y) + GLINT_DEPTH_BIAS;
        glint_stride amount = glint_stride_begin(light, x, y);
        uint8_t *depth = (uint8_t *)(s->depth + (row << s->shift) + span.left);
        uint8_t *const end = depth + 2 * ((uint32_t)span.right - span.left);
        do {
            if (glint_next_is_nearest(&depth, z)) {
                const uint32_t offset = glint_offset_of(s, ahead, depth);
                const int32_t number[3] = {glint_shift_right((int32_t)amount.value, 16), 0, 0};
                const int32_t colour[3] = {glint_mix_channel(&mix, 0, number, 0, has_least),
                                           glint_mix_channel(&mix, 1, number, 0, has_least),
                                           glint_mix_channel(&mix, 2, number, 0, has_least)};
                put(t, offset, pack(colour, glint_threshold(t, offset)));
            }
            glint_step(&depth);
            z += z_dx;
            amount.value += amount.across;
            amount.across += turn;
        } while (depth != end);
    }
}

/** A format's `draw_mixed`. */
static GLINT_INLINE void glint_draw_mixed(const glint_spans *s, const glint_target *t, const glint_quadratic *light,
                                          const glint_mix *mix, glint_pack pack, glint_put put) {
    if (mix->has_least)
        glint_draw_mixed_inline(s, t, light, mix, 1, pack, put);
    else
        glint_draw_mixed_inline(s, t, light, mix, 0, pack, put);
}

/* Runs whose colours are mixed. */
static GLINT_INLINE void glint_store_mixed_inline(const glint_target *t, const glint_run *run, const glint_run *end,
                                                  const glint_mix *of, const int32_t (*numbers)[3], int has_gloss,
                                                  int has_least, glint_pack pack, glint_put put) {
    const glint_mix mix = *of;
    for (; run != end; run++) {
        uint32_t offset = ((uint32_t)run->y << t->shift) + run->x;
        for (uint32_t n = run->count; n; n--, numbers++, offset++) {
            const int32_t colour[3] = {glint_mix_channel(&mix, 0, *numbers, has_gloss, has_least),
                                       glint_mix_channel(&mix, 1, *numbers, has_gloss, has_least),
                                       glint_mix_channel(&mix, 2, *numbers, has_gloss, has_least)};
            put(t, offset, pack(colour, glint_threshold(t, offset)));
        }
    }
}

/** A format's `store_mixed`. */
static GLINT_INLINE void glint_store_mixed(const glint_target *t, const glint_run *runs, const glint_run *end,
                                           const glint_mix *mix, int has_gloss, const int32_t (*numbers)[3],
                                           glint_pack pack, glint_put put) {
    if (has_gloss && mix->has_least)
        glint_store_mixed_inline(t, runs, end, mix, numbers, 1, 1, pack, put);
    else if (has_gloss)
        glint_store_mixed_inline(t, runs, end, mix, numbers, 1, 0, pack, put);
    else if (mix->has_least)
        glint_store_mixed_inline(t, runs, end, mix, numbers, 0, 1, pack, put);
    else
        glint_store_mixed_inline(t, runs, end, mix, numbers, 0, 0, pack, put);
}

/** The functions of a format, whose names end in `suffix`; `fill_tile` is glint_fill_tile, or its own. */
#define GLINT_DEFINE_STORES(suffix, bits, pack, put, fill_tile, is_dithered)                              \
    static void store_##suffix(void *pixels, unsigned shift, const glint_run *runs, const glint_run *end, \
                               const int32_t(*colour)[3]) {                                               \
        const glint_target target = {pixels, shift, is_dithered};                                         \
        glint_store_runs(&target, runs, end, colour, pack, put);                                          \
    }                                                                                                     \
    static void fill_##suffix(void *pixels, unsigned shift, uint32_t height, const int32_t colour[3]) {   \
        const glint_target target = {pixels, shift, is_dithered};                                         \
        fill_tile(&target, height, colour, bits, pack, put);                                              \
    }

/** Those which a library built for size does without. */
#if GLINT_SMALL
#define GLINT_FUSED(loop) 0
#define GLINT_DEFINE_FUSED(suffix, pack, put, is_dithered)
#else
#define GLINT_FUSED(loop) loop
#define GLINT_DEFINE_FUSED(suffix, pack, put, is_dithered)                                                      \
    static void draw_even_##suffix(const glint_spans *s, const int32_t colour[3]) {                             \
        const glint_target target = {s->pixels, s->shift, is_dithered};                                         \
        glint_draw_even_spans(s, &target, colour, pack, put);                                                   \
    }                                                                                                           \
    static void draw_channels_##suffix(const glint_spans *s, const glint_quadratic channel[3], int is_curved) { \
        const glint_target target = {s->pixels, s->shift, is_dithered};                                         \
        if (is_curved)                                                                                          \
            glint_draw_channel_spans(s, &target, channel, 1, pack, put);                                        \
        else                                                                                                    \
            glint_draw_channel_spans(s, &target, channel, 0, pack, put);                                        \
    }                                                                                                           \
    static void draw_mixed_##suffix(const glint_spans *s, const glint_quadratic *light, const glint_mix *mix) { \
        const glint_target target = {s->pixels, s->shift, is_dithered};                                         \
        glint_draw_mixed(s, &target, light, mix, pack, put);                                                    \
    }                                                                                                           \
    static void store_mixed_##suffix(void *pixels, unsigned shift, const glint_run *runs, const glint_run *end, \
                                     const glint_mix *mix, int has_gloss, const int32_t(*numbers)[3]) {         \
        const glint_target target = {pixels, shift, is_dithered};                                               \
        glint_store_mixed(&target, runs, end, mix, has_gloss, numbers, pack, put);                              \
    }
#endif

/** `store_spread` of formats which fast lighting stores words of. */
#define GLINT_DEFINE_SPREAD(suffix, pack, put, is_dithered)                                    \
    static void store_spread_##suffix(void *pixels, unsigned shift, const glint_spread *words, \
                                      const glint_spread *end) {                               \
        const glint_target target = {pixels, shift, is_dithered};                              \
        glint_store_spread(&target, words, end, pack, put);                                    \
    }

/** GLINT_FORMAT's `edge`: of formats whose pixels of a row share bytes, and of those where pixels of a column do. */
#define GLINT_ROW_EDGE(bits) \
    { (bits) == 1 ? 7 : (bits) % 8 ? 1 : 0, 0 }
#define GLINT_PAGE_EDGE(bits) \
    { 0, 7 }

/** Fast lighting of a format: none, or that of words. */
#define GLINT_FAST_NONE(suffix) 0, 0
#define GLINT_FAST_SPREAD(suffix) store_spread_##suffix, &glint_fast_spread

/** A format of so many bits a pixel, and of its channels, or 0 for luma. */
#define GLINT_FORMAT(suffix, bits, edge, red, green, blue, fast)                                                      \
    {                                                                                                                 \
        bits, {red, green, blue}, edge(bits), store_##suffix, fill_##suffix, GLINT_FUSED(draw_even_##suffix),         \
            GLINT_FUSED(draw_channels_##suffix), GLINT_FUSED(draw_mixed_##suffix), GLINT_FUSED(store_mixed_##suffix), \
            fast(suffix)                                                                                              \
    }

/** Defines a format and its dithered twin, which the linker keeps only where they are named. */
#define GLINT_DEFINE_FORMAT(name, bits, edge, red, green, blue, pack, put, fill_tile, fast, fast_dithered) \
    GLINT_DEFINE_STORES(name, bits, pack, put, fill_tile, 0)                                               \
    GLINT_DEFINE_STORES(name##_dithered, bits, pack, put, fill_tile, 1)                                    \
    GLINT_DEFINE_FUSED(name, pack, put, 0)                                                                 \
    GLINT_DEFINE_FUSED(name##_dithered, pack, put, 1)                                                      \
    const glint_format glint_format_##name = GLINT_FORMAT(name, bits, edge, red, green, blue, fast);       \
    const glint_format glint_format_##name##_dithered =                                                    \
        GLINT_FORMAT(name##_dithered, bits, edge, red, green, blue, fast_dithered)

#endif
