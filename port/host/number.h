/* SPDX-License-Identifier: MIT */
/**
 * @file number.h
 * Numbers from text, strictly and the same in every locale, and numbers as Q16.16.
 */
#ifndef GLINT_HOST_NUMBER_H
#define GLINT_HOST_NUMBER_H

#include "glint.h"

#include <stdbool.h>

/** Largest magnitude that Q16.16 holds, rounded down. */
#define NUMBER_Q16_MAX 32767.0

/**
 * Reads a decimal number: sign, digits with at most one point, exponent; nothing before, nothing after. Correctly
 * rounded up to 15 digits with a power of ten within 22, within 3 units in the last place beyond.
 * @return false when it is none, or not finite as a double; `*value` is then untouched
 */
bool number_real(const char *text, size_t length, double *value);

/** Reads a decimal integer with an optional minus, at most 18 digits. @return false when it is none. */
bool number_integer(const char *text, size_t length, int64_t *value);

/**
 * Reads exactly `count` numbers with one `separator` between each two.
 * @return false when the text is anything else; `values` may then be changed
 */
bool number_list(const char *text, size_t length, char separator, size_t count, double *values);

/** Nearest Q16.16, halves away from zero; `value` must be within +-NUMBER_Q16_MAX. */
glint_q16 number_q16(double value);

/** Q16.16 as a double: exact. */
double number_from_q16(glint_q16 value);

#endif
