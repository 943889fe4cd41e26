/* SPDX-License-Identifier: MIT */
/**
 * @file values.h
 * Numbers, names and values of options from text.
 */
#ifndef GLINT_HOST_VALUES_H
#define GLINT_HOST_VALUES_H

#include "basics.h"
#include "glint.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* ---- Numbers from text, strictly and the same in every locale, and numbers as Q16.16 ---- */

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

/** Converts a vector of Q16.16 to doubles: exact. */
void number_from_vector(glint_vector vector, double values[3]);

/* ---- The word that was meant ---- */

/**
 * By how many letters more, fewer or other a word is another (Levenshtein, 1966). Only the first 32 bytes count.
 * @param length of `word`, which need not be terminated
 */
size_t nearest_distance(const char *word, size_t length, const char *other);

/** Whether a word so far from another may have been meant: one letter in three is wrong at most. */
int nearest_is_meant(size_t length, size_t distance);

/*
 * Values of options from text. Each returns false with a problem that says what the value should have been.
 */

/** Two integers with an x between them, each from 1 to `most`; without a problem of its own. */
bool value_pair(const char *text, uint16_t most, uint16_t *first, uint16_t *second);

/** A vector x,y,z, each within what Q16.16 holds. */
bool value_vector(const char *text, size_t length, glint_vector *vector, host_problem *problem);

/** The same, of any length but 0. */
bool value_direction(const char *text, size_t length, glint_vector *vector, host_problem *problem);

/** A colour r,g,b or a grey level, each from 0 to 16. */
bool value_colour(const char *text, size_t length, glint_colour *colour, host_problem *problem);

/** A light: a kind and its fields, with colons between them. It stays as it was where the result is false. */
bool value_light(const char *text, glint_light *light, host_problem *problem);

#endif
