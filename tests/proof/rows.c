/* SPDX-License-Identifier: MIT */
/* Runs: what terms make of pixels. */
#include "proof.h"

#include "../../src/nodes/rows.c"

#include "../../src/math/tables.c"
#include "pixel_runs.h"

/*
 * Not proven: glint_terms_draw, find_colours, begin_row: they hand a row of two tiles' pixels, which counts of runs
 * keep within it, to what is proven. Suites `nodes` and `identity` under ASan and UBSan, and fuzzing.
 */

/* |M|^2 of any value. @narrowing polynomials are evaluated modulo 2^32: right wherever the true value fits */
PROOF(find_inverses) {
    glint_descent square;
    any_runs(0, 0);
    FOR_PARTS(is_below, 0, 1) {
        any_polynomial(&square, (int)is_below, INT32_MAX);
        find_inverses(&square, &to, inverse);
    }
}

/*
 * Any sum of one chroma, over |M| or not.
 * @alarms 9 sums and what is added to all are below 15, as terms_prepare.c takes them; suite `nodes` under UBSan
 * @narrowing polynomials are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(begin_with_chroma) {
    const int32_t base[3] = {ANY(0, SUM_MOST), ANY(0, SUM_MOST), ANY(0, SUM_MOST)};
    glint_descent sum;
    for (int c = 0; c < 3; c++)
        light.chroma[c] = ANY(0, 1 << 17);
    light.sum_bits = ANY_UNSIGNED(0, 4);
    any_number(&sum);
    any_runs(0, 0);
    begin_with_chroma(&terms, &sum, base, &to, 0);
    any_inverses(1 << 15, UINT16_MAX);
    begin_with_chroma(&terms, &sum, base, &to, 1);
}

/*
 * Any sums of channels; and such of up to 15 over |M|, by 32nds of 1 / |M|.
 * @alarms 3 sums and what is added to all are below 15, as terms_prepare.c takes them; suite `nodes` under UBSan
 * @narrowing polynomials are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(begin_with_channels) {
    const int32_t base[3] = {ANY(0, SUM_MOST), ANY(0, SUM_MOST), ANY(0, SUM_MOST)};
    glint_descent sum[3];
    for (int c = 0; c < 3; c++)
        any_number(&sum[c]);
    any_runs(0, 0);
    begin_with_channels(sum, base, &to);
    FOR_PARTS(is_below, 0, 1) {
        FOR_PARTS(part, 32, 63) {
            any_runs(0, 0);
            any_inverses(part << 10, (part << 10) + 1023);
            for (int c = 0; c < 3; c++)
                any_polynomial(&sum[c], (int)is_below, SUM_MOST / (int)part * 32);
            begin_with_channels(sum, base, &to);
        }
    }
}

/* The surface's colours, Q14 in the high half, of up to 1/32 more than 1. */
static void any_surface(glint_descent surface[3], int is_below) {
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
    glint_descent surface[3];
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
    raise_row(&light, row, PIXELS);
}
