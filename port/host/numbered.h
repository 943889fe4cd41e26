/* SPDX-License-Identifier: MIT */
/** @file numbered.h Names of files that are numbered. */
#ifndef GLINT_HOST_NUMBERED_H
#define GLINT_HOST_NUMBERED_H

#include "problem.h"

#include <stdint.h>

/** A name, taken apart. Its text is the caller's. */
typedef struct numbered_name {
    const char *text;
    bool has_number;
    size_t at, length; /**< Where in the text the number goes, and the bytes there that stand for it. */
    uint32_t digits;   /**< That the number has at least, zeros before it. */
} numbered_name;

/**
 * Takes a name apart: at most one %d, or %0Nd for N from 1 to 9 digits, stands for the number, and %% for a percent.
 * @return false with a problem of line 0 for any other percent
 */
bool numbered_parse(numbered_name *name, const char *text, host_problem *problem);

/** The name with a number in it, percents undone; the caller frees it. */
char *numbered_make(const numbered_name *name, uint32_t number);

#endif
