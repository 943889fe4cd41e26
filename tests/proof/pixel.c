/* SPDX-License-Identifier: MIT */
/*
 * Stores: every format into a tile of 64 x 64 pixels and not a byte more.
 * @link pixel/pixel_rgb565.c @link pixel/pixel_rgb565_be.c @link pixel/pixel_rgb888.c @link pixel/pixel_grey8.c
 * @link pixel/pixel_grey4.c @link pixel/pixel_rgb444.c @link pixel/pixel_mono.c @link pixel/pixel_mono_pages.c
 * @link pixel/dither.c
 */
#include "proof.h"

#include "../../src/pixel/pixel.h"
#include "contracts.h"

#define SIDE 64

static void any_colours(int32_t (*colour)[3], uint32_t count) {
    for (uint32_t i = 0; i < count; i++)
        for (int c = 0; c < 3; c++)
            colour[i][c] = ANY_CHANNEL;
}

/*
 * From the first columns and the last to the end of the first row and of the last: into the tile's first byte and its
 * last, no further.
 */
static void store(const glint_format *format, uint8_t *tile) {
    FOR_PARTS(shift, 3, 6) {
        const uint32_t width = 1u << shift, size = width * SIDE * format->bits / 8;
        const uint32_t columns[3] = {0, 1, width - 1};
        FOR_PARTS(i, 0, 2) {
            const uint32_t first = columns[i], count = width - first;
            const glint_run begin = {(uint8_t)first, 0, (uint8_t)count},
                            end = {(uint8_t)first, SIDE - 1, (uint8_t)count};
            int32_t colour[SIDE][3];
            any_colours(colour, count);
            format->store(tile, (unsigned)shift, &begin, &begin + 1, (const int32_t(*)[3])colour);
            format->store(tile + (SIDE * SIDE * format->bits / 8 - size), (unsigned)shift, &end, &end + 1,
                          (const int32_t(*)[3])colour);
        }
    }
}

/* Any words of the tile's first pixel and its last, and of none. */
static void store_spread(const glint_format *format, uint8_t *tile) {
    FOR_PARTS(shift, 3, 6) {
        const uint32_t last = (SIDE << shift) - 1;
        const glint_spread words[2] = {{0, ANY_UNSIGNED(0, UINT_MAX)}, {last, ANY_UNSIGNED(0, UINT_MAX)}};
        format->store_spread(tile, (unsigned)shift, words, words + 2);
        format->store_spread(tile, (unsigned)shift, words, words);
    }
}

static void fill(const glint_format *format, uint8_t *tile) {
    int32_t colour[1][3];
    any_colours(colour, 1);
    FOR_PARTS(shift, 3, 6) {
        FOR_PARTS(height, 3, 6) {
            const uint32_t size = (1u << shift << height) * format->bits / 8;
            format->fill(tile + (SIDE * SIDE * format->bits / 8 - size), (unsigned)shift, 1u << height, colour[0]);
        }
    }
}

/* Any channel, in levels of each number of bits, and any threshold. */
PROOF(glint_level) {
    FOR_PARTS(bits, 4, 8) {
        const uint32_t level = glint_level(ANY_CHANNEL, (unsigned)bits, ANY_UNSIGNED(0, 128));
        /*@ assert level < 1 << bits; */
    }
}

/* Any channels, whatever their range, as one of any number of levels, any threshold. @unsigned */
PROOF(glint_luma_level) {
    FOR_PARTS(bits, 1, 8) {
        const int32_t colour[3] = {ANY_INT, ANY_INT, ANY_INT};
        glint_luma_level(colour, (1u << bits) - 1, ANY_UNSIGNED(0, 127));
    }
}

/* Any sum of two words. */
PROOF(glint_spread_clamp) {
    glint_spread_clamp(ANY_UNSIGNED(0, UINT_MAX));
}

/* Any word. */
PROOF(glint_spread_pack) {
    glint_spread_pack(ANY_UNSIGNED(0, UINT_MAX));
}

/* Any offset in a tile of any width, dithered and not. */
PROOF(glint_threshold) {
    FOR_PARTS(shift, 3, 6) {
        const glint_target target = {0, (unsigned)shift, ANY(0, 1)};
        glint_threshold(&target, ANY_UNSIGNED(0, UINT_MAX));
    }
}

/* Runs of any channels at both ends of tiles of 8 to 64 columns, plain and dithered. */
PROOF(rgb565_store) {
    static uint16_t tile[SIDE * SIDE];
    store(&glint_format_rgb565, (uint8_t *)tile);
    store(&glint_format_rgb565_dithered, (uint8_t *)tile);
}

/* Any channels, tiles of 8 to 64 pixels a side, plain and dithered. */
PROOF(rgb565_fill) {
    static uint16_t tile[SIDE * SIDE];
    fill(&glint_format_rgb565, (uint8_t *)tile);
    fill(&glint_format_rgb565_dithered, (uint8_t *)tile);
}

/* Runs of any channels at both ends of tiles of 8 to 64 columns, plain and dithered. */
PROOF(rgb565_be_store) {
    static uint8_t tile[SIDE * SIDE * 16 / 8];
    store(&glint_format_rgb565_be, tile);
    store(&glint_format_rgb565_be_dithered, tile);
}

/* Any channels, tiles of 8 to 64 pixels a side, plain and dithered. */
PROOF(rgb565_be_fill) {
    static uint8_t tile[SIDE * SIDE * 16 / 8];
    fill(&glint_format_rgb565_be, tile);
    fill(&glint_format_rgb565_be_dithered, tile);
}

/* Runs of any channels at both ends of tiles of 8 to 64 columns, plain and dithered. */
PROOF(rgb888_store) {
    static uint8_t tile[SIDE * SIDE * 24 / 8];
    store(&glint_format_rgb888, tile);
    store(&glint_format_rgb888_dithered, tile);
}

/* Any channels, tiles of 8 to 64 pixels a side, plain and dithered. */
PROOF(rgb888_fill) {
    static uint8_t tile[SIDE * SIDE * 24 / 8];
    fill(&glint_format_rgb888, tile);
    fill(&glint_format_rgb888_dithered, tile);
}

/* Runs of any channels at both ends of tiles of 8 to 64 columns, plain and dithered. */
PROOF(grey8_store) {
    static uint8_t tile[SIDE * SIDE * 8 / 8];
    store(&glint_format_grey8, tile);
    store(&glint_format_grey8_dithered, tile);
}

/* Any channels, tiles of 8 to 64 pixels a side, plain and dithered. */
PROOF(grey8_fill) {
    static uint8_t tile[SIDE * SIDE * 8 / 8];
    fill(&glint_format_grey8, tile);
    fill(&glint_format_grey8_dithered, tile);
}

/* Runs of any channels at both ends of tiles of 8 to 64 columns, plain and dithered. */
PROOF(grey4_store) {
    static uint8_t tile[SIDE * SIDE * 4 / 8];
    store(&glint_format_grey4, tile);
    store(&glint_format_grey4_dithered, tile);
}

/* Any channels, tiles of 8 to 64 pixels a side, plain and dithered. */
PROOF(grey4_fill) {
    static uint8_t tile[SIDE * SIDE * 4 / 8];
    fill(&glint_format_grey4, tile);
    fill(&glint_format_grey4_dithered, tile);
}

/* Runs of any channels at both ends of tiles of 8 to 64 columns, plain and dithered. */
PROOF(rgb444_store) {
    static uint8_t tile[SIDE * SIDE * 12 / 8];
    store(&glint_format_rgb444, tile);
    store(&glint_format_rgb444_dithered, tile);
}

/* Any channels, tiles of 8 to 64 pixels a side, plain and dithered. */
PROOF(rgb444_fill) {
    static uint8_t tile[SIDE * SIDE * 12 / 8];
    fill(&glint_format_rgb444, tile);
    fill(&glint_format_rgb444_dithered, tile);
}

/* Runs of any channels at both ends of tiles of 8 to 64 columns, plain and dithered. */
PROOF(mono_store) {
    static uint8_t tile[SIDE * SIDE * 1 / 8];
    store(&glint_format_mono, tile);
    store(&glint_format_mono_dithered, tile);
}

/* Any channels, tiles of 8 to 64 pixels a side, plain and dithered. */
PROOF(mono_fill) {
    static uint8_t tile[SIDE * SIDE * 1 / 8];
    fill(&glint_format_mono, tile);
    fill(&glint_format_mono_dithered, tile);
}

/* Runs of any channels at both ends of tiles of 8 to 64 columns, plain and dithered. */
PROOF(mono_pages_store) {
    static uint8_t tile[SIDE * SIDE * 1 / 8];
    store(&glint_format_mono_pages, tile);
    store(&glint_format_mono_pages_dithered, tile);
}

/* Any channels, tiles of 8 to 64 pixels a side, plain and dithered. */
PROOF(mono_pages_fill) {
    static uint8_t tile[SIDE * SIDE * 1 / 8];
    fill(&glint_format_mono_pages, tile);
    fill(&glint_format_mono_pages_dithered, tile);
}

/* Any words in tiles of 8 to 64 columns, dithered. @unreached 1 the threshold of what is not */
PROOF(rgb565_store_spread) {
    static uint16_t room[SIDE * SIDE];
    uint8_t *const tile = (uint8_t *)room;
    store_spread(&glint_format_rgb565_dithered, tile);
}

/* Any words in tiles of 8 to 64 columns, dithered. @unreached 1 the threshold of what is not */
PROOF(rgb565_be_store_spread) {
    static uint8_t tile[SIDE * SIDE * 16 / 8];
    store_spread(&glint_format_rgb565_be_dithered, tile);
}

/* Any words in tiles of 8 to 64 columns, plain and dithered. @unreached 3 of glint_saturate, which the proof of
 * glint_level passes through */
PROOF(rgb444_store_spread) {
    static uint8_t tile[SIDE * SIDE * 12 / 8];
    store_spread(&glint_format_rgb444, tile);
    store_spread(&glint_format_rgb444_dithered, tile);
}
