/* SPDX-License-Identifier: MIT */
/* Runs: what terms make of pixels. */
#include "proof.h"

#include "../../src/nodes/rows.c"

#include "../../src/math/tables.c"
#include "pixel_runs.h"

/*
 * Not proven: draw_rows, begin_rows, begin_chroma, begin_chroma_over, begin_channels, begin_channels_over,
 * draw_chroma, draw_channels, add_sides, add_lobes, store_rows, find_base: they hand a row of two
 * tiles' pixels, which counts of runs keep within it, to what is proven. Suites `nodes` and `identity` under ASan and
 * UBSan, and fuzzing.
 */

/* 1 / |M| is a positive number of 16 bits. */
/*@ assigns \result \from square;
    ensures 0 < \result <= 0xffff; */
static inline uint32_t inverse_of(uint32_t square);

/* Stands on sums over |M| of less than 15, as terms_prepare.c takes them: the alarm of its driver. */
/*@ assigns \result \from sum, base, over; */
static inline int32_t over_length(uint32_t sum, int32_t base, uint32_t over);

/* |M|^2 of any value, by its upper 12 bits. @narrowing less than the least, it is a number with a sign */
PROOF(inverse_of) {
    FOR_PARTS(part, 0, 4095) {
        inverse_of(ANY_UNSIGNED((uint32_t)part << 20, ((uint32_t)part << 20) + 0xfffff));
    }
}

/* Three rows of six pixels in a tile of eight: more than there is room for. Any three, and three of them, are hidden.
 */
static glint_part part;
static uint16_t depth[8 * 3];
static glint_run found[GLINT_BATCH_RUNS];
static int32_t begun[2 * 8][3];
static uint16_t inverses[2 * 8];

static row_sums any_rows(int hidden, const glint_quadratic sum[3], const glint_quadratic *square) {
    part = (glint_part){.bottom = 3};
    part.x = ANY(-2047, 2047);
    part.y = ANY(-2047, 2047);
    part.depth.start = 1 << 30;
    for (int y = 0; y < 3; y++) {
        part.spans[y] = (glint_span){1, 7};
        for (int x = 1; x < 7; x++)
            depth[8 * y + x] = (uint16_t)(hidden >> x % 3 & 1 ? UINT16_MAX : 0);
    }
    return (row_sums){&part, sum, square, {ANY(0, SUM_MOST), ANY(0, SUM_MOST), ANY(0, SUM_MOST)}, depth, 3};
}

/*
 * Any sum of one chroma, or of channels, over any |M|, or not.
 * @contract inverse_of over_length
 * @narrowing polynomials are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(begin_rows_inline) {
    glint_quadratic sum[3], square;
    for (int c = 0; c < 3; c++)
        any_number(&sum[c]);
    any_number(&square);
    FOR_PARTS(hidden, 0, 7) {
        FOR_PARTS(kind, 0, 3) {
            const row_sums of = any_rows((int)hidden, sum, &square);
            uint32_t y = 0;
            begin_rows_inline(&of, &y, found, begun, inverses, kind & 1, kind >> 1);
        }
    }
}

/*
 * What is added to sums of up to 15 over |M|, by 32nds of 1 / |M|.
 * @alarms 1 sums and what is added to all are below 15, as terms_prepare.c takes them; suite `nodes` under UBSan
 */
PROOF(over_length) {
    FOR_PARTS(part_of, 32, 63) {
        const int32_t most = SUM_MOST / (int)part_of * 32;
        const uint32_t over = ANY_UNSIGNED((uint32_t)part_of << 10, ((uint32_t)part_of << 10) + 1023);
        over_length(ANY_UNSIGNED(0, (uint32_t)most), ANY(0, SUM_MOST), over);
    }
}

/* The surface's colours, Q14 in the high half, of up to 1/32 more than 1. */
static void any_surface(glint_quadratic surface[3], int is_below) {
    for (int c = 0; c < 3; c++) {
        any_polynomial(&surface[c], is_below, (1 << 30) + (1 << 25));
        light.half[c] = ANY(0, 1 << 25);
        light.ambient[c] = ANY(-(1 << 25), SUM_MOST);
    }
}

/*
 * Colours of up to 15 multiplied, and any colours raised to ambient light of up to 15; a surface's of up to 1/32 more
 * than 1.
 * @narrowing polynomials are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(take_surface) {
    glint_quadratic surface[3];
    FOR_PARTS(is_below, 0, 1) {
        any_surface(surface, (int)is_below);
        any_runs(-(1 << 27), SUM_MOST);
        take_surface(&light, surface, &to, 0);
        any_runs(INT32_MIN, INT32_MAX);
        take_surface(&light, surface, &to, 1);
    }
}

/* Any colours, ambient light of up to 15. */
PROOF(raise_row) {
    for (int c = 0; c < 3; c++) {
        light.half[c] = ANY(0, 1 << 25);
        light.ambient[c] = ANY(0, SUM_MOST);
    }
    any_runs(INT32_MIN, INT32_MAX);
    raise_row(&light, &to);
}

/* What light and gloss of up to 1 are mixed to, with weights below 7 each, and of a base below 1. */
static glint_mix any_mix(void) {
    glint_mix mix;
    for (int c = 0; c < 3; c++) {
        mix.base[c] = ANY(0, 1 << 27);
        mix.light[c] = ANY(0, 7 << 12);
        mix.gloss[c] = ANY(0, 7 << 12);
        mix.least[c] = ANY(0, SUM_MOST);
    }
    mix.has_least = ANY(0, 1);
    return mix;
}

/* Light and gloss of up to 1, weights below 7 each, and a base below 1: less than 15 together. */
PROOF(mix_rows) {
    const glint_mix mix = any_mix();
    any_runs(0, 1 << 15);
    mix_rows(&mix, &to);
}

/*
 * The same, light multiplied by a surface's colours of up to 1.
 * @narrowing polynomials are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(mix_with_surface) {
    const glint_mix mix = any_mix();
    glint_quadratic surface[3];
    int32_t half[3];
    FOR_PARTS(is_below, 0, 1) {
        for (int c = 0; c < 3; c++) {
            half[c] = ANY(0, 1 << 25);
            any_polynomial(&surface[c], (int)is_below, 1 << 30);
        }
        any_runs(0, 1 << 15);
        mix_with_surface(&mix, half, surface, &to);
    }
}
