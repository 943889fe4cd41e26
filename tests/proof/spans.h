/* SPDX-License-Identifier: MIT */
/**
 * @file spans.h
 * What loops over pixels are given: two rows of a tile, tables, planes.
 */
#ifndef GLINT_PROOF_SPANS_H
#define GLINT_PROOF_SPANS_H

#include "../../src/fast/fast_spans.h"
#include "pixels.h"

#define WIDTH 8

/* Depths and pixels of two rows, side by side as a workspace has them; the tables; a part. */
static uint16_t tile[2 * 2 * WIDTH];
static uint32_t words[1024 + GLINT_DIFFUSE_ENTRIES];
static uint16_t packed[GLINT_DIFFUSE_ENTRIES];
static glint_fast_terms fast;
static glint_part part;
static glint_fast_planes planes;

static glint_spans any_part(void) {
    const glint_spans spans = {&part, tile, (uint8_t *)(tile + 2 * WIDTH), 3};
    Frama_C_make_unknown((char *)tile, sizeof tile);
    Frama_C_make_unknown((char *)words, sizeof words);
    Frama_C_make_unknown((char *)packed, sizeof packed);
    any_plane(&part.depth);
    any_plane(&planes.cosine);
    any_plane(&planes.x);
    any_plane(&planes.y);
    part.x = ANY(-2047, 2047);
    part.y = ANY(-2047, 2047);
    fast.specular = words;
    fast.diffuse = words + 1024;
    fast.diffuse_stored = packed;
    fast.specular_end = ANY_UNSIGNED(1, 1024) << 15;
    fast.ambient = (uint16_t)ANY(0, 0xffff);
    part.top = 0;
    part.bottom = 2;
    return spans;
}

/* What words are made pixels by: suite of each format (pixel.c). */
static void store_words(void *pixels, unsigned shift, const glint_spread *from, const glint_spread *end) {
    (void)pixels;
    (void)shift;
    (void)from;
    (void)end;
}

/* The same for kernels of fast lighting, with room for words of three rows. */
static glint_fast_spans any_fast_part(void) {
    static const glint_format format = {.store_spread = store_words};
    static glint_spread list[3 * WIDTH];
    static glint_frame frame;
    static glint_workspace workspace;
    frame.config.format = &format;
    frame.config.tile_width = WIDTH;
    workspace.row = (int32_t(*)[3])(void *)list;
    fast.ambient_word = ANY_UNSIGNED(0, UINT_MAX);
    return (glint_fast_spans){any_part(), &frame, &workspace};
}

/* Pixels of 16 bits, in either order of bytes. */
#define ANY_565 ((glint_fast_store)ANY(GLINT_STORES_565, GLINT_STORES_565_BE))

/*
 * Every span of a row, and every column at which the row before it may have ended: what a loop carries from one to the
 * next.
 */
#define FOR_SPANS()                                                                            \
    FOR_PARTS(end, 0, WIDTH)                                                                   \
    FOR_PARTS(left, 0, WIDTH)                                                                  \
    FOR_PARTS(right, left, WIDTH)                                                              \
    if (part.spans[0].left = (uint8_t)(end ? end - 1 : 0), part.spans[0].right = (uint8_t)end, \
        part.spans[1].left = (uint8_t)left, part.spans[1].right = (uint8_t)right, 1)

#endif
