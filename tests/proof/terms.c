/* SPDX-License-Identifier: MIT */
/* Terms of a triangle. */
#include "proof.h"

#include "../../src/math/tables.c"
#include "../../src/nodes/middles.c"
#include "../../src/nodes/terms.c"
#include "../../src/nodes/terms_vertices.c"
#include "lit.h"
#include "plane.h"

/*
 * Not proven: glint_terms_light, glint_terms_begin, begin_candidate, is_lit_at_corners, choose_fit, light_middles,
 * glint_find_middles, glint_sum_corners, sum_node, shine_node, mix_sums, mix_lobes, take_kept, begin_term_planes,
 * begin_term_quadratics, begin_light, begin_sums_of, set_quadratic, set_straight, take_corners, take_numbers,
 * take_sums, sum_at, mix_bulges, is_mixed, is_mixed_kind, is_mixed_sum, find_normals, has_edge: they walk corners and
 * lights, whose numbers are where place_numbers puts them, and call what is proven. Suites `nodes` and `identity` under
 * ASan and UBSan, and fuzzing.
 */

/* Numbers of lights, and sums. */
#define NUMBER 16388

/* A triangle that is not deep: its corners' 1/w with the largest at 15 bits. */
#define LEAST_W 32

static glint_vertex vertices[3];
static glint_triangle triangle;
static glint_frame frame;
static glint_view view;
static glint_light_terms light;
static int16_t colours[3][3];
static glint_candidate t;

/* 1/w of corners by the bits of the largest, the first or the last, and of the others no less than 2^-10 of that. */
#define FOR_CORNERS(bits) FOR_PARTS(bits, 17, 31) FOR_PARTS(is_last, 0, 1) if (any_corners((int)bits, (int)is_last), 1)

static void any_corners(int bits, int is_last) {
    for (int i = 0; i < 3; i++) {
        glint_vertex *v = &vertices[i];
        any_unit(v->attribute);
        for (int c = 0; c < 3; c++)
            colours[i][c] = (int16_t)ANY(0, INT16_MAX);
        v->x = (int16_t)ANY(-16367, 32735);
        v->y = (int16_t)ANY(-16367, 32735);
        v->inverse_w = (int32_t)(i == 2 * is_last ? ANY_OF_BITS(bits) : ANY_UNSIGNED(64, 0xffffffffu >> (32 - bits)));
        triangle.corners[i] = v;
        triangle.extra[i] = colours[i];
    }
}

/* Any node, of one channel or three. @narrowing bits are kept as they are @options -eva-slevel 0 */
PROOF(keep) {
    static int16_t to[54];
    glint_node node;
    for (int i = 0; i < GLINT_LIGHTS_MAX; i++)
        for (int kind = 0; kind < GLINT_NUMBERS; kind++) {
            node.number[i][kind] = ANY_SHORT;
            light.at[i][kind] = (uint8_t)ANY(0, 53);
        }
    for (int c = 0; c < 3; c++) {
        node.sum[c] = ANY(-32768, 32767);
        node.shine[c] = ANY(-32768, 32767);
    }
    node.levels = ANY_UNSIGNED(0, 3u << 16);
    node.lit = (uint8_t)ANY(0, UINT8_MAX);
    node.dark = (uint8_t)ANY(0, UINT8_MAX);
    node.outside = (uint16_t)ANY(0, UINT16_MAX);
    node.far = (uint8_t)ANY(0, UINT8_MAX);
    node.unfit = (uint8_t)ANY(0, UINT8_MAX);
    node.steep = (uint8_t)ANY(0, UINT8_MAX);
    node.left = (uint8_t)ANY(0, UINT8_MAX);
    FOR_PARTS(channels, 1, 3) {
        light.channels = (uint32_t)channels;
        keep(&light, ANY_UNSIGNED(0, 0xff), &node, to);
    }
}

/* Any corner. @unreached 1 a number of no bits */
PROOF(gather_corner) {
    glint_fragments fragments;
    any_view(&view);
    frame.view = &view;
    any_corners(31, 0);
    fragments.count = ANY_UNSIGNED(0, 2);
    gather_corner(&frame, &vertices[0], &fragments);
}

/*
 * Any corners, turned by up to 3/4, by the bits of the largest 1/w.
 * @contract glint_reciprocal16_by_division
 * @alarms 1 a sum whose leading zeros have gone has 16 bits; suite `nodes` under UBSan
 * @unreached 3 leading zeros of 0, and a number of no bits
 */
PROOF(find_shares) {
    for (int e = 0; e < 3; e++)
        t.apart[e] = ANY(0, 0x2400000);
    FOR_CORNERS(bits) {
        find_shares(&triangle, &t);
    }
}

/*
 * Sums, or numbers of 15 bits and a sign. Ends of an edge weigh from 0.39 to 0.61 where a region's slant is at most 1,
 * times up to 1.08 where it turns by up to 3/4: 4 times that less 2 is at most 0.62.
 */
PROOF(mix_ends) {
    for (int e = 0; e < 2; e++)
        t.share[0][e] = ANY(-20500, 20500);
    mix_ends(&t, 0, ANY(-32768, 32767), ANY(-32768, 32767));
}

/*
 * Any edge, by the bits of the larger 1/w; where numbers are found from the corners too, of any that turns by up to
 * 3/4.
 * @contract glint_unit_inline @narrowing a mean of unit vectors over its length has 15 bits
 * @unreached 3 leading zeros of 0, and a number of no bits
 */
PROOF(gather_middle) {
    glint_fragments fragments;
    any_view(&view);
    frame.view = &view;
    for (int n = 0; n < 2; n++)
        t.share[2][n] = ANY(-20500, 20500);
    FOR_PARTS(is_mixed, 0, 1) {
        t.is_mixed = (uint8_t)is_mixed;
        t.is_straight = 0;
        FOR_CORNERS(bits) {
            fragments.count = 0;
            gather_middle(&frame, &triangle, &t, 2, &fragments);
        }
    }
}

/* x from 2^13 to 2^15, by its bits. @contract glint_inverse_root @unreached 3 leading zeros of 0, and a number of no
 * bits */
PROOF(glint_root_of15) {
    FOR_PARTS(bits, 14, 15) {
        glint_root_of15(ANY_OF_BITS(bits));
    }
    glint_root_of15(1u << 15);
}

/*@ requires 0x2000 <= x <= 0x8000;
    assigns \result \from x;
    ensures 0 <= \result <= 0x10000; */
static int32_t glint_root_of15(uint32_t x);

/*
 * Any corners, by the bits of the largest 1/w. @contract glint_root_of15 glint_reciprocal16_by_division
 * @alarms 2 1/w over the largest is at most 1; suite `nodes` under UBSan
 * @unreached 3 leading zeros of 0, and a number of no bits
 */
PROOF(glint_find_lengths) {
    glint_lengths of;
    int32_t apart[3];
    for (int e = 0; e < 3; e++)
        apart[e] = ANY(0, 1 << 28);
    FOR_CORNERS(bits) {
        glint_find_lengths(&triangle, apart, &of);
    }
}

/* Numbers of 15 bits and a sign. */
PROOF(glint_triangle_keeps_side) {
    int32_t n[3], bulge[3];
    for (int i = 0; i < 3; i++) {
        n[i] = ANY(INT16_MIN, INT16_MAX);
        bulge[i] = ANY(-8 * 32768, 8 * 32768);
    }
    glint_triangle_keeps_side(n, bulge, ANY(0, 1 << 16));
}

/* Squares that are not too small. @contract glint_root_of15 */
PROOF(glint_find_middle_lengths) {
    glint_lengths of;
    for (int i = 0; i < 6; i++)
        of.square[i] = ANY(GLINT_LEAST_SQUARE, 1 << 15);
    glint_find_middle_lengths(&of);
}

/* Numbers of 15 bits and a sign, lengths of up to 1. */
PROOF(times_length) {
    times_length(ANY(INT16_MIN, INT16_MAX), ANY(0, (1 << 15) + 64));
}

/* Numbers of 15 bits and a sign. */
PROOF(set_bulge) {
    bulged_numbers n;
    for (int i = 0; i < 3; i++)
        n.corner[i] = ANY(INT16_MIN, INT16_MAX);
    FOR_PARTS(e, 0, 2) {
        set_bulge(&n, (int)e, ANY(INT16_MIN, INT16_MAX));
    }
}

/*
 * Any sum of one channel or three, ambient light that these have bits for, a surface's colours of up to 2, or none,
 * with highlights and without.
 * @alarms 3 a chroma of a sum is below 2^15, as a channel is; suite `nodes` under UBSan
 */
PROOF(glint_sum_at) {
    glint_terms terms;
    int16_t surface[3];
    int32_t sums[3], shine[3];
    terms.light = &light;
    for (int c = 0; c < 3; c++) {
        surface[c] = ANY_SHORT;
        light.chroma[c] = ANY(0, UINT16_MAX);
        sums[c] = ANY(0, INT16_MAX);
        shine[c] = ANY(0, INT16_MAX);
    }
    FOR_PARTS(kind, 0, 3) {
        terms.has_shine = (uint8_t)(kind & 1);
        light.channels = kind & 2 ? 1 : 3;
        FOR_PARTS(c, 0, 2) {
            FOR_PARTS(bits, 0, 4) {
                light.sum_bits = (unsigned)bits;
                light.ambient[c] = ANY(-(1 << 25), bits < 4 ? (1 << (27 + bits)) - 1 : 15 << 27);
                glint_sum_at(&terms, sums, shine, (int)c, surface);
                glint_sum_at(&terms, sums, shine, (int)c, 0);
            }
        }
    }
}

/* Any light, ambient light below 15 and half a level. */
PROOF(glint_finish_of) {
    glint_terms terms;
    terms.light = &light;
    terms.takes_largest = (uint8_t)ANY(0, 1);
    FOR_PARTS(c, 0, 2) {
        light.half[c] = ANY(0, 1 << 25);
        light.ambient[c] = ANY(-(1 << 25), 15 << 27);
        glint_finish_of(&terms, ANY(0, 1), (int)c);
    }
}

/*
 * Sums of 15 bits and lights' numbers, either side of 0, and what a triangle that turns by up to 2 makes of these: 4/3
 * of them; any unit, any gradients.
 * @contract glint_plane_begin
 * @narrowing numbers below 0 are shifted as they are
 * @alarms 1 what is below 0 has just been brought near the largest. Suite `nodes` under UBSan
 */
PROOF(glint_fit_plane) {
    glint_gradients g;
    FOR_PARTS(is_wide, 0, 1) {
        if (is_wide)
            any_wide(&g);
        else
            any_narrow(&g);
        FOR_PARTS(unit, 12, 16) {
            glint_quadratic q;
            int32_t n[3];
            for (int i = 0; i < 3; i++)
                n[i] = ANY(unit == 16 ? -NUMBER : 0, INT16_MAX);
            glint_fit_plane(&q, &g, n, ANY(1 << 15, (1 << 15) * 4 / 3), (unsigned)unit);
        }
    }
}
