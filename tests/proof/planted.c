/* SPDX-License-Identifier: MIT */
/* Errors planted, one bound broken in each: EVA must find them, or the check checks nothing. */
#include "proof.h"

#include "../../src/math/numeric.c"
#include "../../src/math/tables.c"
#include "contracts.h"

/* Signed overflow: |x| up to 2^63 - 1 where 2^62 is the bound. */
PLANTED(planted_overflow) {
    glint_round_shift64(ANY_LONG(0, INT64_MAX), (unsigned)ANY(1, 62));
}

/* A shift by 32. */
PLANTED(planted_shift) {
    glint_shift_right(ANY_INT, (unsigned)ANY(0, 32));
}

/* A table read before its start. */
PLANTED(planted_table_read) {
    glint_inverse_root(ANY_UNSIGNED(0x0fffffff, 0x10000000));
}

/* Division by zero. */
PLANTED(planted_division) {
    glint_reciprocal(ANY_UNSIGNED(0, 0xffffffff));
}

/* A component that was never written. */
PLANTED(planted_uninitialised) {
    int16_t a[3], b[3] = {1, 2, 3};
    a[0] = 1, a[1] = 2;
    glint_dot(a, b);
}

/* A conversion to int16 that loses bits. */
PLANTED(planted_narrowing) {
    int16_t out = (int16_t)glint_shift_right(ANY_INT, 15);
    (void)out;
}

/* A precondition broken. @contract glint_exp2 */
PLANTED(planted_precondition) {
    glint_exp2(ANY(-5, 1));
}

/* A driver that does not end. */
PLANTED(planted_endless) {
    while (1)
        ;
}
