/* SPDX-License-Identifier: MIT */
/*
 * Contracts by which callees stand in a caller's proof. Each is proven of the callee's body by a driver of its name;
 * what is admitted instead says what it stands on. Those of static functions are beside their drivers.
 */
#ifndef GLINT_CONTRACTS_H
#define GLINT_CONTRACTS_H

#include "../../src/glint.h"
#include "../../src/math/division.h"
#include "../../src/math/product.h"
#include "proof.h"

/*@ requires 0x10000000 <= c <= 0xC0000000;
    assigns \result \from c;
    ensures 18892 <= \result <= 65525; */
static inline int32_t glint_inverse_root(uint32_t c);

/*@ requires x >= 0x80000000;
    assigns \result \from x;
    ensures 0x7e000000 <= \result <= 0xffffffff; */
uint32_t glint_reciprocal(uint32_t x);

/*@ requires x <= 0x80000000;
    assigns \result \from x;
    ensures -0x80000000 <= \result <= 0;
    ensures x < 1 || \result >= -0x7c100000;
    ensures x < 0x40000 || \result >= -0x34100000;
    ensures x > 0x40000 || \result <= -0x33c00000; */
int32_t glint_log2(uint32_t x);

/* A root of 2n bits has n; by its first bit. */
#define ROOT(n) \
    ((x >= ((uint64_t)1 << 2 * (n)) || \result < (1 << (n))) && (x < ((uint64_t)1 << 2 * (n)) || \result >= (1 << (n))))

/*@ assigns \result \from x;
    ensures ROOT(1) && ROOT(2) && ROOT(3) && ROOT(4) && ROOT(5) && ROOT(6) && ROOT(7) && ROOT(8);
    ensures ROOT(9) && ROOT(10) && ROOT(11) && ROOT(12) && ROOT(13) && ROOT(14) && ROOT(15) && ROOT(16);
    ensures ROOT(17) && ROOT(18) && ROOT(19) && ROOT(20) && ROOT(21) && ROOT(22) && ROOT(23) && ROOT(24);
    ensures ROOT(25) && ROOT(26) && ROOT(27) && ROOT(28) && ROOT(29) && ROOT(30) && ROOT(31); */
uint32_t glint_square_root(uint64_t x);

/*@ requires y <= 0;
    assigns \result \from y;
    ensures \result <= 0x40000000; */
uint32_t glint_exp2(int32_t y);

/*@ requires x <= 0x80000000;
    requires p >= 0;
    assigns \result \from x, p;
    ensures \result <= 0x40000000; */
uint32_t glint_power(uint32_t x, int32_t p);

/* Stands on `numbers`, which takes every phase at which the sine is no further from 1 than its error. */
/*@ assigns \result \from phase;
    admit ensures -0x40000000 <= \result <= 0x40000000; */
int32_t glint_sine(uint32_t phase);

/*@ assigns \result \from degrees; */
uint32_t glint_phase(int32_t degrees);

/*@ assigns \result \from degrees;
    ensures -65536 <= \result <= 65536; */
glint_q16 glint_sin(glint_q16 degrees);

/*@ assigns \result \from degrees;
    ensures -65536 <= \result <= 65536; */
glint_q16 glint_cos(glint_q16 degrees);

/* Stands on |x| <= |(x, y, z)|, so that rounding leaves at most 32764 + 2.3, and on rounding, which
 * turns no sign: `numbers` tries 3 million vectors. */
/*@ requires \valid(out + (0 .. 2));
    assigns out[0 .. 2] \from x, y, z;
    ensures \initialized(out + (0 .. 2));
    admit ensures -32767 <= out[0] <= 32767 && -32767 <= out[1] <= 32767 && -32767 <= out[2] <= 32767;
    admit ensures z < 0 || out[2] >= 0; */
void glint_unit(int32_t x, int32_t y, int32_t z, int16_t out[3]);

/* Stands on the same: glint_unit is this. */
/*@ requires \valid(out + (0 .. 2));
    assigns out[0 .. 2] \from x, y, z;
    ensures \initialized(out + (0 .. 2));
    admit ensures -32767 <= out[0] <= 32767 && -32767 <= out[1] <= 32767 && -32767 <= out[2] <= 32767; */
static inline void glint_unit_inline(int32_t x, int32_t y, int32_t z, int16_t out[3]);

/* Stands on |a . b| <= |a| |b| (Cauchy, 1821) of unit vectors, at most 32764 + 2.3 long, or 2^15 as a vertex's normal.
 */
/*@ requires \valid_read(a + (0 .. 2)) && \valid_read(b + (0 .. 2));
    assigns \result \from indirect: a[0 .. 2], indirect: b[0 .. 2];
    admit ensures -0x3fff8000 <= \result <= 0x3fff8000; */
static inline int32_t glint_dot(const int16_t a[3], const int16_t b[3]);

/* Stands on an error of at most 3.1e-6, 3.3 steps: `make domains` takes every w. */
/*@ requires 0x10000000 <= w <= 0x30000000;
    assigns \result \from w;
    admit ensures 0x1000000000000 / w - 4 <= \result <= 0x1000000000000 / w + 4; */
static inline uint32_t glint_inverse(uint32_t w);

/* Stands on the magnitudes of a row and its translation, which sum up to less than 3 2^28: `numbers` tries 3 million
 * rows. */
/*@ requires \valid_read(row);
    requires -0x8000 <= x <= 0x7fff && -0x8000 <= y <= 0x7fff && -0x8000 <= z <= 0x7fff;
    requires -0x40000000 < t < 0x40000000;
    assigns \result \from *row, x, y, z, t;
    admit ensures -0x30000000 <= \result <= 0x30000000; */
static inline int32_t glint_row_times_whole(const glint_row_whole *row, int32_t x, int32_t y, int32_t z, int32_t t);

#endif
