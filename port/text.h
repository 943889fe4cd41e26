/* SPDX-License-Identifier: MIT */
/** @file text.h Just enough text for firmware that has no C library. */
#ifndef GLINT_TEXT_H
#define GLINT_TEXT_H

#include <stddef.h>
#include <stdint.h>

/** Room for any 32-bit number and its end. */
#define TEXT_NUMBER_SIZE 11

/** Writes a number in decimal to the end of `digits`. @return its first digit. */
static inline const char *text_number(char digits[TEXT_NUMBER_SIZE], uint32_t number) {
    char *at = digits + (TEXT_NUMBER_SIZE - 1);

    *at = '\0';
    do {
        *--at = (char)('0' + number % 10);
        number /= 10;
    } while (number > 0);
    return at;
}

/** Writes "name number" to `out`, cut at `size` bytes. @return out. */
static inline const char *text_join(char *out, size_t size, const char *name, uint32_t number) {
    char digits[TEXT_NUMBER_SIZE];
    const char *tail = text_number(digits, number);
    size_t length = 0;

    for (; *name != '\0' && length + 2 < size; name++) {
        out[length++] = *name;
    }
    out[length++] = ' ';
    for (; *tail != '\0' && length + 1 < size; tail++) {
        out[length++] = *tail;
    }
    out[length] = '\0';
    return out;
}

#endif
