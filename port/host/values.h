/* SPDX-License-Identifier: MIT */
/**
 * @file values.h
 * Values of options from text. Each returns false with a problem that says what the value should have been.
 */
#ifndef GLINT_HOST_VALUES_H
#define GLINT_HOST_VALUES_H

#include "glint.h"
#include "problem.h"

/** Says what a value should have been. @return false, as all parsers do then */
bool value_expected(host_problem *problem, const char *what);

/** A number from `least` to `most`; without a problem of its own. */
bool value_real(const char *text, double least, double most, double *value);

/** Two integers with an x between them; without a problem of its own. */
bool value_pair(const char *text, int64_t *first, int64_t *second);

/** A vector x,y,z, each within what Q16.16 holds. */
bool value_vector(const char *text, size_t length, glint_vector *vector, host_problem *problem);

/** The same, of any length but 0. */
bool value_direction(const char *text, size_t length, glint_vector *vector, host_problem *problem);

/** A colour r,g,b or a grey level, each from 0 to 16. */
bool value_colour(const char *text, size_t length, glint_colour *colour, host_problem *problem);

#endif
