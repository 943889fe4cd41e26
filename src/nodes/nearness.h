/* SPDX-License-Identifier: MIT */
/** @file nearness.h How near a light is to a point, and how far from opposite the eye, as one number of 16 bits. */
#ifndef GLINT_NEARNESS_H
#define GLINT_NEARNESS_H

#include "../math/numeric.h"

/**
 * Depth over the distance to a light, Q8, at most 2^16 - 1, rounded up to 6 bits, and |L + V|^2 / 2, Q15, at most 1,
 * rounded down to 7. The first's bits are a mantissa of 5, below a power of two's, which leads from 32 on.
 */
static inline uint32_t glint_nearness_of(uint32_t closeness, uint32_t half) {
    const unsigned zeros = glint_leading_zeros(closeness), up = zeros < 26 ? 26 - zeros : 0;
    const uint32_t mantissa = (closeness + (1u << up) - 1) >> up; /* 2^6 stands for the next power's 2^5 */
    return (mantissa + (up << 5)) << 7 | half >> 8;
}

/** Depth over the distance that a nearness holds. */
static inline uint32_t glint_closeness_of(uint32_t nearness) {
    const uint32_t code = nearness >> 7, up = code >> 5;
    return up > 1 ? ((code & 31) + 32) << (up - 1) : code;
}

/** The nearness of two points: of the larger closeness, and the lesser half vector. */
static inline uint32_t glint_nearness_of_both(uint32_t a, uint32_t b) {
    const uint32_t nearer = a > b ? a : b, half = (a & 0x7f) < (b & 0x7f) ? a & 0x7f : b & 0x7f;
    return (nearer & ~0x7fu) | half;
}

#endif
