/* SPDX-License-Identifier: MIT */
/* The scalars of numeric.h. */
#include "proof.h"

#include "../../src/math/numeric.c"
#include "../../src/math/tables.c"
#include "bits.h"
#include "contracts.h"

/* n from 0 to 31, any x. */
PROOF(glint_shift_right) {
    glint_shift_right(ANY_INT, (unsigned)ANY(0, 31));
}

/* Any x, by its bits. */
PROOF(glint_bits64) {
    glint_bits64(0);
    FOR_PARTS(bits, 1, 64) {
        const uint64_t least = (uint64_t)1 << (bits - 1), most = 2 * (least - 1) + 1;
        glint_bits64((uint64_t)Frama_C_unsigned_long_long_interval(least, most));
    }
}

/* Any number, by its bits. @options -eva-slevel 0 -eva-min-loop-unroll 64 */
PROOF(glint_square_root) {
    glint_square_root(0);
    FOR_PARTS(bits, 1, 63) {
        glint_square_root(Frama_C_unsigned_long_long_interval(1ull << (bits - 1), (1ull << (bits - 1)) * 2 - 1));
    }
    glint_square_root(Frama_C_unsigned_long_long_interval(1ull << 63, UINT64_MAX));
}

/* Any x, by its bytes. */
PROOF(glint_leading_zeros_by_table) {
    glint_leading_zeros_by_table(ANY_UNSIGNED(0, 0xff));
    glint_leading_zeros_by_table(ANY_UNSIGNED(1u << 8, (1u << 16) - 1));
    glint_leading_zeros_by_table(ANY_UNSIGNED(1u << 16, (1u << 24) - 1));
    glint_leading_zeros_by_table(ANY_UNSIGNED(1u << 24, UINT_MAX));
}

/* n from 1 to 62, |x| at most 2^62. */
PROOF(glint_round_shift64) {
    const int64_t most = (int64_t)1 << 62;
    glint_round_shift64(ANY_LONG(-most, most), (unsigned)ANY(1, 62));
}

/* c from 2^28 to 3 2^30, in the 352 intervals of the table. */
PROOF(glint_inverse_root) {
    FOR_PARTS(i, 32, 384) {
        uint32_t start = (uint32_t)i << 23;
        glint_inverse_root(ANY_UNSIGNED(start, i < 384 ? start + 0x7fffff : start));
    }
}

/* x from 2^31 to 2^32 - 1. */
PROOF(glint_reciprocal) {
    FOR_PARTS(high, 0x80, 0xff) {
        glint_reciprocal(ANY_UNSIGNED((uint32_t)high << 24, ((uint32_t)high << 24) + 0xffffff));
    }
}

/* x from 0 to 2^31, by its bits and the interval of the table. @unreached 1 leading zeros of 0 */
PROOF(glint_log2) {
    FOR_PARTS(x, 0, 31) {
        glint_log2((uint32_t)x);
    }
    FOR_PARTS(bits, 0, 25) {
        FOR_PARTS(i, 32, 63) {
            glint_log2(ANY_UNSIGNED((uint32_t)i << bits, (((uint32_t)i + 1) << bits) - 1));
        }
    }
    glint_log2(1u << 31);
}

/* y from -2^31 to 0. */
PROOF(glint_exp2) {
    FOR_PARTS(i, -64, -1) {
        glint_exp2(ANY(i * (1 << 25), i * (1 << 25) + (1 << 25) - 1));
    }
    glint_exp2(0);
}

/* x from 0 to 2^31, p from 0 to 2^31 - 1. @contract glint_log2 glint_exp2 */
PROOF(glint_power) {
    glint_power(ANY_UNSIGNED(0, 1u << 31), ANY(0, INT32_MAX));
}

/* Any phase. */
PROOF(glint_sine) {
    glint_sine(ANY_UNSIGNED(0, UINT_MAX));
}

/* Any angle. */
PROOF(glint_phase) {
    glint_phase(ANY_INT);
}

/* A number of as many bits or fewer, and one of exactly so many, as glint_magnitude_bits counts; below 0 or not. */
static int32_t any_below(int bits, int negative) {
    const int32_t magnitude = (int32_t)ANY_UNSIGNED(0, (1u << bits) - 1);
    return negative ? -1 - magnitude : magnitude;
}

static int32_t any_of(int bits, int negative) {
    const int32_t magnitude = (int32_t)ANY_OF_BITS(bits);
    return negative ? -1 - magnitude : magnitude;
}

/*
 * Any x, y, z, by the largest one's bits and by signs. @contract glint_inverse_root
 * @narrowing |x| <= sqrt(c), so |x| r is at most UNIT 2^15 (1 + 5.5e-5): 32766.3 (whole domain of glint_inverse_root)
 * @options -eva-subdivide-non-linear 40
 */
PROOF(glint_unit) {
    int16_t out[3];
    FOR_PARTS(bits, 0, 31) {
        FOR_PARTS(signs, 0, 7) {
            const int a = signs & 1, b = signs >> 1 & 1, c = signs >> 2;
            glint_unit(any_of(bits, a), any_below(bits, b), any_below(bits, c), out);
            glint_unit(any_below(bits, a), any_of(bits, b), any_below(bits, c), out);
            glint_unit(any_below(bits, a), any_below(bits, b), any_of(bits, c), out);
        }
    }
}
