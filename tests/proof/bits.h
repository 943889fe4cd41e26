/* SPDX-License-Identifier: MIT */
/**
 * @file bits.h
 * The contract of glint_bits64, for drivers in which a number of bits is that of a range across a power of two.
 */
#ifndef GLINT_BITS_H
#define GLINT_BITS_H

#include "../../src/math/numeric.h"

/* x takes at most n bits if it is below 2^n, and at least n from 2^(n - 1) on. */
#define TAKES(n) ((x >= (1 << (n)) || \result <= (n)) && (x < (1 << ((n)-1)) || \result >= (n)))
#define TAKES_8(n)                                                                                               \
    (TAKES(n) && TAKES(n + 1) && TAKES(n + 2) && TAKES(n + 3) && TAKES(n + 4) && TAKES(n + 5) && TAKES(n + 6) && \
     TAKES(n + 7))

/*@ assigns \result \from x;
    ensures 0 <= \result <= 64;
    ensures TAKES_8(1) && TAKES_8(9) && TAKES_8(17) && TAKES_8(25);
    ensures TAKES_8(33) && TAKES_8(41) && TAKES_8(49) && TAKES_8(57); */
static inline unsigned glint_bits64(uint64_t x);

#endif
