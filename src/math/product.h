/* SPDX-License-Identifier: MIT */
/** @file product.h Computes products of more than 32 bits, on cores that have a product of 64 bits and on those that do
 * not. Both forms give the same bits. */
#ifndef GLINT_PRODUCT_H
#define GLINT_PRODUCT_H

#include "numeric.h"

/** Has the core no product of 32 x 32 to 64 bits? */
#ifndef GLINT_SPLIT_PRODUCTS
#if defined(__ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__)
#define GLINT_SPLIT_PRODUCTS 1
#else
#define GLINT_SPLIT_PRODUCTS 0
#endif
#endif

/** Computes a b of any numbers: by the core, or from products of 16 bits by 16. */
static inline int64_t glint_product_whole(int32_t a, int32_t b) {
    return (int64_t)a * b;
}

static inline int64_t glint_product_split(int32_t a, int32_t b) {
    const int32_t a0 = a & 0xffff, a1 = glint_shift_right(a, 16), b0 = b & 0xffff, b1 = glint_shift_right(b, 16);
    const uint32_t low = (uint32_t)a0 * (uint32_t)b0;
    const int32_t first = a0 * b1 + (int32_t)(low >> 16), second = a1 * b0 + (first & 0xffff);
    const int32_t high = a1 * b1 + glint_shift_right(first, 16) + glint_shift_right(second, 16);
    return (int64_t)high * ((int64_t)1 << 32) | ((uint32_t)second << 16 | (low & 0xffff));
}

/** Computes the same of numbers without a sign. */
static inline uint64_t glint_product_unsigned_whole(uint32_t a, uint32_t b) {
    return (uint64_t)a * b;
}

static inline uint64_t glint_product_unsigned_split(uint32_t a, uint32_t b) {
    const uint32_t a0 = a & 0xffff, a1 = a >> 16, b0 = b & 0xffff, b1 = b >> 16;
    const uint32_t low = a0 * b0, first = a0 * b1 + (low >> 16), second = a1 * b0 + (first & 0xffff);
    const uint32_t high = a1 * b1 + (first >> 16) + (second >> 16);
    return (uint64_t)high << 32 | second << 16 | (low & 0xffff);
}

/** Computes the high half of these products. It is short enough to be inlined. */
static inline int32_t glint_product_high_whole(int32_t a, int32_t b) {
    return (int32_t)glint_shift_right64((int64_t)a * b, 32);
}

static inline int32_t glint_product_high_split(int32_t a, int32_t b) {
    const int32_t a0 = a & 0xffff, a1 = glint_shift_right(a, 16), b0 = b & 0xffff, b1 = glint_shift_right(b, 16);
    const int32_t first = a0 * b1 + (int32_t)((uint32_t)a0 * (uint32_t)b0 >> 16), second = a1 * b0 + (first & 0xffff);
    return a1 * b1 + glint_shift_right(first, 16) + glint_shift_right(second, 16);
}

static inline uint32_t glint_product_high_unsigned_whole(uint32_t a, uint32_t b) {
    return (uint32_t)((uint64_t)a * b >> 32);
}

static inline uint32_t glint_product_high_unsigned_split(uint32_t a, uint32_t b) {
    const uint32_t a0 = a & 0xffff, a1 = a >> 16, b0 = b & 0xffff, b1 = b >> 16;
    const uint32_t first = a0 * b1 + (a0 * b0 >> 16), second = a1 * b0 + (first & 0xffff);
    return a1 * b1 + (first >> 16) + (second >> 16);
}

/** A row is three entries of a matrix, times 2. */
typedef struct glint_row_whole {
    int32_t entry[3];
} glint_row_whole;

/** A split row has entries high 2^14 + low, low from 0 to 2^14 - 1. */
typedef struct glint_row_split {
    int32_t high[3], low[3];
} glint_row_split;

static inline void glint_row_set_whole(glint_row_whole *row, int i, int32_t entry) {
    GLINT_REQUIRE(entry < 1 << 30 && entry > -(1 << 30));
    row->entry[i] = entry * 2;
}

static inline void glint_row_set_split(glint_row_split *row, int i, int32_t entry) {
    GLINT_REQUIRE(entry < 1 << 30 && entry > -(1 << 30));
    row->high[i] = glint_shift_right(entry, 14);
    row->low[i] = entry & 0x3fff;
}

static inline int32_t glint_row_get_whole(const glint_row_whole *row, int i) {
    return glint_shift_right(row->entry[i], 1);
}

static inline int32_t glint_row_get_split(const glint_row_split *row, int i) {
    return row->high[i] * (1 << 14) + row->low[i];
}

/** Computes row . (x, y, z) / 2^15 rounded to nearest, halves up, and adds t; x, y and z are int16. It is exact except
 * for rounding. Entries and t are below 2^30, and the magnitudes of the products sum up to at most 3 2^43. */
static inline int32_t glint_row_times_whole(const glint_row_whole *row, int32_t x, int32_t y, int32_t z, int32_t t) {
    GLINT_REQUIRE(t < 1 << 30 && t > -(1 << 30));
    int64_t sum = (int64_t)t * ((int64_t)1 << 32) + ((int64_t)1 << 31); /* the result is its high half */
    sum += (int64_t)row->entry[0] * (x * 65536);
    sum += (int64_t)row->entry[1] * (y * 65536);
    sum += (int64_t)row->entry[2] * (z * 65536);
    int32_t high = (int32_t)glint_shift_right64(sum, 32);
    GLINT_OPAQUE(high); /* this comes before the next row: three at once need more registers than there are */
    return high;
}

/* The products of the high parts sum up to at most 3 2^29 + 3 2^15, those of the low ones to 3 2^29. */
static inline int32_t glint_row_times_split(const glint_row_split *row, int32_t x, int32_t y, int32_t z, int32_t t) {
    const int32_t *high = row->high, *low = row->low;
    int32_t sum = glint_shift_right(low[0] * x + low[1] * y + low[2] * z, 14);
    return t + glint_shift_right(high[0] * x + high[1] * y + high[2] * z + sum + 1, 1);
}

static inline int glint_is_scalable(int32_t x, uint32_t r) {
    const uint64_t product = glint_magnitude64(x) * r;
    return glint_magnitude64(x) < 1u << 30 && r < 1u << 22 && product <= ((uint64_t)1 << 48) + (1 << 30);
}

/** Computes floor(floor(x / 2^8) r / 2^15): |x| below 2^30, r below 2^22, |x| r at most 2^48 + 2^30. */
static inline int32_t glint_scale_whole(int32_t x, uint32_t r) {
    GLINT_REQUIRE(glint_is_scalable(x, r));
    int32_t whole = x & ~0xff;
    GLINT_OPAQUE(whole); /* one product, not one for each place that x comes from */
    return (int32_t)glint_shift_right64((int64_t)whole * (int32_t)(r << 9), 32);
}

static inline int32_t glint_scale_split(int32_t x, uint32_t r) {
    GLINT_REQUIRE(glint_is_scalable(x, r));
    uint32_t low = ((uint32_t)x >> 8 & 0x3ff) * r >> 10;
    return glint_shift_right(glint_shift_right(x, 18) * (int32_t)r + (int32_t)low, 5);
}

/** Computes floor(x r / 2^n), n from 12 to 15: |x| at most 3 2^(n + 13), r from 0 to 2^16. */
static inline int32_t glint_slope_of_whole(int32_t x, int32_t r, unsigned n) {
    GLINT_REQUIRE(n - 12 <= 3 && x <= 3 << (n + 13) && x >= -(3 << (n + 13)) && r >= 0 && r <= 1 << 16);
    return (int32_t)glint_shift_right64((int64_t)x * r, n);
}

static inline int32_t glint_slope_of_split(int32_t x, int32_t r, unsigned n) {
    GLINT_REQUIRE(n - 12 <= 3 && x <= 3 << (n + 13) && x >= -(3 << (n + 13)) && r >= 0 && r <= 1 << 16);
    const uint32_t low = ((uint32_t)x & ((1u << n) - 1)) * (uint32_t)r;
    return glint_shift_right(x, n) * r + (int32_t)(low >> n);
}

/** Computes floor((a b + c d) / 2^15): b and d up to 2^15, and a sum below 2^46. */
static inline int32_t glint_sum_of_products_whole(int32_t a, int32_t b, int32_t c, int32_t d) {
    GLINT_REQUIRE(glint_magnitude64(b) <= 1 << 15 && glint_magnitude64(d) <= 1 << 15);
    return (int32_t)glint_shift_right64((int64_t)a * b + (int64_t)c * d, 15);
}

/* The products of the low parts sum up to less than 2^31. */
static inline int32_t glint_sum_of_products_split(int32_t a, int32_t b, int32_t c, int32_t d) {
    GLINT_REQUIRE(glint_magnitude64(b) <= 1 << 15 && glint_magnitude64(d) <= 1 << 15);
    return glint_shift_right(a, 15) * b + glint_shift_right(c, 15) * d +
           glint_shift_right((a & 0x7fff) * b + (c & 0x7fff) * d, 15);
}

/** Computes floor(r . (x, y, z) / 2^16) of a row of a camera's rotation, Q16, whose length is at most 1.002; x, y and z
 * are below 2^28. No sum of its products, of high or of low halves, passes 1.74 2^30. */
static inline int32_t glint_turn_whole(const int32_t r[3], int32_t x, int32_t y, int32_t z) {
    return (int32_t)glint_shift_right64((int64_t)r[0] * x + (int64_t)r[1] * y + (int64_t)r[2] * z, 16);
}

static inline int32_t glint_turn_split(const int32_t r[3], int32_t x, int32_t y, int32_t z) {
    const int32_t low = r[0] * (x & 0x3fff) + r[1] * (y & 0x3fff) + r[2] * (z & 0x3fff);
    const int32_t high =
        r[0] * glint_shift_right(x, 14) + r[1] * glint_shift_right(y, 14) + r[2] * glint_shift_right(z, 14);
    return glint_shift_right(high + glint_shift_right(low, 14), 2);
}

#if GLINT_SPLIT_PRODUCTS
#define glint_turn glint_turn_split
typedef glint_row_split glint_row;
#define glint_row_set glint_row_set_split
#define glint_row_get glint_row_get_split
#define glint_row_times glint_row_times_split
#define glint_product_high glint_product_high_split
#define glint_product_high_unsigned glint_product_high_unsigned_split
#define glint_scale glint_scale_split
#define glint_slope_of glint_slope_of_split
#define glint_sum_of_products glint_sum_of_products_split
GLINT_CONST int64_t glint_product(int32_t a, int32_t b); /* numeric.c: out of line, as they are long */
GLINT_CONST uint64_t glint_product_unsigned(uint32_t a, uint32_t b);
#else
#define glint_turn glint_turn_whole
typedef glint_row_whole glint_row;
#define glint_row_set glint_row_set_whole
#define glint_row_get glint_row_get_whole
#define glint_row_times glint_row_times_whole
#define glint_product_high glint_product_high_whole
#define glint_product_high_unsigned glint_product_high_unsigned_whole
#define glint_scale glint_scale_whole
#define glint_slope_of glint_slope_of_whole
#define glint_sum_of_products glint_sum_of_products_whole
#define glint_product glint_product_whole
#define glint_product_unsigned glint_product_unsigned_whole
#endif

/** Computes 2^48 / w for w from 2^28 to 3 2^28: the relative error is at most 3.1e-6. It squares the inverse root and
 * does one Newton step, by products of 32 bits only. */
static inline uint32_t glint_inverse(uint32_t w) {
    GLINT_REQUIRE(w >= 1u << 28 && w <= 3u << 28);
    uint32_t root = (uint32_t)glint_inverse_root(w << 2);
    uint32_t r = root * root >> 10;               /* too small by 1.3e-4 to 3.6e-4 */
    int32_t error = (int32_t)(0u - (w >> 6) * r); /* 2^42 (1 - w r / 2^48): below 2^31 */
    return r + (uint32_t)glint_shift_right((int32_t)(r >> 7) * glint_shift_right(error, 15), 20);
}

#endif
