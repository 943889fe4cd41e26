/* SPDX-License-Identifier: MIT */
/** @file judge.h What a method is off by, against double precision. */
#ifndef GLINT_METHODS_JUDGE_H
#define GLINT_METHODS_JUDGE_H

#include "methods.h"

/** Errors in steps of an 8-bit channel, 255 to 1. */
typedef struct method_errors {
    double largest, squares;
    uint64_t samples;
} method_errors;

/** Runs a method at one of its problem's points over every `stride`-th item, and the last. */
method_errors method_measure(const method *m, uint32_t point, uint32_t stride);

/** Is a method possible at that point? */
int method_takes(const method *m, uint32_t point);

#endif
