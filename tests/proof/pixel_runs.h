/* SPDX-License-Identifier: MIT */
/** @file pixel_runs.h Two runs of pixels, and polynomials of any value there. */
#ifndef GLINT_PIXEL_RUNS_H
#define GLINT_PIXEL_RUNS_H

/* Sums of weights are below 15: terms_prepare.c. */
#define MOST_OF_WEIGHTS (15 << 12)
#define SUM_MOST (15 << 27)

#define PIXELS 3

static glint_run runs[2];
static int32_t row[PIXELS][3];
static uint16_t inverse[PIXELS];
static glint_pixel_runs to;
static glint_light_terms light;
static glint_terms terms;
static glint_power_table table;

/* Two runs, of colours from least to most. */
static void any_runs(int32_t least, int32_t most) {
    for (int i = 0; i < 2; i++) {
        runs[i].x = (uint8_t)ANY(0, GLINT_TILE_MAX - 2);
        runs[i].y = (uint8_t)ANY(0, GLINT_TILE_MAX - 1);
        runs[i].count = (uint8_t)(2 - i);
    }
    for (int i = 0; i < PIXELS; i++)
        for (int c = 0; c < 3; c++)
            row[i][c] = ANY(least, most);
    to = (glint_pixel_runs){runs, runs + 2, ANY(-2047, 2047), ANY(-2047, 2047), 0, row};
    terms.light = &light;
    terms.power = &table;
}

/* A polynomial that at each pixel is from 0 to `most`, or below 0. */
static void any_polynomial(glint_quadratic *q, int is_below, int32_t most) {
    *q = (glint_quadratic){0, 0, 0, 0, 0, 0};
    q->start = is_below ? ANY_UNSIGNED(0u - (uint32_t)most, UINT_MAX) : ANY_UNSIGNED(0, (uint32_t)most);
}

/* Any polynomial. */
static void any_number(glint_quadratic *q) {
    *q = (glint_quadratic){0, 0, 0, 0, 0, 0};
    q->start = ANY_UNSIGNED(0, UINT_MAX);
}

/* 1 / |M| of pixels, which those of one chroma have as a third number; or none. */
static void take_inverses(int are_there) {
    to.inverse = are_there ? inverse : 0;
    for (int i = 0; i < PIXELS && are_there; i++)
        row[i][2] = inverse[i];
}

static void any_inverses(int32_t least, int32_t most) {
    for (int i = 0; i < PIXELS; i++)
        row[i][2] = inverse[i] = (uint16_t)ANY(least, most);
    to.inverse = inverse;
}

#endif
