/* SPDX-License-Identifier: MIT */
/** @file division.h Divides small numbers, by the core where it divides in hardware, otherwise by a table. Either way
 * the pixels are the same. */
#ifndef GLINT_DIVISION_H
#define GLINT_DIVISION_H

#include "numeric.h"

/** Does the core divide in hardware? */
#ifndef GLINT_DIVIDES
#if (defined(__arm__) && !defined(__ARM_FEATURE_IDIV)) || (defined(__riscv) && !defined(__riscv_div))
#define GLINT_DIVIDES 0
#else
#define GLINT_DIVIDES 1
#endif
#endif

/** These are 2^20 / i, i from 16 to 256, to the nearest; 65535 for 16. */
extern const uint16_t glint_quotient_table[241];

/** Returns the entry of i. It counts bytes, so that compilers take the 16 off the table's address. */
static inline int32_t glint_quotient(int32_t i) {
    GLINT_REQUIRE(i >= 16 && i <= 256);
    return *(const uint16_t *)(const void *)((const uint8_t *)glint_quotient_table + (2 * i - 32));
}

/* ---- 2^31 / x to the nearest, halves up, for x from 2^15 to 2^16 ---- */

static inline int32_t glint_reciprocal16_by_division(uint32_t x) {
    return (int32_t)((0x80000000u + x / 2) / x);
}

/** Does one Newton step from a table's value, and adds what is missing. */
static inline int32_t glint_reciprocal16_by_table(uint32_t x) {
    const int32_t start = glint_quotient((int32_t)((x + 128) >> 8)); /* 2^28 / x */
    const int32_t error = (int32_t)(0x80000000u - (uint32_t)start * 8 * x);
    uint32_t result = (uint32_t)(start * 8 + glint_shift_right(glint_shift_right(error, 10) * start, 18));
    for (uint32_t rest = 0x80000000u + x / 2 - result * x; rest >= x; rest -= x)
        result++;
    return (int32_t)result;
}

static inline int32_t glint_reciprocal16(uint32_t x) {
    GLINT_REQUIRE(x >= 1u << 15 && x <= 1u << 16);
    return GLINT_DIVIDES ? glint_reciprocal16_by_division(x) : glint_reciprocal16_by_table(x);
}

/* ---- Short edges ---- */
/*
 * A short edge spans |dx| < GLINT_EDGE_DX and 0 < dy < GLINT_EDGE_DY sixteenths of a pixel. Its crossing with a row,
 * Q20, is less than GLINT_EDGE_ERROR steps off. The exact crossings are multiples of 1 / (16 dy) pixels, of which
 * GLINT_EDGE_ERROR is at most half, so that the first column at or right of a crossing is exact: the larger errors of a
 * table and the smaller ones of a division give the same pixels.
 */

#define GLINT_EDGE_DX 2048
#define GLINT_EDGE_DY 512
#define GLINT_EDGE_ERROR 64

/** With this added to a crossing, its whole part is the first column at or right of it. */
#define GLINT_EDGE_CEILING ((1 << 20) - GLINT_EDGE_ERROR)

/** Computes dx / dy, Q20, rounded towards 0. The low 16 bits of dx count. */
static inline int32_t glint_slope_by_division(int32_t dx, int32_t dy) {
    GLINT_REQUIRE(dy >= 1 && dy < GLINT_EDGE_DY);
    return glint_shift_left(dx, 20) / dy;
}

/** Computes the same with a larger error, below that of a short edge. */
static inline int32_t glint_slope_by_table(int32_t dx, int32_t dy) {
    GLINT_REQUIRE(dy >= 1 && dy < GLINT_EDGE_DY);
    dx = (int16_t)dx;
    if (dy < 16) {
        dx = dx * 16;
        dy = dy * 16;
    }
    const int32_t inverse =
        dy < 256 ? glint_quotient(dy) : (glint_quotient(dy / 2) + glint_quotient((dy + 1) / 2) + 2) / 4;
    const int32_t slope = dx * inverse;
    /* The rest of dx 2^20 is far below 2^31, whatever the two parts are. */
    const int32_t rest = (int32_t)(((uint32_t)dx << 20) - (uint32_t)slope * (uint32_t)dy);
    return slope + glint_shift_right(glint_shift_right(rest, 6) * inverse, 14);
}

#if GLINT_DIVIDES
#define glint_slope glint_slope_by_division
#else
GLINT_CONST int32_t glint_slope(int32_t dx, int32_t dy); /* numeric.c: out of line, as it is long */
#endif

/** Returns the change of x from an edge's top to the first row of centres, `down` sixteenths below, from 0 to 15. */
static inline int32_t glint_edge_start(int32_t slope, int32_t down) {
    GLINT_REQUIRE(down >= 0 && down <= 15);
    return glint_shift_right(slope, 4) * down;
}

#endif
