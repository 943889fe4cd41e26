/* SPDX-License-Identifier: MIT */
/*
 * Integer helpers that gcc calls and its library for the LX106 leaves out: an ESP8266 has them in its ROM. Here for an
 * emulator, so that they are short and not fast. The compiler gives their names.
 */
#include <stdint.h>

uint32_t __udivsi3(uint32_t dividend, uint32_t divisor);
uint32_t __umodsi3(uint32_t dividend, uint32_t divisor);
int32_t __divsi3(int32_t dividend, int32_t divisor);
uint64_t __muldi3(uint64_t a, uint64_t b);
uint64_t __udivdi3(uint64_t dividend, uint64_t divisor);
uint64_t __umoddi3(uint64_t dividend, uint64_t divisor);
int64_t __divdi3(int64_t dividend, int64_t divisor);

/* Divides bit by bit. @return the quotient; 0 has all ones */
static uint64_t divide(uint64_t dividend, uint64_t divisor, uint64_t *rest) {
    uint64_t quotient = 0;

    *rest = 0;
    for (int bit = 63; bit >= 0; bit--) {
        *rest = *rest << 1 | (dividend >> bit & 1);
        quotient <<= 1;
        if (*rest >= divisor) {
            *rest -= divisor;
            quotient |= 1;
        }
    }
    return quotient;
}

uint64_t __udivdi3(uint64_t dividend, uint64_t divisor) {
    uint64_t rest;

    return divide(dividend, divisor, &rest);
}

uint64_t __umoddi3(uint64_t dividend, uint64_t divisor) {
    uint64_t rest;

    divide(dividend, divisor, &rest);
    return rest;
}

/* Magnitude of a number, also of the lowest. */
static uint64_t magnitude(int64_t number) {
    return number < 0 ? 0 - (uint64_t)number : (uint64_t)number;
}

int64_t __divdi3(int64_t dividend, int64_t divisor) {
    const uint64_t quotient = __udivdi3(magnitude(dividend), magnitude(divisor));

    return (int64_t)((dividend < 0) == (divisor < 0) ? quotient : 0 - quotient);
}

uint32_t __udivsi3(uint32_t dividend, uint32_t divisor) {
    return (uint32_t)__udivdi3(dividend, divisor);
}

uint32_t __umodsi3(uint32_t dividend, uint32_t divisor) {
    return (uint32_t)__umoddi3(dividend, divisor);
}

int32_t __divsi3(int32_t dividend, int32_t divisor) {
    return (int32_t)__divdi3(dividend, divisor);
}

uint64_t __muldi3(uint64_t a, uint64_t b) {
    uint64_t product = 0;

    for (; b > 0; b >>= 1, a <<= 1) {
        if (b & 1) {
            product += a;
        }
    }
    return product;
}
