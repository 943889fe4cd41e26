/* SPDX-License-Identifier: MIT */
/**
 * @file pixel.h
 * What the pixel formats share. A format says how it packs three channels into a number and where it puts that; its
 * loops over pixels are made of the two.
 */
#ifndef GLINT_PIXEL_H
#define GLINT_PIXEL_H

#include "spans.h"

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

/** Puts a packed pixel at `offset` of the tile. */
typedef void glint_put(const glint_target *target, uint32_t offset, uint32_t packed);

/** The level of a scaled channel, half a level included, of so many bits; clamped. */
static inline uint32_t glint_level(int32_t channel, unsigned bits, uint32_t threshold) {
    const int32_t most = (1 << bits) - 1;
    const int32_t rest =
        (int32_t)threshold * (1 << (GLINT_CHANNEL_BITS - 7 - bits)) - (1 << (GLINT_CHANNEL_BITS - 1 - bits));
    const int32_t level = glint_shift_right(channel + rest, GLINT_CHANNEL_BITS - bits);
    return (uint32_t)glint_least(glint_most(level, 0), most);
}

/** A channel clamped to 0 and 1, Q15. */
static inline uint32_t glint_clamped(int32_t channel) {
    return (uint32_t)glint_shift_right(glint_least(glint_most(channel, 0), GLINT_CHANNEL_ONE), GLINT_CHANNEL_BITS - 15);
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
static GLINT_INLINE void glint_store_run(const glint_target *t, uint32_t offset, uint32_t count,
                                         const int32_t (*colour)[3], glint_pack pack, glint_put put) {
    for (const uint32_t end = offset + count; offset < end; offset++, colour++)
        put(t, offset, pack(*colour, glint_threshold(t, offset)));
}

/** Copies the first `period` bytes all over the first `size`, which is a power of two times as many. */
void glint_repeat(void *bytes, size_t period, size_t size);

/** A format's `fill`: 8 pixels, repeated along their row, and this row, or 8 where they are dithered, down the tile. */
static GLINT_INLINE void glint_fill_tile(const glint_target *t, uint32_t height, const int32_t colour[3], uint32_t bits,
                                         glint_pack pack, glint_put put) {
    const uint32_t rows = t->dithered ? 8 : 1, row_bytes = bits << t->shift >> 3;
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
                    const uint32_t offset = (uint32_t)(depth - GLINT_AHEAD - (uint8_t *)s->depth) / 2;
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

/** A format's `draw_channels`: the pixels of a part, of three linear channels. */
static GLINT_INLINE void glint_draw_channel_spans(const glint_spans *s, const glint_target *t,
                                                  const glint_plane channel[3], glint_pack pack, glint_put put) {
    const glint_part *part = s->part;
    const glint_span *span = part->spans + part->top, *const last = part->spans + part->bottom;
    const uint32_t z_dx = (uint32_t)part->depth.dx;
    const uint32_t r_dx = (uint32_t)channel[0].dx, g_dx = (uint32_t)channel[1].dx, b_dx = (uint32_t)channel[2].dx;
    uint32_t z = glint_first_row(part, &part->depth) + GLINT_DEPTH_BIAS, column = 0;
    uint32_t r = glint_first_row(part, &channel[0]), g = glint_first_row(part, &channel[1]),
             b = glint_first_row(part, &channel[2]);
    uint8_t *depth = (uint8_t *)(s->depth + (part->top << s->shift));
    do {
        const uint32_t left = span->left, right = span->right;
        span++;
        GLINT_OPAQUE(span);
        if (left < right) {
            depth += 2 * (int32_t)(left - column);
            z += z_dx * (left - column);
            r += r_dx * (left - column);
            g += g_dx * (left - column);
            b += b_dx * (left - column);
            uint8_t *const end = depth + 2 * (right - left);
            do {
                if (glint_next_is_nearest(&depth, z)) {
                    const uint32_t offset = (uint32_t)(depth - GLINT_AHEAD - (uint8_t *)s->depth) / 2;
                    const int32_t colour[3] = {(int32_t)r, (int32_t)g, (int32_t)b};
                    put(t, offset, pack(colour, glint_threshold(t, offset)));
                }
                glint_step(&depth);
                z += z_dx;
                r += r_dx;
                g += g_dx;
                b += b_dx;
            } while (depth != end);
            column = right;
        }
        depth += 2 << s->shift;
        z += (uint32_t)part->depth.dy;
        r += (uint32_t)channel[0].dy;
        g += (uint32_t)channel[1].dy;
        b += (uint32_t)channel[2].dy;
    } while (span != last);
}

#if GLINT_SMALL
#define GLINT_FUSED(loop) 0
#else
#define GLINT_FUSED(loop) loop
#endif

/** The functions of a format, whose names end in `suffix`; `fill_tile` is glint_fill_tile, or its own. */
#define GLINT_DEFINE_LOOPS(suffix, bits, pack, put, fill_tile, is_dithered)                            \
    static void store##suffix(void *pixels, unsigned shift, uint32_t offset, uint32_t count,           \
                              const int32_t(*colour)[3]) {                                             \
        const glint_target target = {pixels, shift, is_dithered};                                      \
        glint_store_run(&target, offset, count, colour, pack, put);                                    \
    }                                                                                                  \
    static void fill##suffix(void *pixels, unsigned shift, uint32_t height, const int32_t colour[3]) { \
        const glint_target target = {pixels, shift, is_dithered};                                      \
        fill_tile(&target, height, colour, bits, pack, put);                                           \
    }                                                                                                  \
    static inline void draw_even##suffix(const glint_spans *s, const int32_t colour[3]) {              \
        const glint_target target = {s->pixels, s->shift, is_dithered};                                \
        glint_draw_even_spans(s, &target, colour, pack, put);                                          \
    }                                                                                                  \
    static inline void draw_channels##suffix(const glint_spans *s, const glint_plane channel[3]) {     \
        const glint_target target = {s->pixels, s->shift, is_dithered};                                \
        glint_draw_channel_spans(s, &target, channel, pack, put);                                      \
    }

/** A format of so many bits a pixel, and of its channels, or 0 for luma. */
#define GLINT_FORMAT(suffix, bits, red, green, blue, fast)                                     \
    {                                                                                          \
        bits, {red, green, blue}, store##suffix, fill##suffix, GLINT_FUSED(draw_even##suffix), \
            GLINT_FUSED(draw_channels##suffix), fast                                           \
    }

/** Defines a format and its dithered twin, which the linker keeps only where they are named. */
#define GLINT_DEFINE_FORMAT(name, bits, red, green, blue, pack, put, fill_tile, fast) \
    GLINT_DEFINE_LOOPS(, bits, pack, put, fill_tile, 0)                               \
    GLINT_DEFINE_LOOPS(_dithered, bits, pack, put, fill_tile, 1)                      \
    const glint_format name = GLINT_FORMAT(, bits, red, green, blue, fast);           \
    const glint_format name##_dithered = GLINT_FORMAT(_dithered, bits, red, green, blue, 0)

#endif
