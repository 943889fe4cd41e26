/* SPDX-License-Identifier: MIT */
/* Loops over a part's pixels that every format makes its own. */
#include "proof.h"

#include "../../src/pixel/pixel.h"
#include "contracts.h"
#include "spans.h"

/* What a format does: stores are proven of each. */
static uint32_t any_pack(const int32_t colour[3], uint32_t threshold) {
    /*@ assert threshold < 128; */
    return glint_level(colour[0], 6, threshold);
}

static void any_put(const glint_target *target, uint32_t offset, uint32_t packed) {
    (void)packed;
    /*@ assert offset < 2 << target->shift; */
}

const uint8_t glint_dither_matrix[64] = {1, 127};

/*
 * Every span in two rows of a tile 8 pixels wide, any plane, any channels, plain and dithered: puts stay in the tile.
 * @unreached 1 the threshold of plain formats, which is known before
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 46
 */
PROOF(glint_draw_even_spans) {
    const glint_spans spans = any_part();
    const int32_t colour[3] = {ANY_CHANNEL, ANY_CHANNEL, ANY_CHANNEL};
    const glint_target plain = {spans.pixels, spans.shift, 0}, dithered = {spans.pixels, spans.shift, 1};
    FOR_SPANS() {
        glint_draw_even_spans(&spans, &plain, colour, any_pack, any_put);
        glint_draw_even_spans(&spans, &dithered, colour, any_pack, any_put);
    }
}

#define ANY_WORD ANY_UNSIGNED(0, UINT32_MAX)

/*
 * The same, of any polynomials, of the second degree and without.
 * @alarms 2 channels at a pixel lie no further than 1/4096 beyond those of the corners: suite `reads` looks at every
 * pixel of half a million triangles
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 46
 */
PROOF(glint_draw_channel_spans) {
    static glint_quadratic channels[3];
    const glint_spans spans = any_part();
    const glint_target plain = {spans.pixels, spans.shift, 0}, dithered = {spans.pixels, spans.shift, 1};
    for (int c = 0; c < 3; c++)
        channels[c] = (glint_quadratic){ANY_WORD, ANY_WORD, ANY_WORD, ANY_WORD, ANY_WORD, ANY_WORD};
    FOR_SPANS() {
        glint_draw_channel_spans(&spans, &plain, channels, 0, any_pack, any_put);
        glint_draw_channel_spans(&spans, &dithered, channels, 1, any_pack, any_put);
    }
}

/* Two numbers of a pixel, of up to 1 each, are mixed with weights below 7, and of a base below 1. */
static glint_mix any_mix(int has_least) {
    glint_mix mix;
    for (int c = 0; c < 3; c++) {
        mix.base[c] = ANY(0, 1 << 27);
        mix.light[c] = ANY(0, 7 << 12);
        mix.gloss[c] = ANY(0, 7 << 12);
        mix.least[c] = ANY_CHANNEL;
    }
    mix.has_least = has_least;
    return mix;
}

/*
 * The same of a number that is mixed, of any polynomial.
 * @unreached 1 gloss, which spans do not have
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 46
 */
PROOF(glint_draw_mixed) {
    const glint_quadratic light = {ANY_WORD, ANY_WORD, ANY_WORD, ANY_WORD, ANY_WORD, ANY_WORD};
    const glint_spans spans = any_part();
    const glint_target plain = {spans.pixels, spans.shift, 0}, dithered = {spans.pixels, spans.shift, 1};
    FOR_SPANS() {
        const glint_mix mix = any_mix(0), raised = any_mix(1);
        glint_draw_mixed(&spans, &plain, &light, &mix, any_pack, any_put);
        glint_draw_mixed(&spans, &dithered, &light, &raised, any_pack, any_put);
    }
}

/* A run in each of two rows of a tile 8 pixels wide, of light and gloss of up to 1. */
PROOF(glint_store_mixed) {
    static uint8_t pixels[2 * 8];
    static int32_t numbers[8][3];
    const glint_target plain = {pixels, 3, 0}, dithered = {pixels, 3, 1};
    const glint_run runs[2] = {{(uint8_t)ANY(0, 4), 0, 4}, {(uint8_t)ANY(0, 4), 1, 4}};
    for (int i = 0; i < 8; i++)
        for (int n = 0; n < 3; n++)
            numbers[i][n] = ANY(0, 1 << 15);
    FOR_PARTS(kind, 0, 3) {
        const glint_mix mix = any_mix(kind >> 1);
        glint_store_mixed(&plain, runs, runs + 2, &mix, kind & 1, (const int32_t(*)[3])numbers, any_pack, any_put);
        glint_store_mixed(&dithered, runs, runs + 2, &mix, kind & 1, (const int32_t(*)[3])numbers, any_pack, any_put);
    }
}
