/* SPDX-License-Identifier: MIT */
/** @file pixel.h What the pixel formats share. */
#ifndef GLINT_PIXEL_H
#define GLINT_PIXEL_H

#include "frame.h"

/** 1 in a fragment's colour, Q23. */
#define GLINT_FULL (1u << 23)

/** What is added before a level is cut off: half a level rounds to nearest. */
#define GLINT_HALF_LEVEL (GLINT_FULL / 2)

/** The same for ordered dithering over 8 x 8 pixels: 1/128, 3/128 .. 127/128, row by row (Bayer, 1973). */
extern const uint8_t glint_dither_matrix[64];

static inline uint32_t glint_clamp(uint32_t channel) {
    return channel < GLINT_FULL ? channel : GLINT_FULL;
}

/** A channel, Q23, clamped at 1, as one of 0 to `top` levels; top up to 255. */
static inline uint32_t glint_level(uint32_t channel, uint32_t top, uint32_t threshold) {
    return (glint_clamp(channel) * top + threshold) >> 23;
}

/** 0.299 R + 0.587 G + 0.114 B (ITU-R BT.601) of the clamped colour, Q23; off by at most 3.3e-5. */
static inline uint32_t glint_luma(const uint32_t colour[3]) {
    return ((glint_clamp(colour[0]) >> 8) * 9798 + (glint_clamp(colour[1]) >> 8) * 19235 +
            (glint_clamp(colour[2]) >> 8) * 3735) >>
           7;
}

/** Stores one pixel at `offset` of a tile. */
typedef void (*glint_put)(void *pixels, uint32_t offset, const uint32_t colour[3], uint32_t threshold);

/** Threshold of a pixel; tiles start at multiples of 8. */
static inline uint32_t glint_dither_threshold(uint32_t x, uint32_t y) {
    return (uint32_t)glint_dither_matrix[(y & 7) * 8 + (x & 7)] << 16;
}

/** The loop of every format's `store`; put and dithered are constants where this is inlined. */
static inline void glint_store_fragments(void *pixels, const glint_fragments *fragments, unsigned tile_shift_x,
                                         glint_put put, int dithered) {
    for (uint32_t i = 0; i < fragments->count; i++) {
        uint32_t offset = fragments->offset[i];
        uint32_t threshold = dithered ? glint_dither_threshold(offset, offset >> tile_shift_x) : GLINT_HALF_LEVEL;
        put(pixels, offset, fragments->colour[i], threshold);
    }
}

/** Copies the first `period` bytes all over the first `size`, which is a power of two times as many. */
void glint_repeat(void *bytes, size_t period, size_t size);

/** Every format's `fill`: 8 pixels, repeated along their row, and this row, or 8 where they are dithered, down the
 * tile. */
static inline void glint_fill_tile(void *pixels, uint32_t width, uint32_t height, const uint32_t colour[3],
                                   glint_put put, uint32_t bits, int dithered) {
    const uint32_t rows = dithered ? 8 : 1, row_bytes = width / 8 * bits;
    for (uint32_t y = 0; y < rows; y++) {
        for (uint32_t x = 0; x < 8; x++)
            put(pixels, y * width + x, colour, dithered ? glint_dither_threshold(x, y) : GLINT_HALF_LEVEL);
        glint_repeat((uint8_t *)pixels + y * row_bytes, bits, row_bytes);
    }
    glint_repeat(pixels, rows * row_bytes, height * row_bytes);
}

/** Defines a format with fast lighting, and its dithered twin, which the linker keeps only where they are named. */
#define GLINT_DEFINE_FAST_FORMAT(name, bits, put, fast)                                                  \
    static void store(void *pixels, const glint_fragments *fragments, unsigned tile_shift_x) {           \
        glint_store_fragments(pixels, fragments, tile_shift_x, put, 0);                                  \
    }                                                                                                    \
    static void fill(void *pixels, uint32_t width, uint32_t height, const uint32_t colour[3]) {          \
        glint_fill_tile(pixels, width, height, colour, put, bits, 0);                                    \
    }                                                                                                    \
    static void store_dithered(void *pixels, const glint_fragments *fragments, unsigned tile_shift_x) {  \
        glint_store_fragments(pixels, fragments, tile_shift_x, put, 1);                                  \
    }                                                                                                    \
    static void fill_dithered(void *pixels, uint32_t width, uint32_t height, const uint32_t colour[3]) { \
        glint_fill_tile(pixels, width, height, colour, put, bits, 1);                                    \
    }                                                                                                    \
    const glint_format name = {bits, store, fill, fast};                                                 \
    const glint_format name##_dithered = {bits, store_dithered, fill_dithered, 0}

/** The same without fast lighting. */
#define GLINT_DEFINE_FORMAT(name, bits, put) GLINT_DEFINE_FAST_FORMAT(name, bits, put, 0)

#endif
