/* SPDX-License-Identifier: MIT */
/* Products of more than 32 bits, in both forms, and small divisions, in both forms. */
#include "proof.h"

#include "../../src/math/product.h"
#include "../../src/math/tables.c"
#include "contracts.h"

/* Entries of a row: magnitudes sum up to 12 of these, 3 2^28. */
#define UNIT_OF_SUM (1 << 26)

static int32_t any_entry(int units) {
    return ANY(-units * UNIT_OF_SUM, units * UNIT_OF_SUM);
}

/* Any numbers, in both forms. */
PROOF(glint_product_itself) {
    glint_product_whole(ANY_INT, ANY_INT);
    glint_product_split(ANY_INT, ANY_INT);
    glint_product_unsigned_whole(ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX));
    glint_product_unsigned_split(ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX));
    glint_product_high_whole(ANY_INT, ANY_INT);
    glint_product_high_split(ANY_INT, ANY_INT);
    glint_product_high_unsigned_whole(ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX));
    glint_product_high_unsigned_split(ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX));
}

/* Entries below 2^30. */
PROOF(glint_row_set) {
    const int32_t most = (1 << 30) - 1;
    glint_row_whole whole;
    glint_row_split split;
    glint_row_set_whole(&whole, ANY(0, 2), ANY(-most, most));
    glint_row_set_split(&split, ANY(0, 2), ANY(-most, most));
}

/* Entries below 2^30. */
PROOF(glint_row_get) {
    const int32_t most = (1 << 30) - 1;
    glint_row_whole whole;
    glint_row_split split;
    for (int i = 0; i < 3; i++) {
        whole.entry[i] = ANY(-most, most) * 2;
        split.high[i] = ANY(-(1 << 16), (1 << 16) - 1);
        split.low[i] = ANY(0, 0x3fff);
    }
    glint_row_get_whole(&whole, ANY(0, 2));
    glint_row_get_split(&split, ANY(0, 2));
}

/* Any x, y, z of 16 bits; entries whose magnitudes sum up to 3 2^28, by parts of that sum; t below 2^30. Both forms. */
PROOF(glint_row_times_itself) {
    const int32_t most = (1 << 30) - 1;
    FOR_PARTS(a, 1, 12) {
        FOR_PARTS(b, 1, 13 - a) {
            glint_row_whole whole;
            glint_row_split split;
            const int32_t entry[3] = {any_entry((int)a), any_entry((int)b), any_entry(14 - (int)a - (int)b)};
            for (int i = 0; i < 3; i++) {
                glint_row_set_whole(&whole, i, entry[i]);
                glint_row_set_split(&split, i, entry[i]);
            }
            glint_row_times_whole(&whole, ANY_SHORT, ANY_SHORT, ANY_SHORT, ANY(-most, most));
            glint_row_times_split(&split, ANY_SHORT, ANY_SHORT, ANY_SHORT, ANY(-most, most));
        }
    }
}

/* r from 0 to 2^22 - 1, |x| below 2^30 and at most (2^48 + 2^30) / r, by parts of r. Both forms. */
PROOF(glint_scale_itself) {
    const int32_t most = (1 << 30) - 1;
    glint_scale_whole(ANY(-most, most), ANY_UNSIGNED(0, 1u << 18));
    FOR_PARTS(eighth, 8, 15) {
        FOR_PARTS(bits, 15, 18) {
            const uint32_t r = (uint32_t)eighth << bits, last = r + (1u << bits) - 1;
            const int64_t quotient = (((int64_t)1 << 48) + (1 << 30)) / r;
            const int32_t x = quotient < most ? (int32_t)quotient : most;
            glint_scale_whole(ANY(-x, x), ANY_UNSIGNED(r, last));
            glint_scale_split(ANY(-x, x), ANY_UNSIGNED(r, last));
        }
    }
    glint_scale_split(ANY(-most, most), ANY_UNSIGNED(0, (1u << 18) - 1));
}

/* |x| at most 3 2^(n + 13), r up to 2^16, n from 12 to 15. Both forms. */
PROOF(glint_slope_of_itself) {
    FOR_PARTS(n, 12, 15) {
        const int32_t most = 3 << (n + 13);
        glint_slope_of_whole(ANY(-most, most), ANY(0, 1 << 16), (unsigned)n);
        glint_slope_of_split(ANY(-most, most), ANY(0, 1 << 16), (unsigned)n);
    }
}

/* a and c up to 30240 2^15, b and d up to 2^15. Both forms. */
PROOF(glint_sum_of_products_itself) {
    const int32_t most = 30240 << 15, last = 1 << 15;
    glint_sum_of_products_whole(ANY(-most, most), ANY(-last, last), ANY(-most, most), ANY(-last, last));
    glint_sum_of_products_split(ANY(-most, most), ANY(-last, last), ANY(-most, most), ANY(-last, last));
}

/*
 * w from 2^28 to 3 2^28, in the 256 intervals of the table.
 * @narrowing the Newton step's error is below 2^31: r falls short by at most 3.6e-4; `make domains` takes every w
 */
PROOF(glint_inverse) {
    FOR_PARTS(i, 128, 384) {
        const uint32_t start = (uint32_t)i << 21;
        glint_inverse(ANY_UNSIGNED(start, i < 384 ? start + 0x1fffff : start));
    }
}

/*@ requires 0x8000 <= x <= 0x10000;
    assigns \result \from x;
    ensures 0x8000 <= \result <= 0x10000; */
static inline int32_t glint_reciprocal16_by_division(uint32_t x);

/* Stands on `numbers`, which takes every x, under UBSan too: how often the remainder is made good is a relation. */
/*@ requires 0x8000 <= x <= 0x10000;
    assigns \result \from x;
    admit ensures 0x8000 <= \result <= 0x10000; */
static inline int32_t glint_reciprocal16_by_table(uint32_t x);

/* Stands on `numbers`, which takes every dx and dy, under UBSan too: what is left of dx 2^20 is a relation. */
/*@ requires 1 <= dy <= 511;
    assigns \result \from dx, dy; */
static inline int32_t glint_slope_by_table(int32_t dx, int32_t dy);

/* x from 2^15 to 2^16, by parts. */
PROOF(glint_reciprocal16_by_division) {
    FOR_PARTS(i, 32, 63) {
        glint_reciprocal16_by_division(ANY_UNSIGNED(1024u * (uint32_t)i, 1024u * (uint32_t)i + 1024));
    }
}

/* Any dx, dy from 1 to 511. @narrowing dx is the low half, as a number with a sign */
PROOF(glint_slope_by_division) {
    glint_slope_by_division(ANY_INT, ANY(1, GLINT_EDGE_DY - 1));
}

/* Slopes of short edges, below 2^31 / 1. From anywhere in a row of pixels. */
PROOF(glint_edge_start) {
    glint_edge_start(ANY_INT, ANY(0, 15));
}
