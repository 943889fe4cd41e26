/* SPDX-License-Identifier: MIT */
#include "numeric.h"

#include "division.h"
#include "product.h"

#if GLINT_SPLIT_PRODUCTS
int64_t glint_product(int32_t a, int32_t b) {
    return glint_product_split(a, b);
}

uint64_t glint_product_unsigned(uint32_t a, uint32_t b) {
    return glint_product_unsigned_split(a, b);
}
#endif

#if !GLINT_DIVIDES
int32_t glint_slope(int32_t dx, int32_t dy) {
    return glint_slope_by_table(dx, dy);
}
#endif

/* The table counts the leading zeros of 8 bits. */
#define TWO(n) n, n
#define EIGHT(n) TWO(n), TWO(n), TWO(n), TWO(n)
#define ALL_32(n) EIGHT(n), EIGHT(n), EIGHT(n), EIGHT(n)
static const uint8_t zeros_of_8[256] = {
    8,         7,         TWO(6),    TWO(5),    TWO(5),    EIGHT(4),  EIGHT(3),  EIGHT(3),
    ALL_32(2), ALL_32(1), ALL_32(1), ALL_32(0), ALL_32(0), ALL_32(0), ALL_32(0),
};

unsigned glint_leading_zeros_by_table(uint32_t x) {
    if (x >> 16)
        return x >> 24 ? zeros_of_8[x >> 24] : 8u + zeros_of_8[x >> 16];
    return x >> 8 ? 16u + zeros_of_8[x >> 8] : 24u + zeros_of_8[x];
}

void glint_unit(int32_t x, int32_t y, int32_t z, int16_t out[3]) {
    glint_unit_inline(x, y, z, out);
}

uint32_t glint_reciprocal(uint32_t x) {
    GLINT_REQUIRE(x >= 1u << 31);
    uint32_t start = (0xffffffffu / (x >> 16)) << 15; /* off by 2^-15, never too low by more than 2^-16 */
    /* This is 2^31 (1 - x start / 2^63), rounded down. */
    int64_t error = ((int64_t)1 << 31) - (int64_t)(((uint64_t)x * start + 0xffffffffu) >> 32);
    int64_t result = (int64_t)start + glint_shift_right64((int64_t)start * error, 31);
    return result > 0xffffffffLL ? 0xffffffffu : (uint32_t)result;
}

/* Computes x / 3, x from 0 to 2^16 - 1. */
static uint32_t third(uint32_t x) {
    GLINT_REQUIRE(x <= 0xffff);
    return x * 43691 >> 17;
}

/* Computes ln(1 + r), r and result Q31, |r| up to 2^-6, by three terms of the series. The error is below 1.5e-8. */
static int32_t natural_logarithm(int32_t r) {
    const int32_t square = (int32_t)glint_shift_right64(glint_product(r, r), 31);
    const int32_t cube = (int32_t)glint_shift_right64(glint_product(square, r), 31);
    return r - square / 2 + (cube < 0 ? -(int32_t)third(0u - (uint32_t)cube) : (int32_t)third((uint32_t)cube));
}

int32_t glint_log2(uint32_t x) {
    GLINT_REQUIRE(x <= 1u << 31);
    if (x == 0)
        return -32 * (1 << 26);
    unsigned zeros = glint_leading_zeros(x);
    uint32_t mantissa = x << zeros; /* Q31, 1 to 2 */
    unsigned i = (mantissa >> 26) & 31;
    const uint64_t ratio = glint_product_unsigned(mantissa, glint_log2_inverse_table[i]) >> 31;
    const int32_t r = (int32_t)((int64_t)ratio - ((int64_t)1 << 31));
    int64_t tail = glint_shift_right64(glint_product(natural_logarithm(r), 1549082005), 30); /* log2(e), Q30 */
    int32_t fraction = (int32_t)glint_round_shift64((int64_t)glint_log2_table[i] + tail, 5);
    int32_t logarithm = fraction - (int32_t)zeros * (1 << 26);
    return logarithm < 0 ? logarithm : 0; /* rounding may pass 0, which large exponents would show */
}

uint32_t glint_exp2(int32_t y) {
    GLINT_REQUIRE(y <= 0);
    uint32_t down = 0u - (uint32_t)y;
    unsigned whole = (down + (1u << 26) - 1) >> 26;
    if (whole > 30)
        return 0;
    uint32_t fraction = (uint32_t)y & ((1u << 26) - 1);
    const uint32_t r = (uint32_t)(glint_product_unsigned(fraction & 0x1fffff, 1488522236) >> 27); /* ln 2, to Q30 */
    const uint32_t square = (uint32_t)(glint_product_unsigned(r, r) >> 31);                       /* r^2 / 2 */
    const uint32_t series = (1u << 30) + r + square + third((uint32_t)(glint_product_unsigned(square, r) >> 30));
    uint64_t power = glint_product_unsigned(series, glint_exp2_table[fraction >> 21]) >> 30;
    return whole ? (uint32_t)((power + (1u << (whole - 1))) >> whole) : (uint32_t)power;
}

uint32_t glint_power(uint32_t x, int32_t p) {
    GLINT_REQUIRE(x <= 1u << 31 && p >= 0);
    if (p == 0)
        return 1u << 30;
    if (x == 0)
        return 0;
    int64_t y = glint_shift_right64(glint_product(glint_log2(x), p), 16);
    return y < -31 * (int64_t)(1 << 26) ? 0 : glint_exp2((int32_t)y);
}

uint32_t glint_phase(int32_t degrees) {
    int32_t rest = degrees % (360 * 65536);
    return (uint32_t)(uint64_t)glint_shift_right64((int64_t)rest * 3054198966LL + (1 << 23), 24); /* 2^40 / 360 */
}

int32_t glint_sine(uint32_t phase) {
    uint32_t quarter = phase & 0x7fffffffu;
    if (quarter > 0x40000000u)
        quarter = 0x80000000u - quarter;
    int64_t t = quarter; /* Q30: 1 is a quarter turn */
    int64_t square = (t * t) >> 30;
    static const int64_t odd[6] = {1686629713, -693598668, 85569306, -5026995, 172272, -3864}; /* (pi/2)^n / n! */
    int64_t sum = odd[5];
    for (int i = 4; i >= 0; i--)
        sum = odd[i] + glint_shift_right64(sum * square, 30);
    int64_t sine = (sum * t + (1 << 29)) >> 30;
    return (int32_t)(phase >> 31 ? -sine : sine);
}

/* Finds the root digit by digit: `root` is twice what is found, times the digit at `bit`, and x is the rest. */
uint32_t glint_square_root(uint64_t x) {
    uint64_t root = 0, bit = (uint64_t)1 << (x >> 32 ? 62 : 30);
    while (bit > x)
        bit >>= 2;
    for (; bit; bit >>= 2) {
        const uint64_t more = root + bit;
        root >>= 1;
        if (x >= more) {
            x -= more;
            root += bit;
        }
    }
    return (uint32_t)root;
}
