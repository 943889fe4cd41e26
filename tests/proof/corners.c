/* SPDX-License-Identifier: MIT */
/* What corners tell. */
#include "proof.h"

#include "../../src/math/tables.c"
#include "../../src/nodes/corners.c"
#include "lit.h"

/*
 * Not proven: glint_find_region, find_lobes, find_lobe_range, find_corners_nearness, glint_reach_of: they walk corners
 * and lights, whose numbers are where place_numbers puts them, and call what is proven. Suites `nodes` and `identity`
 * under ASan and UBSan, and fuzzing.
 */

/* A triangle that is not deep: its corners' 1/w with the largest at 15 bits. */
#define LEAST_W 32

static glint_vertex vertices[3];
static glint_triangle triangle;
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

/*
 * Colours from 0 to 1, 1/w of 15 bits.
 * @alarms 1 a weighted mean is no more than the larger; suite `nodes` under UBSan
 */
PROOF(between) {
    between(ANY(1, 32768), ANY(1, 32768), ANY(LEAST_W, INT16_MAX), ANY(LEAST_W, INT16_MAX));
}

/*
 * Any corners, by the bits of the largest 1/w. @contract glint_root_above glint_region_measure glint_find_longest
 * @unreached 1 a number of no bits
 */
PROOF(measure) {
    FOR_CORNERS(bits) {
        measure(ANY_UNSIGNED(1 << 10, 1u << 31), &triangle, &t);
    }
}

/* Any corners on the guard band. @contract glint_root_above */
PROOF(glint_find_longest) {
    const glint_vertex *const corners[3] = {&vertices[0], &vertices[1], &vertices[2]};
    for (int i = 0; i < 3; i++) {
        vertices[i].x = (int16_t)ANY(0, 32735);
        vertices[i].y = (int16_t)ANY(0, 32735);
    }
    glint_find_longest(corners);
}

/*@ requires \valid_read(w) && \valid(region);
    assigns region->slant, region->reach \from pixel, longest, *w;
    ensures \initialized(&region->reach) && region->reach <= 0x4000; */
void glint_region_measure(uint32_t pixel, uint32_t longest, const glint_w_range *w, glint_region *region);

/*@ assigns \result \from square;
    ensures \result <= 0x40000; */
uint32_t glint_root_above(uint32_t square);

/*
 * Any corners, by the bits of the largest 1/w. @contract between
 * @unreached 3 leading zeros of 0, and a number of no bits
 */
PROOF(find_surface) {
    FOR_CORNERS(bits) {
        find_surface(&triangle, &t);
    }
}

/*@ requires 0 <= a <= 32768 && 0 <= b <= 32768;
    assigns \result \from a, b, wa, wb; */
static int16_t between(int32_t a, int32_t b, int32_t wa, int32_t wb);

/*@ requires \valid_read(corners + (0 .. 2));
    assigns \result \from indirect: corners[0 .. 2];
    ensures \result <= 0x40000; */
uint32_t glint_find_longest(const glint_vertex *const *corners);
