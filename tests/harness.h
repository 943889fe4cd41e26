/* SPDX-License-Identifier: MIT */
/**
 * @file harness.h
 * A test harness without libc, so that the same test bodies run on the host and on the boards.
 *
 * A suite is a table of named cases. A case fails when one of its checks does; it goes on after a failed check, and
 * reports the first few of them. A program holds one suite, the one its `test_main` runs.
 */
#ifndef GLINT_TESTS_HARNESS_H
#define GLINT_TESTS_HARNESS_H

#include <stdint.h>

/** Takes a piece of the report; lines end with '\n'. */
typedef void (*test_writer)(const char *text);

typedef struct test_case {
    const char *name;
    void (*run)(void);
} test_case;

/** An entry of a table of cases: the function's name is the case's. */
#define TEST_CASE(function) \
    { #function, function }

/** Fails the case unless `expression` is true. Its value is 1 or 0, to leave a case that cannot go on. */
#define CHECK(expression) test_check((expression) ? 1 : 0, #expression, __FILE__, __LINE__)

/** Fails the case unless two integers are equal, and prints both. */
#define CHECK_EQUAL(actual, expected) \
    test_check_equal((int64_t)(actual), (int64_t)(expected), #actual " == " #expected, __FILE__, __LINE__)

/** Fails the case unless `actual` is at most `most`, and prints both. */
#define CHECK_AT_MOST(actual, most) \
    test_check_at_most((int64_t)(actual), (int64_t)(most), #actual " <= " #most, __FILE__, __LINE__)

/** Number of entries of an array. */
#define TEST_COUNT(array) ((unsigned)(sizeof(array) / sizeof((array)[0])))

int test_check(int passed, const char *expression, const char *file, int line);
int test_check_equal(int64_t actual, int64_t expected, const char *expression, const char *file, int line);
int test_check_at_most(int64_t actual, int64_t most, const char *expression, const char *file, int line);

/** Writes text or a decimal number into the report, from within a case. */
void test_write(const char *text);
void test_write_number(int64_t number);

/**
 * Runs `count` cases, prints each failed check with its place, and closes with the line "N passed, N failed".
 * @return the number of cases that failed.
 */
int test_run(test_writer write, const test_case *cases, unsigned count);

/** Runs the program's suite through `test_run`; defined by the suite. */
int test_main(void (*write)(const char *text));

#endif
