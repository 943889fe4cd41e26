/* SPDX-License-Identifier: MIT */
/* Lights with terms of their own. */
#include "proof.h"

#include "../../src/nodes/row_lights.c"

#include "../../src/math/tables.c"
#include "pixel_runs.h"

/*
 * Not proven: glint_row_add_side, glint_row_add_lobe: they hand a light's polynomials to what is proven. Suites `nodes`
 * and `identity` under ASan and UBSan, and fuzzing.
 */

/* A number that is at most 1 at nodes is at most 3/2 between them, where bound.c takes polynomials through them: what
 * turns by 2, as 1/w doubles, is off by 0.495. Suite `nodes`. */
#define NUMBER_MOST (3 << 29)

/* So is a strength at most 9/8: it is off by 0.064 where a light is no nearer than 4/3 of a region's width. */
#define STRENGTH_MOST (9 << 27)

/*@ assigns \result \from value;
    ensures 0 <= \result <= 0x8040; */
static inline int32_t smooth_step_at(int32_t value);

/* Stands on a value between two nodes, both of which are at most 2^15: `make domains` takes every cosine. */
/*@ requires \valid_read(cosine + (0 .. 95));
    requires 1 <= x <= 0x7fffffff;
    assigns \result \from cosine[0 .. 95], x;
    admit ensures \result <= 0x8000; */
static inline uint32_t glint_power_of_cosine(const uint16_t *cosine, uint32_t x);

/*@ requires \valid_read(terms);
    assigns \result \from indirect: *terms;
    ensures \result.upper <= 13; */
static lobe_table table_of(const glint_terms *terms);

/* Stands on a value between two nodes, both of which are at most 2^15. */
/*@ requires \valid_read(table);
    assigns \result \from indirect: *table, square;
    admit ensures 0 <= \result <= 0x8000; */
static inline int32_t power_of_square(const lobe_table *table, uint32_t square);

/* Stands on weights that sum up to less than 15, as terms_prepare.c takes them, and on errors of a part of a level:
 * what others have made leaves room for each. Suite `nodes` under UBSan. */
/*@ requires \valid(colour + (0 .. 2)) && \valid_read(weight + (0 .. 2));
    requires 0 <= amount <= 0x10000;
    requires \subset(weight[0 .. 2], (0 .. 61440));
    assigns colour[0 .. 2] \from colour[0 .. 2], amount, weight[0 .. 2];
    ensures \initialized(colour + (0 .. 2)); */
static inline void add(int32_t *colour, int32_t amount, const uint16_t *weight);

/*@ requires 0 <= power <= 0x9000;
    requires \valid_read(of) && \valid_read(to) && \valid_read(run);
    assigns \result \from power, indirect: *of, is_ungated, indirect: *to, indirect: *run, i;
    ensures 0 <= \result <= 0x9100; */
static int32_t weaken(int32_t power, const light_parts *of, int is_ungated, const glint_pixel_runs *to,
                      const glint_run *run, uint32_t i);

/* 1 / |M| of pixels, by eighths, and what numbers over |M|^times may be there. */
#define FOR_LENGTHS(part) FOR_PARTS(part, 8, 15)
static int32_t any_length(int part, int times) {
    int64_t most = NUMBER_MOST;
    any_inverses(part << 12, (part << 12) + 4095);
    for (int i = 0; i < times; i++)
        most = most * 8 / part;
    return (int32_t)most;
}

#define FOR_LENGTHS_IF(part, times) FOR_PARTS(part, (times) ? 8 : 15, 15)

/* What a light's parts are, by bits of `kinds`: any cone, any side, any strength of up to 9/8. */
static light_parts any_parts(int kinds, int is_below) {
    static glint_quadratic of[3];
    any_number(&of[0]);
    any_number(&of[1]);
    any_polynomial(&of[2], is_below, STRENGTH_MOST);
    return (light_parts){kinds & 1 ? &of[0] : 0, kinds >> 1 & 1 ? &of[1] : 0, kinds >> 2 & 1 ? &of[2] : 0, 0};
}

/* Some parts of each sign. */
#define FOR_ALL_PARTS(of)     \
    FOR_PARTS(kinds, 0, 7)    \
    FOR_PARTS(is_below, 0, 1) \
    for (light_parts parts = any_parts(kinds, is_below), *of = &parts; of; of = 0)

/* Weights below 15; a share of up to 1, of sums of as many bits as those below 15 have. */
static light_share any_share(void) {
    static uint16_t weight[3];
    for (int c = 0; c < 3; c++)
        weight[c] = (uint16_t)ANY(0, MOST_OF_WEIGHTS);
    return (light_share){weight, ANY(0, 1 << 15), ANY_UNSIGNED(0, 1), ANY_UNSIGNED(15, 19)};
}

/* Any number, by its parts of a 1024th between 0 and 1. */
PROOF(smooth_step_at) {
    smooth_step_at(ANY(INT32_MIN, -1));
    FOR_PARTS(part, 0, 1023) {
        smooth_step_at(ANY(part << 18, (part << 18) + (1 << 18) - 1));
    }
    smooth_step_at(ANY(1 << 28, INT32_MAX));
}

/* Any table of powers, x from 1 to 2^31 - 1, by its bits. @unreached 2 leading zeros of 0, and a number of no bits */
PROOF(glint_power_of_cosine) {
    static uint16_t cosine[GLINT_COSINE_VALUES];
    for (int i = 0; i < GLINT_COSINE_VALUES; i++)
        cosine[i] = (uint16_t)ANY(0, 1 << 15);
    FOR_PARTS(bits, 1, 31) {
        glint_power_of_cosine(cosine, ANY_OF_BITS(bits));
    }
}

/*
 * Weights below 15, by quarters of 1, amounts of up to 1/32 more than 1, or of up to 2 for weights of up to 1/8; and
 * colours: what the other weights, which are below 15 with this one, may have made.
 */
PROOF(add) {
    const int32_t most = (1 << 15) + (1 << 10);
    int32_t colour[3];
    uint16_t weight[3];
    FOR_PARTS(quarter, -1, 59) {
        const int32_t first = quarter < 0 ? 0 : quarter << 10, last = quarter < 0 ? 1 << 9 : (quarter + 1) << 10;
        for (int c = 0; c < 3; c++) {
            weight[c] = (uint16_t)ANY(first, last);
            colour[c] = ANY(-(1 << 27), (MOST_OF_WEIGHTS - first) * most);
        }
        add(colour, ANY(0, quarter < 0 ? 1 << 16 : most), weight);
    }
}

/*
 * Any power up to 9/8; any cone, any side.
 * @contract smooth_step_at
 * @narrowing polynomials are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(weaken) {
    any_runs(0, 0);
    FOR_ALL_PARTS(of) {
        weaken(ANY(0, 9 << 12), of, ANY(0, 1), &to, runs, 0);
    }
}

/*
 * N.L of up to 3/2, over no length or |M|, by eighths of 1 / |M|; any cone, or none.
 * @contract smooth_step_at add
 * @narrowing polynomials are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(add_side) {
    glint_quadratic side;
    const light_share share = any_share();
    FOR_PARTS(is_chroma, 0, 1) {
        FOR_ALL_PARTS(of) {
            any_runs(0, 0);
            of->side = &side;
            any_polynomial(&side, is_below, NUMBER_MOST);
            to.inverse = 0;
            add_side(of, &share, &to, (int)is_chroma);
            FOR_LENGTHS(part) {
                any_runs(0, 0);
                any_polynomial(&side, is_below, any_length((int)part, 1));
                add_side(of, &share, &to, (int)is_chroma);
            }
        }
    }
}

/* Any window, any shift that leaves no other below 0, over no length, |M| or |M|^2. */
PROOF(table_of) {
    terms.light = &light;
    terms.power = &table;
    terms.is_over_length = (uint8_t)ANY(0, 2);
    FOR_PARTS(shift, GLINT_POWER_FRACTION_BITS, 30 - GLINT_POWER_TABLE_BITS) {
        FOR_PARTS(kept, 0, 12) {
            table.index_shift = (uint32_t)shift;
            table.window = 1u << (shift + GLINT_POWER_TABLE_BITS);
            light.lobe_shift = (uint32_t)kept;
            light.lobe_end = ANY_UNSIGNED(0, 1u << 28);
            if (shift + 2 * kept >= 14 && shift + GLINT_POWER_TABLE_BITS + 2 * kept <= 33)
                table_of(&terms);
        }
    }
}

/* Squares below 2 to the power of 16 and up to 13 more, any 1 / |M|. @unsigned */
PROOF(square_over) {
    FOR_PARTS(upper, 0, 13) {
        const lobe_table of = {0, 0, 0, (unsigned)upper, 0};
        FOR_PARTS(times, 1, 2) {
            square_over(ANY_UNSIGNED(0, (1u << (16 + upper)) - 1), ANY_UNSIGNED(0, UINT16_MAX), (uint32_t)times, &of);
        }
    }
}

/* Any table, every place of its intervals, and any number within it. */
PROOF(power_of_square) {
    static uint16_t value[GLINT_POWER_INTERVALS + 1];
    for (int i = 0; i <= GLINT_POWER_INTERVALS; i++)
        value[i] = (uint16_t)ANY(0, 1 << 15);
    FOR_PARTS(index, GLINT_POWER_FRACTION_BITS, 31) {
        const lobe_table of = {value, 0, 0, 0, (unsigned)index - GLINT_POWER_FRACTION_BITS};
        const unsigned bits = (unsigned)index + GLINT_POWER_TABLE_BITS;
        power_of_square(&of, ANY_UNSIGNED(0, bits < 32 ? (1u << bits) - 1 : UINT_MAX));
    }
}

/*
 * Deviations of up to 3/2 of a node's, over no length, |M| or |M|^2, by eighths of 1 / |M|; any table of powers; a
 * cone, a side or a strength, all or none of them.
 * @contract add weaken table_of power_of_square
 * @narrowing polynomials are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(add_lobe) {
    glint_quadratic lobe[2];
    const light_share share = any_share();
    light.lobe_end = ANY_UNSIGNED(0, 1u << 24);
    light.lobe_shift = ANY_UNSIGNED(0, 12);
    terms.is_ungated = (uint8_t)ANY(0, 1);
    FOR_PARTS(part_of, 0, 4) {
        light_parts of = any_parts(part_of == 4 ? 7 : 1 << part_of >> 1, 0);
        of.lobe = lobe;
        FOR_PARTS(signs, 0, 3) {
            FOR_PARTS(times, 0, 2) {
                terms.is_over_length = (uint8_t)times;
                FOR_LENGTHS_IF(part, times) {
                    const int32_t most = any_length((int)part, (int)times) / 2;
                    any_runs(0, 0);
                    take_inverses((int)times);
                    any_polynomial(&lobe[0], signs & 1, most);
                    any_polynomial(&lobe[1], signs >> 1, most);
                    add_lobe(&terms, &of, &share, &to, 0);
                    any_runs(0, 0);
                    take_inverses((int)times);
                    add_lobe(&terms, &of, &share, &to, 1);
                }
            }
        }
    }
}

/*
 * A cosine of up to 3/2 and a strength of up to 9/8, or none, the former over no length, |M| or |M|^2, by eighths of
 * 1 / |M|; any cone and side, one of them, or none; any table of powers.
 * @contract add glint_power_of_cosine weaken
 * @narrowing polynomials are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(add_wide_lobe) {
    glint_quadratic lobe;
    const light_share share = any_share();
    terms.is_ungated = (uint8_t)ANY(0, 1);
    table.exponent = ANY(0, 1);
    FOR_PARTS(signs, 0, 5) { /* of the cosine, and of the strength, if there is one */
        FOR_PARTS(cut, 0, 3) {
            light_parts of = any_parts((int)cut | (signs >> 1 < 2 ? 4 : 0), signs >> 1 & 1);
            of.lobe = &lobe;
            FOR_PARTS(times, 0, 2) {
                terms.is_over_length = (uint8_t)times;
                FOR_LENGTHS_IF(part, times) {
                    any_runs(0, 0);
                    any_polynomial(&lobe, signs & 1, any_length((int)part, (int)times));
                    take_inverses((int)times);
                    add_wide_lobe(&terms, &of, &share, &to, ANY(0, 1));
                }
            }
        }
    }
}

/*
 * Any polynomials of two lights, of any kinds, any margin.
 * @narrowing polynomials are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(glint_terms_find_edge) {
    glint_quadratic polynomials[2 * GLINT_NUMBERS];
    uint8_t columns[GLINT_TILE_MAX];
    static glint_part part;
    part.x = ANY(-2047, 2047);
    part.y = ANY(-2047, 2047);
    for (int i = 0; i < 2 * GLINT_NUMBERS; i++)
        any_number(&polynomials[i]);
    any_runs(0, 0);
    terms.margin = ANY(0, INT32_MAX);
    terms.is_ungated = (uint8_t)ANY(0, 1);
    terms.apart_count = 2;
    light.lobe_has_strip = (uint8_t)ANY(0, 1);
    FOR_PARTS(kinds, 0, 31) {
        for (int a = 0; a < 2; a++)
            terms.apart[a] = (glint_apart){0, (uint8_t)kinds, (uint8_t)(a * GLINT_NUMBERS)};
        glint_terms_find_edge(&terms, polynomials, &part, runs, columns);
    }
}
