/* SPDX-License-Identifier: MIT */
/*
 * Stores: every format into a tile of 64 x 64 pixels and not a byte more.
 * @link pixel_rgb565.c @link pixel_rgb565_be.c @link pixel_rgb888.c @link pixel_grey8.c @link pixel_grey4.c
 * @link pixel_rgb444.c @link pixel_mono.c @link pixel_mono_pages.c @link dither.c
 */
#include "proof.h"

#include "../../src/pixel.h"

#define SIDE 64

static glint_fragments any_fragments(void) {
    glint_fragments fragments;
    fragments.count = ANY_UNSIGNED(0, GLINT_FRAGMENTS_MAX);
    for (int i = 0; i < GLINT_FRAGMENTS_MAX; i++) {
        fragments.offset[i] = (uint16_t)ANY_UNSIGNED(0, SIDE * SIDE - 1);
        for (int c = 0; c < 3; c++)
            fragments.colour[i][c] = ANY_UNSIGNED(0, UINT_MAX);
    }
    return fragments;
}

static void store(const glint_format *format, void *tile) {
    const glint_fragments fragments = any_fragments();
    FOR_PARTS(shift, 3, 6) {
        format->store(tile, &fragments, (unsigned)shift);
    }
}

static void fill(const glint_format *format, void *tile) {
    const uint32_t colour[3] = {ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX)};
    FOR_PARTS(width, 3, 6) {
        FOR_PARTS(height, 3, 6) {
            format->fill(tile, 1u << width, 1u << height, colour);
        }
    }
}

/* Any colour, any threshold from 0 to 2^23 - 1, up to 255 levels. @unsigned */
PROOF(glint_level) {
    glint_level(ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, 255), ANY_UNSIGNED(0, (1u << 23) - 1));
}

/* Any colour. @unsigned */
PROOF(glint_luma) {
    const uint32_t colour[3] = {ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX)};
    glint_luma(colour);
}

/* Any offset and row. */
PROOF(glint_dither_threshold) {
    glint_dither_threshold(ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX));
}

/* Up to 8 fragments of any colour anywhere in a tile, plain and dithered. */
PROOF(rgb565_store) {
    static uint16_t tile[SIDE * SIDE * 16 / 16];
    store(&glint_format_rgb565, tile);
    store(&glint_format_rgb565_dithered, tile);
}

/* Any colour, tiles of 8 to 64 pixels a side, plain and dithered. */
PROOF(rgb565_fill) {
    static uint16_t tile[SIDE * SIDE * 16 / 16];
    fill(&glint_format_rgb565, tile);
    fill(&glint_format_rgb565_dithered, tile);
}

/* Up to 8 fragments of any colour anywhere in a tile, plain and dithered. */
PROOF(rgb565_be_store) {
    static uint8_t tile[SIDE * SIDE * 16 / 8];
    store(&glint_format_rgb565_be, tile);
    store(&glint_format_rgb565_be_dithered, tile);
}

/* Any colour, tiles of 8 to 64 pixels a side, plain and dithered. */
PROOF(rgb565_be_fill) {
    static uint8_t tile[SIDE * SIDE * 16 / 8];
    fill(&glint_format_rgb565_be, tile);
    fill(&glint_format_rgb565_be_dithered, tile);
}

/* Up to 8 fragments of any colour anywhere in a tile, plain and dithered. */
PROOF(rgb888_store) {
    static uint8_t tile[SIDE * SIDE * 24 / 8];
    store(&glint_format_rgb888, tile);
    store(&glint_format_rgb888_dithered, tile);
}

/* Any colour, tiles of 8 to 64 pixels a side, plain and dithered. */
PROOF(rgb888_fill) {
    static uint8_t tile[SIDE * SIDE * 24 / 8];
    fill(&glint_format_rgb888, tile);
    fill(&glint_format_rgb888_dithered, tile);
}

/* Up to 8 fragments of any colour anywhere in a tile, plain and dithered. */
PROOF(grey8_store) {
    static uint8_t tile[SIDE * SIDE * 8 / 8];
    store(&glint_format_grey8, tile);
    store(&glint_format_grey8_dithered, tile);
}

/* Any colour, tiles of 8 to 64 pixels a side, plain and dithered. */
PROOF(grey8_fill) {
    static uint8_t tile[SIDE * SIDE * 8 / 8];
    fill(&glint_format_grey8, tile);
    fill(&glint_format_grey8_dithered, tile);
}

/* Up to 8 fragments of any colour anywhere in a tile, plain and dithered. */
PROOF(grey4_store) {
    static uint8_t tile[SIDE * SIDE * 4 / 8];
    store(&glint_format_grey4, tile);
    store(&glint_format_grey4_dithered, tile);
}

/* Any colour, tiles of 8 to 64 pixels a side, plain and dithered. */
PROOF(grey4_fill) {
    static uint8_t tile[SIDE * SIDE * 4 / 8];
    fill(&glint_format_grey4, tile);
    fill(&glint_format_grey4_dithered, tile);
}

/* Up to 8 fragments of any colour anywhere in a tile, plain and dithered. */
PROOF(rgb444_store) {
    static uint8_t tile[SIDE * SIDE * 12 / 8];
    store(&glint_format_rgb444, tile);
    store(&glint_format_rgb444_dithered, tile);
}

/* Any colour, tiles of 8 to 64 pixels a side, plain and dithered. */
PROOF(rgb444_fill) {
    static uint8_t tile[SIDE * SIDE * 12 / 8];
    fill(&glint_format_rgb444, tile);
    fill(&glint_format_rgb444_dithered, tile);
}

/* Up to 8 fragments of any colour anywhere in a tile, plain and dithered. */
PROOF(mono_store) {
    static uint8_t tile[SIDE * SIDE * 1 / 8];
    store(&glint_format_mono, tile);
    store(&glint_format_mono_dithered, tile);
}

/* Any colour, tiles of 8 to 64 pixels a side, plain and dithered. */
PROOF(mono_fill) {
    static uint8_t tile[SIDE * SIDE * 1 / 8];
    fill(&glint_format_mono, tile);
    fill(&glint_format_mono_dithered, tile);
}

/* Up to 8 fragments of any colour anywhere in a tile, plain and dithered. */
PROOF(mono_pages_store) {
    static uint8_t tile[SIDE * SIDE * 1 / 8];
    store(&glint_format_mono_pages, tile);
    store(&glint_format_mono_pages_dithered, tile);
}

/* Any colour, tiles of 8 to 64 pixels a side, plain and dithered. */
PROOF(mono_pages_fill) {
    static uint8_t tile[SIDE * SIDE * 1 / 8];
    fill(&glint_format_mono_pages, tile);
    fill(&glint_format_mono_pages_dithered, tile);
}
