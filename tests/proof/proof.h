/* SPDX-License-Identifier: MIT */
/**
 * @file proof.h
 * Drivers for Frama-C EVA: PROOF(kernel) calls a kernel with inputs that range over all that its contract allows.
 *
 * The comment above a driver is its row in the page that prove.py writes: the kernel's domain, in one sentence. It may
 * go on with lines of words for prove.py:
 * - `@contract f g`: these callees stand as their contracts below, which drivers of their own prove of their bodies
 *   or that page lists; their preconditions are proven here.
 * - `@narrowing reason`: conversions to narrower signed types are no alarms here.
 * - `@alarms n reason`: so many alarms are expected, which a relation rules out; the test that stands in.
 * - `@unreached n reason`: so many statements no input reaches.
 * - `@unsigned`: unsigned sums and products must not wrap either.
 * - `@options`: for Frama-C.
 * A comment `Not proven: f, g: reason` lists kernels without a driver, what keeps them in bounds, and the test.
 * A domain cut into parts by a loop, FOR_PARTS, is proven part by part: EVA keeps ranges, not relations.
 */
#ifndef GLINT_PROOF_H
#define GLINT_PROOF_H

#include "__fc_builtin.h"

#include <limits.h>
#include <stdint.h>

/* EVA prints the last call where it is reached: a driver that does not end proves nothing. */
#define PROOF(kernel)                          \
    void Frama_C_show_each_end_##kernel(void); \
    static void body_##kernel(void);           \
    void prove_##kernel(void) {                \
        body_##kernel();                       \
        Frama_C_show_each_end_##kernel();      \
    }                                          \
    static void body_##kernel(void)

/* A driver that must not pass: it breaks one bound. */
#define PLANTED(name) PROOF(name)

/* Every i from first to last, each a part of the domain that is proven by itself. */
#define FOR_PARTS(i, first, last) for (int i = (first); i <= (last); i++)

/* Any value from least to most. */
#define ANY(least, most) Frama_C_interval(least, most)
#define ANY_UNSIGNED(least, most) Frama_C_unsigned_int_interval(least, most)
#define ANY_LONG(least, most) Frama_C_long_long_interval(least, most)
#define ANY_INT ANY(INT32_MIN, INT32_MAX)
#define ANY_SHORT ((int16_t)ANY(INT16_MIN, INT16_MAX))

/* Any number of exactly so many bits, 1 to 32; 0 for 0. */
#define ANY_OF_BITS(bits) ((bits) ? ANY_UNSIGNED(1u << ((bits)-1), 0xffffffffu >> (32 - (bits))) : 0u)

/* What the compiler's built-in does, for EVA: exact for numbers of one bit length. */
static int leading_zeros_model(unsigned x) {
    int n = 0;
    for (; n < 31 && x < 0x80000000u >> n; n++)
        ;
    return n;
}
#define __builtin_clz leading_zeros_model

/* An asm that does nothing: EVA would take it to change x. */
#include "../../src/math/numeric.h"
#undef GLINT_OPAQUE
#define GLINT_OPAQUE(x) ((void)0)

#endif
