/* SPDX-License-Identifier: MIT */
/*
 * Contracts by which callees stand in a caller's proof. Each is proven of the callee's body by a driver of its name;
 * what is admitted instead says what it stands on. Those of static functions are beside their drivers.
 */
#ifndef GLINT_CONTRACTS_H
#define GLINT_CONTRACTS_H

#include "../../src/frame.h"

/* A component of a unit vector: up to 32764 + 2.3. a . b of two: up to (32764 + 2.3)^2. */
#define ANY_COMPONENT ((int16_t)ANY(-32767, 32767))
#define COSINE_MOST 1073630461

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
    ensures -0x80000000 <= \result <= 0; */
int32_t glint_log2(uint32_t x);

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

/* Stands on |x| <= |(x, y, z)|, so that rounding leaves at most 32764 + 2.3: `numbers` tries 3 million vectors. */
/*@ requires \valid(out + (0 .. 2));
    assigns out[0 .. 2] \from x, y, z;
    admit ensures -32767 <= out[0] <= 32767 && -32767 <= out[1] <= 32767 && -32767 <= out[2] <= 32767; */
void glint_unit(int32_t x, int32_t y, int32_t z, int16_t out[3]);

/* Stands on |a . b| <= |a| |b| (Cauchy, 1821) of unit vectors, at most 32764 + 2.3 long. */
/*@ requires \valid_read(a + (0 .. 2)) && \valid_read(b + (0 .. 2));
    assigns \result \from a[0 .. 2], b[0 .. 2];
    admit ensures -1073630461 <= \result <= 1073630461; */
static inline int32_t glint_dot(const int16_t a[3], const int16_t b[3]);

#endif
