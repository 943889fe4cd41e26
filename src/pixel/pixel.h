/* SPDX-License-Identifier: MIT */
/** @file pixel.h Has what the pixel formats share. A format defines how it packs three channels into a number and where
 * it puts the number. Its loops over pixels are made of the two. */
#ifndef GLINT_PIXEL_H
#define GLINT_PIXEL_H

#include "../raster/depth.h"
#include "../raster/small.h"
#include "format.h"

/** These are the thresholds of ordered dithering over 8 x 8 pixels in 1/128 level: 1, 3 .. 127, row by row (Bayer,
 * 1973). They are the bits of x ^ y and y, interleaved in reverse, times 2 plus 1. */
extern const uint8_t glint_dither_matrix[64];

/** This threshold rounds to nearest. */
#define GLINT_NEAREST 64

/** A target is the pixels of a tile. */
typedef struct glint_target {
    void *pixels;
    unsigned shift; /* binary logarithm of the tile's width */
    int dithered;
} glint_target;

/** Packs channels for a format. The threshold is in 1/128 level. */
typedef uint32_t glint_pack_colour(const int32_t colour[3], uint32_t threshold);

/** Adds a threshold to a spread word, and packs it for a format. */
typedef uint32_t glint_pack_spread(uint32_t word, uint32_t threshold);

/** Puts a packed pixel at `offset` of the tile. */
typedef void glint_put(const glint_target *target, uint32_t offset, uint32_t packed);

/** Can the core shift and clamp a number in one instruction? Both ways give the same bits. */
#if defined(__ARM_FEATURE_SAT) && defined(__OPTIMIZE__)
#define GLINT_SATURATES 1
#else
#define GLINT_SATURATES 0
#endif

/** Computes floor(x / 2^shift), clamped to 0 and 2^bits - 1. Both are constants. */
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
    GLINT_OPAQUE(level); /* otherwise the code that follows is there twice */
    return level;
#endif
}

/** Returns the level of a channel that is in levels of so many bits, half a level included. */
static GLINT_INLINE uint32_t glint_level(int32_t channel, unsigned bits, uint32_t threshold) {
    const int32_t rest = ((int32_t)threshold - GLINT_NEAREST) * (1 << (GLINT_CHANNEL_BITS - 7 - bits));
    return glint_saturate(channel + rest, bits, GLINT_CHANNEL_BITS - bits);
}

/** Packs channels as RGB565: red is in the highest bits. */
static inline uint32_t glint_pack_565(const int32_t colour[3], uint32_t threshold) {
    return glint_level(colour[0], 5, threshold) << 11 | glint_level(colour[1], 6, threshold) << 5 |
           glint_level(colour[2], 5, threshold);
}

/** Packs a spread word that is clamped and has half a level already: the threshold does not count. */
static inline uint32_t glint_pack_spread_565(uint32_t word, uint32_t threshold) {
    (void)threshold;
    return glint_spread_pack(word);
}

/** Clamps a channel to 0 and 1, Q15; 1 is 2^15 - 1. */
static GLINT_INLINE uint32_t glint_clamped(int32_t channel) {
    return glint_saturate(channel, 15, GLINT_CHANNEL_BITS - 15);
}

/** Computes 0.299 R + 0.587 G + 0.114 B (ITU-R BT.601) of clamped channels that are not scaled: Q18, off by at most
 * 3.3e-5. */
static inline uint32_t glint_luma(const int32_t colour[3]) {
    return (glint_clamped(colour[0]) * 9798 + glint_clamped(colour[1]) * 19235 + glint_clamped(colour[2]) * 3735) >> 12;
}

/** Returns luma as one of 0 to `top` levels. */
static GLINT_INLINE uint32_t glint_luma_level(const int32_t colour[3], uint32_t top, uint32_t threshold) {
    return (glint_luma(colour) * top + (threshold << 11)) >> 18;
}

/** Returns the luma of a spread word as a level of up to 4 bits. Channels count by their weight over the word's 1. */
static GLINT_INLINE uint32_t glint_spread_luma(uint32_t word, unsigned bits, uint32_t threshold) {
    const uint32_t clamped = glint_spread_clamp(word), top = (1u << bits) - 1,
                   red = (uint32_t)glint_least((int32_t)(clamped >> 10 & 0x3ff), 31 << 5),
                   green = (uint32_t)glint_least((int32_t)(clamped >> 21 & 0x3ff), 63 << 4),
                   blue = (uint32_t)glint_least((int32_t)(clamped & 0x1ff), 31 << 4);
    const uint32_t luma = red * (9798 * 512 * top / (31 << 5)) + green * (19235 * 512 * top / (63 << 4)) +
                          blue * (3735 * 512 * top / (31 << 4));
    return glint_saturate((int32_t)(luma + (threshold << 17)), bits, 24);
}

/** Returns the threshold of a pixel. Tiles start at multiples of 8. */
static inline uint32_t glint_threshold(const glint_target *t, uint32_t offset) {
    GLINT_REQUIRE(t->shift >= 3 && t->shift <= 6);
    return t->dithered ? glint_dither_matrix[(offset >> t->shift & 7) * 8 + (offset & 7)] : GLINT_NEAREST;
}

/** Does what `store_list` of a format does. */
static GLINT_INLINE void glint_store_list(const glint_target *t, const glint_list_pixel *pixel, size_t stride,
                                          uint32_t count, glint_pack_colour pack, glint_put put) {
    for (; count; count--) {
        put(t, pixel->pixel, pack(pixel->colour, glint_threshold(t, pixel->pixel)));
        pixel = (const glint_list_pixel *)(const void *)((const uint8_t *)pixel + stride);
    }
}

/** Does what `store_spread` of a format does. */
static GLINT_INLINE void glint_store_spread(const glint_target *t, const glint_spread *words, const glint_spread *end,
                                            glint_pack_spread pack, glint_put put) {
    for (ptrdiff_t left = end - words; left; left--, words++)
        put(t, words->offset, pack(words->colour, glint_threshold(t, words->offset)));
}

/* Compilers call this even in freestanding code; here the library does. */
void *memcpy(void *to, const void *from, size_t size);

/** Copies the first `period` bytes all over the first `size`, which is a power of two times as many. */
void glint_repeat(void *bytes, size_t period, size_t size);

/** Fills so many bytes, a multiple of 4, with words. */
void glint_fill_words(void *bytes, uint32_t word, size_t size);

/** Does it matter which threshold is added to a colour? Levels rise with the threshold. */
static GLINT_INLINE int glint_is_dithered(const glint_target *t, const int32_t colour[3], glint_pack_colour pack) {
    return t->dithered && pack(colour, 1) != pack(colour, 127);
}

/** Does what `fill` of a format does: fills 8 pixels and repeats them along their row, and repeats this row, or 8 where
 * they are dithered, down the tile. */
static GLINT_INLINE void glint_fill_tile(const glint_target *t, uint32_t height, const int32_t colour[3], uint32_t bits,
                                         glint_pack_colour pack, glint_put put) {
    const uint32_t rows = glint_is_dithered(t, colour, pack) ? 8 : 1, row_bytes = bits << t->shift >> 3;
    if (bits == 16 && rows == 1) {
        uint16_t pixel[2];
        uint32_t word;
        const glint_target two = {pixel, t->shift, t->dithered};
        put(&two, 0, pack(colour, glint_threshold(t, 0)));
        pixel[1] = pixel[0];
        memcpy(&word, pixel, sizeof word);
        glint_fill_words(t->pixels, word, height * row_bytes);
        return;
    }
    for (uint32_t y = 0; y < rows; y++) {
        for (uint32_t x = 0; x < 8; x++)
            put(t, (y << t->shift) + x, pack(colour, glint_threshold(t, (y << t->shift) + x)));
        glint_repeat((uint8_t *)t->pixels + y * row_bytes, bits, row_bytes);
    }
    glint_repeat(t->pixels, rows * row_bytes, height * row_bytes);
}

/* ---- Spans of one colour, and of interpolated colours ---- */

/** Adds a threshold, 1/128 level, to a colour's lanes, for a format of so many bits of red and blue, and of green. */
static GLINT_INLINE void glint_add_threshold(glint_lanes *lanes, uint32_t threshold, unsigned red_blue,
                                             unsigned green) {
    if (red_blue)
        lanes->red_blue += threshold * 0x10001u << (9 - red_blue);
    lanes->green += threshold << (25 - green);
}

/** Packs lanes that have half a level or a threshold: red, green, blue from the highest bit down, or luma. */
static GLINT_INLINE uint32_t glint_pack_lanes(glint_lanes lanes, unsigned red_blue, unsigned green) {
    const uint32_t level = lanes.green >> (32 - green);
    if (!red_blue)
        return level;
    return (lanes.red_blue >> (16 - red_blue) & ((1u << red_blue) - 1)) << (red_blue + green) | level << red_blue |
           lanes.red_blue >> (32 - red_blue);
}

/** A format keeps pixels in 16 bits of the core's byte order, or of the other one, or in any other way. */
enum { GLINT_KEEPS_ANY, GLINT_KEEPS_16, GLINT_KEEPS_SWAPPED };

/** Swaps the bytes of a pixel of 16 bits, where the core has the low one first. */
static GLINT_INLINE uint32_t glint_to_high_first(uint32_t packed) {
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    return packed;
#else
    return (packed >> 8 & 0xff) | (packed & 0xff) << 8;
#endif
}

/** The target of the loop over a row. Pixels of 16 bits lie as far from their depth as the first one does. */
typedef struct glint_row_target {
    glint_target target;
    const uint16_t *ahead;
    uintptr_t from_depth;
} glint_row_target;

static GLINT_INLINE glint_row_target glint_row_target_of(const glint_row_walk *w, int is_dithered) {
    const uint16_t *const ahead = glint_ahead(w->depth);
    return (glint_row_target){{w->pixels, w->shift, is_dithered}, ahead, w->from_depth};
}

/** Stores the pixel whose depth was tested last. */
static GLINT_INLINE void glint_put_tested(const glint_row_target *to, const uint8_t *place, uint32_t packed,
                                          glint_put put, int keeps) {
    if (keeps == GLINT_KEEPS_ANY)
        put(&to->target, glint_pixel_of(to->ahead, place), packed);
    else
        *(uint16_t *)((uintptr_t)place + to->from_depth) = (uint16_t)packed;
}

/** Draws a span of one colour. The lanes of a dithered format have no half level. */
static GLINT_INLINE void glint_draw_flat_span(const glint_row_walk *w, int32_t row, int32_t left, int32_t right,
                                              unsigned red_blue, unsigned green, glint_put put, int keeps,
                                              int is_dithered) {
    const glint_row_target to = glint_row_target_of(w, is_dithered);
    const uint32_t flat = keeps == GLINT_KEEPS_SWAPPED ? glint_to_high_first(w->packed) : w->packed;
    uint8_t *const first = (uint8_t *)w->depth + ((uint32_t)row << w->shift) * 2, *depth = first + 2 * left;
    const uint8_t *const end = first + 2 * right;
    const uint32_t dx = (uint32_t)w->z.dx;
    uint32_t z = glint_z_at(w, row, left);
    do {
        if (glint_next_is_nearest(&depth, z)) {
            uint32_t packed = flat;
            GLINT_BARRIER(); /* otherwise the code that hidden pixels do not need is skipped one by one */
            if (is_dithered) {
                glint_lanes lanes = w->lanes[0];
                const uint32_t offset = glint_pixel_of(to.ahead, depth);
                glint_add_threshold(&lanes, glint_threshold(&to.target, offset), red_blue, green);
                packed = glint_pack_lanes(lanes, red_blue, green);
                packed = keeps == GLINT_KEEPS_SWAPPED ? glint_to_high_first(packed) : packed;
            }
            glint_put_tested(&to, depth, packed, put, keeps);
        }
        glint_step(&depth);
        z += dx;
    } while (depth != end);
}

/** Draws a span of interpolated colours. */
static GLINT_INLINE void glint_draw_smooth_span(const glint_row_walk *w, int32_t row, int32_t left, int32_t right,
                                                unsigned red_blue, unsigned green, glint_put put, int keeps,
                                                int is_dithered) {
    const glint_row_target to = glint_row_target_of(w, is_dithered);
    uint8_t *const first = (uint8_t *)w->depth + ((uint32_t)row << w->shift) * 2, *depth = first + 2 * left;
    const uint8_t *const end = first + 2 * right;
    const uint32_t dx = (uint32_t)w->z.dx, red_blue_dx = w->lanes[1].red_blue, green_dx = w->lanes[1].green;
    uint32_t z = glint_z_at(w, row, left);
    glint_lanes at = glint_lanes_at(w, row, left);
    do {
        if (glint_next_is_nearest(&depth, z)) {
            glint_lanes lanes = at;
            if (is_dithered) {
                const uint32_t offset = glint_pixel_of(to.ahead, depth);
                glint_add_threshold(&lanes, glint_threshold(&to.target, offset), red_blue, green);
            }
            const uint32_t packed = glint_pack_lanes(lanes, red_blue, green);
            glint_put_tested(&to, depth, keeps == GLINT_KEEPS_SWAPPED ? glint_to_high_first(packed) : packed, put,
                             keeps);
        }
        glint_step(&depth);
        z += dx;
        at.red_blue += red_blue_dx;
        at.green += green_dx;
    } while (depth != end);
}

/** Defines the functions of a format, whose names end in `suffix`. `fill_tile` is glint_fill_tile, or the format's
 * own. */
#define GLINT_DEFINE_STORES(suffix, bits, pack, put, fill_tile, is_dithered)                               \
    static GLINT_HOT void store_list_##suffix(void *pixels, unsigned shift, const glint_list_pixel *pixel, \
                                              size_t stride, uint32_t count) {                             \
        const glint_target target = {pixels, shift, is_dithered};                                          \
        glint_store_list(&target, pixel, stride, count, pack, put);                                        \
    }                                                                                                      \
    static void fill_##suffix(void *pixels, unsigned shift, uint32_t height, const int32_t colour[3]) {    \
        const glint_target target = {pixels, shift, is_dithered};                                          \
        fill_tile(&target, height, colour, bits, pack, put);                                               \
    }

/** Draws the rows of a small triangle of interpolated colours. The colours begin once a pixel is visible. */
static GLINT_INLINE void glint_draw_visible_rows(glint_row_walk *walk, glint_begin_colours *begin,
                                                 glint_draw_span *smooth) {
    glint_row_state at = glint_begin_rows(walk);
    if (!glint_seek_visible(walk, &at))
        return;
    glint_keep_rows(walk, &at);
    if (begin(walk))
        glint_draw_rows(walk, glint_begin_rows(walk), smooth);
    else
        glint_walk_small(walk);
}

/** Cores with many registers draw spans where they are found; ARMv6-M calls a function, which is cheaper there. */
#if GLINT_SPLIT_PRODUCTS || GLINT_SMALL
#define GLINT_SPAN GLINT_NOINLINE
#else
#define GLINT_SPAN inline
#endif

/** Defines the functions that draw small triangles row by row. For size, they are drawn span by span, as others are. */
#if GLINT_SMALL
#define GLINT_DEFINE_ROWS(suffix)
#define GLINT_ROWS(suffix) glint_draw_flat, glint_draw_smooth_rows
#else
#define GLINT_DEFINE_ROWS(suffix)                                                           \
    static GLINT_HOT void flat_##suffix(glint_row_walk *walk) {                             \
        const glint_vertex *v[3];                                                           \
        const glint_begun begun = glint_begin_inline(walk, v);                              \
        GLINT_OPAQUE(walk);                                                                 \
        if (begun == GLINT_IS_SMALL && walk->has_slopes)                                    \
            glint_draw_rows(walk, glint_begin_rows(walk), flat_span_##suffix);              \
        else                                                                                \
            glint_walk_flat(walk, begun);                                                   \
    }                                                                                       \
    static GLINT_HOT void rows_##suffix(glint_row_walk *walk, glint_begin_colours *begin) { \
        glint_draw_visible_rows(walk, begin, smooth_##suffix);                              \
    }
#define GLINT_ROWS(suffix) flat_##suffix, rows_##suffix
#endif

/** Defines the functions that draw spans and single pixels of lanes, given the bits of red and blue, and of green. */
#define GLINT_DEFINE_SPANS(suffix, red_blue, green, put_pixel, keeps, is_dithered)                                     \
    static GLINT_HOT GLINT_SPAN void flat_span_##suffix(glint_row_walk *walk, int32_t row, int32_t left,               \
                                                        int32_t right) {                                               \
        glint_draw_flat_span(walk, row, left, right, red_blue, green, put_pixel, keeps, is_dithered);                  \
    }                                                                                                                  \
    static GLINT_HOT GLINT_SPAN void smooth_##suffix(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) { \
        glint_draw_smooth_span(walk, row, left, right, red_blue, green, put_pixel, keeps, is_dithered);                \
    }                                                                                                                  \
    GLINT_DEFINE_ROWS(suffix)                                                                                          \
    static void put_lanes_##suffix(const glint_row_walk *walk, uint32_t offset, glint_lanes lanes) {                   \
        const glint_target target = {walk->pixels, walk->shift, is_dithered};                                          \
        if (is_dithered)                                                                                               \
            glint_add_threshold(&lanes, glint_threshold(&target, offset), red_blue, green);                            \
        put_pixel(&target, offset, glint_pack_lanes(lanes, red_blue, green));                                          \
    }

/** Defines `store_spread` of a format that packs such words. */
#define GLINT_DEFINE_SPREAD(suffix, pack, put, is_dithered)                                              \
    static GLINT_HOT void store_spread_##suffix(void *pixels, unsigned shift, const glint_spread *words, \
                                                const glint_spread *end) {                               \
        const glint_target target = {pixels, shift, is_dithered};                                        \
        glint_store_spread(&target, words, end, pack, put);                                              \
    }

/** These are GLINT_FORMAT's `edge`: the first where pixels of a row share bytes, the second where pixels of a column
 * do. */
#define GLINT_ROW_EDGE(bits) \
    { (bits) == 1 ? 7 : (bits) % 8 ? 1 : 0, 0 }
#define GLINT_PAGE_EDGE(bits) \
    { 0, 7 }

/** A format stores no spread words, or any. */
#define GLINT_SPREAD_NONE(suffix) 0, 0
#define GLINT_SPREAD_ANY(suffix) store_spread_##suffix, 0

/** Describes a format of so many bits a pixel and a channel; channels have 0 bits for luma. */
#define GLINT_FORMAT(suffix, bits, edge, red, green, blue, keeps, spread, is_dithered)                                 \
    {                                                                                                                  \
        bits, {red, green, blue}, edge(bits), is_dithered, (keeps) == GLINT_KEEPS_SWAPPED, store_list_##suffix,        \
            fill_##suffix, GLINT_ROWS(suffix), flat_span_##suffix, smooth_##suffix, put_lanes_##suffix, spread(suffix) \
    }

/** Defines a format and its dithered twin, which the linker keeps only where they are named. */
#define GLINT_DEFINE_FORMAT(name, bits, edge, red, green, blue, pack, put, fill_tile, keeps, spread, spread_dithered) \
    GLINT_DEFINE_STORES(name, bits, pack, put, fill_tile, 0)                                                          \
    GLINT_DEFINE_STORES(name##_dithered, bits, pack, put, fill_tile, 1)                                               \
    GLINT_DEFINE_SPANS(name, red, (green) ? (green) : (bits), put, keeps, 0)                                          \
    GLINT_DEFINE_SPANS(name##_dithered, red, (green) ? (green) : (bits), put, keeps, 1)                               \
    const glint_format glint_format_##name = GLINT_FORMAT(name, bits, edge, red, green, blue, keeps, spread, 0);      \
    const glint_format glint_format_##name##_dithered =                                                               \
        GLINT_FORMAT(name##_dithered, bits, edge, red, green, blue, keeps, spread_dithered, 1)

#endif
