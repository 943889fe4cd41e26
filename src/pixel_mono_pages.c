/* SPDX-License-Identifier: MIT */
/* Pixels of 1 bit: luma, in pages of 8 rows, a byte for each column of a page, its top row lowest. */
#include "pixel.h"

static inline uint32_t is_lit(const uint32_t colour[3], uint32_t x, uint32_t y, int dithered) {
    return glint_level(glint_luma(colour), 1, dithered ? glint_dither_threshold(x, y) : GLINT_HALF_LEVEL);
}

static inline void store_pages(void *pixels, const glint_fragments *fragments, unsigned tile_shift_x, int dithered) {
    for (uint32_t i = 0; i < fragments->count; i++) {
        uint32_t x = fragments->offset[i] & ((1u << tile_shift_x) - 1), y = fragments->offset[i] >> tile_shift_x;
        uint8_t *eight = (uint8_t *)pixels + ((y >> 3 << tile_shift_x) + x);
        uint32_t bit = y & 7;
        *eight = (uint8_t)((*eight & ~(1u << bit)) | is_lit(fragments->colour[i], x, y, dithered) << bit);
    }
}

/* 8 columns of a page, copied to all others. */
static inline void fill_pages(void *pixels, uint32_t width, uint32_t height, const uint32_t colour[3], int dithered) {
    uint8_t *bytes = pixels;
    for (uint32_t x = 0; x < 8; x++) {
        uint32_t eight = 0;
        for (uint32_t y = 0; y < 8; y++)
            eight |= is_lit(colour, x, y, dithered) << y;
        bytes[x] = (uint8_t)eight;
    }
    glint_repeat(bytes, 8, width * height / 8);
}

static void store(void *pixels, const glint_fragments *fragments, unsigned tile_shift_x) {
    store_pages(pixels, fragments, tile_shift_x, 0);
}

static void fill(void *pixels, uint32_t width, uint32_t height, const uint32_t colour[3]) {
    fill_pages(pixels, width, height, colour, 0);
}

static void store_dithered(void *pixels, const glint_fragments *fragments, unsigned tile_shift_x) {
    store_pages(pixels, fragments, tile_shift_x, 1);
}

static void fill_dithered(void *pixels, uint32_t width, uint32_t height, const uint32_t colour[3]) {
    fill_pages(pixels, width, height, colour, 1);
}

const glint_format glint_format_mono_pages = {1, store, fill, 0};
const glint_format glint_format_mono_pages_dithered = {1, store_dithered, fill_dithered, 0};
