/* SPDX-License-Identifier: MIT */
/* Contracts by which callees may stand in a caller's proof. */
#include "../../src/numeric.h"

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
