/* SPDX-License-Identifier: MIT */
/**
 * @file problem.h
 * What is wrong with an input: one line for the user.
 */
#ifndef GLINT_HOST_PROBLEM_H
#define GLINT_HOST_PROBLEM_H

#include <stdbool.h>
#include <stddef.h>

#if defined(__GNUC__)
#define PROBLEM_PRINTF(at, first) __attribute__((format(printf, at, first)))
#else
#define PROBLEM_PRINTF(at, first)
#endif

/** Most bytes of a token that a message shows, its end included. */
#define PROBLEM_QUOTE_SIZE 32

typedef struct host_problem {
    size_t line;    /**< Line of the file, from 1; 0 when it is the file as a whole. */
    char text[240]; /**< What is wrong, without a line end. */
} host_problem;

/** Most warnings of an input. */
#define PROBLEM_WARNINGS_MAX 24

/** What an input says and is not followed, though all else of it is. */
typedef struct host_warnings {
    host_problem list[PROBLEM_WARNINGS_MAX];
    size_t count;
} host_warnings;

/** Notes a problem. @return false, so that a check can end with it. */
bool problem_set(host_problem *problem, size_t line, const char *format, ...) PROBLEM_PRINTF(3, 4);

/** Copies a token for a message: shortened, bytes that are no printable ASCII shown as '?'. @return `out`. */
const char *problem_quote(char out[PROBLEM_QUOTE_SIZE], const char *start, size_t length);

/** Prints `file:line: text` as one line on stderr; `glint: text` when `file` is null. */
void problem_print(const char *file, const host_problem *problem);

/** Prints a file's warnings, a line each. */
void problem_print_warnings(const char *file, const host_warnings *warnings);

#endif
