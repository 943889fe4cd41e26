/* SPDX-License-Identifier: MIT */
/** @file lobes.h Wide highlights, those of the cosine. */
#ifndef GLINT_LOBES_H
#define GLINT_LOBES_H

#include "terms.h"

/** x^p, Q15, for x Q31 from 1 to 2^31 - 1: the power of x's mantissa times that of a power of two. */
static inline uint32_t glint_power_of_cosine(const uint16_t cosine[GLINT_COSINE_VALUES], uint32_t x) {
    const unsigned zeros = glint_leading_zeros(x);
    const uint32_t m = (x << zeros >> 16) - (1u << 15); /* 15 bits */
    const uint16_t *node = &cosine[m >> 9];
    const int32_t mantissa = node[0] + glint_shift_right((node[1] - node[0]) * (int32_t)(m & 0x1ff), 9);
    return (uint32_t)mantissa * cosine[GLINT_COSINE_HALF + zeros] >> 15;
}

#endif
