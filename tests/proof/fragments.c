/* SPDX-License-Identifier: MIT */
/* Fragments on their way to pixels. */
#include "proof.h"

#include "../../src/light/fragments.c"
#include "gathering.h"
#include "lit.h"
#include "pixels.h"
#include "plane.h"

/*@ requires -0x8000000 <= channel <= 0x78000000;
    requires bits <= 8;
    assigns \result \from channel, bits;
    ensures -0x8000000 <= \result <= 0x78000000; */
static inline int32_t glint_to_levels(int32_t channel, unsigned bits);

#define WIDTH 8

static glint_vertex corners[3];
static glint_triangle triangle;

/* 1/w of the corners, by the bits of the largest, first or last. */
#define FOR_CORNERS(bits)                                                                                    \
    FOR_PARTS(bits, 7, 31)                                                                                   \
    FOR_PARTS(is_last, 0, 1)                                                                                 \
    if (corners[0].inverse_w = ANY(is_last ? 64 : (int32_t)((1u << bits) / 2), (int32_t)((1u << bits) - 1)), \
        corners[1].inverse_w = ANY(64, (int32_t)((1u << bits) - 1)),                                         \
        corners[2].inverse_w = ANY(is_last ? (int32_t)((1u << bits) / 2) : 64, (int32_t)((1u << bits) - 1)), 1)

/*
 * Corners of any normals, 1/w by the bits of the largest, first or last; with colours of their own and without;
 * seen from both sides, lit at fragments and at vertices.
 * @contract glint_plane_begin
 * @unreached 2 leading zeros of 0
 */
PROOF(glint_gathering_begin) {
    static int16_t extra[3][3];
    const glint_evaluation evaluation = {.lit_at = (uint8_t)ANY(GLINT_LIT_AT_FRAGMENTS, GLINT_LIT_AT_VERTICES)};
    glint_draw draw;
    glint_part part;
    glint_fragments fragments;
    glint_attributes attributes;
    const glint_gathering gathering = {0, 0, &part, &draw, 0, &fragments};
    draw.evaluation = &evaluation;
    triangle.back = ANY(0, 1);
    const int16_t *const main[3] = {corners[0].attribute, corners[1].attribute, corners[2].attribute};
    for (int i = 0; i < 3; i++) {
        for (int c = 0; c < 3; c++) {
            corners[i].attribute[c] = ANY_COMPONENT;
            extra[i][c] = (int16_t)ANY(0, GLINT_COLOUR_ONE);
        }
        triangle.corners[i] = &corners[i];
        triangle.extra[i] = extra[i];
    }
    if (ANY(0, 1))
        any_wide(&part.gradients);
    else
        any_narrow(&part.gradients);
    FOR_CORNERS(bits) {
        FOR_PARTS(has_extra, 0, 1) {
            draw.extra = has_extra ? extra : 0;
            glint_gathering_begin(&gathering, &triangle, main, &attributes);
            /*@ assert fragments.scale <= 30; */
        }
    }
}

static void any_store(void *pixels, unsigned shift, const glint_run *run, const glint_run *end,
                      const int32_t (*colour)[3]) {
    (void)pixels;
    for (uint32_t before = 0; run != end; before += run->count, run++) {
        /*@ assert 0 < run->count && (run->y << shift) + run->x + run->count <= 8 << shift; */
        /*@ assert \initialized(&colour[before .. before + run->count - 1][0 .. 2]); */
    }
}

/*
 * No fragments, or 1 to 9, one below the other or side by side, with output tables and without.
 * @contract glint_shade glint_channels_of glint_finish_colours glint_to_levels
 * @unreached 1 what is done built for size
 */
PROOF(glint_gathering_store) {
    static const glint_format format = {.store = any_store, .channel = {5, 6, 5}};
    static const uint16_t tables[3][GLINT_GAMMA_ENTRIES];
    glint_fragments fragments;
    glint_attributes attributes;
    glint_draw draw;
    glint_frame frame;
    glint_part part;
    glint_workspace workspace;
    const glint_gathering gathering = {&frame, &workspace, &part, &draw, glint_shade, &fragments};
    workspace.pixels = 0;
    frame.config.format = &format;
    frame.tile_shift_x = 3;
    FOR_PARTS(count, 0, GLINT_FRAGMENTS_MAX) {
        FOR_PARTS(kind, 0, 3) {
            any_run(&frame, &fragments, &part, (uint32_t)count);
            fragments.attributes = &attributes;
            frame.config.gamma = kind & 2 ? tables : 0;
            for (int i = 0; i < count; i++) { /* of a row, the last begins the next */
                fragments.column[i] = (int8_t)(kind & 1 ? i % WIDTH : 3);
                fragments.row[i] = (int8_t)(kind & 1 ? 3 + i / WIDTH : i % WIDTH);
            }
            glint_gathering_store(&gathering);
            /*@ assert fragments.count == 0; */
        }
    }
}

/* Any pixel of a tile, or by a cell of the lattice beyond it; any 1/w. @contract glint_gathering_store
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits */
PROOF(glint_gather_lit) {
    glint_fragments fragments;
    glint_part part;
    const glint_gathering gathering = {0, 0, &part, 0, 0, &fragments};
    any_plane(&part.depth);
    part.x = ANY(-2047, 2047);
    part.y = ANY(-2047, 2047);
    FOR_PARTS(before, 0, GLINT_FRAGMENTS_MAX - 1) {
        const int32_t x = ANY(-16, GLINT_TILE_MAX + 16), y = ANY(-16, GLINT_TILE_MAX + 16);
        fragments.count = (uint32_t)before;
        glint_gather_lit(&gathering, x, y);
        /*@ assert fragments.count < GLINT_FRAGMENTS_MAX; */
        /*@ assert -16 <= fragments.column[before] <= 80; */
        /*@ assert 0 <= fragments.inverse_w[before]; */
    }
}
