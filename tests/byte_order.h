/* SPDX-License-Identifier: MIT */
/**
 * @file byte_order.h
 * Checksums of numbers in memory that do not depend on the core: some store the low byte of a number first, some the
 * high byte.
 */
#ifndef GLINT_TESTS_BYTE_ORDER_H
#define GLINT_TESTS_BYTE_ORDER_H

#include "glint.h"

/** What to XOR the index of a byte with, so that numbers of `size` bytes, a power of two, are read low byte first. */
static inline size_t byte_order_flip(size_t size) {
    const uint16_t number = 1;
    return *(const uint8_t *)&number ? 0 : size - 1;
}

/** The same for the pixels of a format. */
static inline size_t byte_order_flip_of(const glint_format *format) {
    const int has_numbers = format == &glint_format_rgb565 || format == &glint_format_rgb565_dithered;
    return has_numbers ? byte_order_flip(2) : 0;
}

#endif
