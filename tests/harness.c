/* SPDX-License-Identifier: MIT */
#include "harness.h"

/* Failed checks reported of one case; the rest are only counted, so that a broken loop does not flood the report. */
#define REPORTS_MAX 5

static test_writer writer;
static const char *case_name;
static unsigned case_failures;

void test_write(const char *text) {
    writer(text);
}

void test_write_number(int64_t number) {
    char digits[24];
    char *at = digits + sizeof digits;
    uint64_t rest = number < 0 ? 0 - (uint64_t)number : (uint64_t)number;
    *--at = '\0';
    do {
        *--at = (char)('0' + (int)(rest % 10));
        rest /= 10;
    } while (rest != 0);
    if (number < 0)
        *--at = '-';
    writer(at);
}

/* @return whether the failure is to be reported in full. */
static int report_failure(const char *expression, const char *file, int line) {
    case_failures++;
    if (case_failures > REPORTS_MAX)
        return 0;
    writer(file);
    writer(":");
    test_write_number(line);
    writer(": ");
    writer(case_name);
    writer(": ");
    writer(expression);
    return 1;
}

int test_check(int passed, const char *expression, const char *file, int line) {
    if (!passed && report_failure(expression, file, line))
        writer("\n");
    return passed;
}

static int check_numbers(int passed, const int64_t numbers[2], const char *expression, const char *file, int line) {
    if (!passed && report_failure(expression, file, line)) {
        writer(": ");
        test_write_number(numbers[0]);
        writer(" against ");
        test_write_number(numbers[1]);
        writer("\n");
    }
    return passed;
}

int test_check_equal(int64_t actual, int64_t expected, const char *expression, const char *file, int line) {
    const int64_t numbers[2] = {actual, expected};
    return check_numbers(actual == expected, numbers, expression, file, line);
}

int test_check_at_most(int64_t actual, int64_t most, const char *expression, const char *file, int line) {
    const int64_t numbers[2] = {actual, most};
    return check_numbers(actual <= most, numbers, expression, file, line);
}

int test_run(test_writer write, const test_case *cases, unsigned count) {
    unsigned failed = 0;
    writer = write;
    for (unsigned index = 0; index < count; index++) {
        case_name = cases[index].name;
        case_failures = 0;
        cases[index].run();
        if (case_failures > REPORTS_MAX) {
            writer("  and ");
            test_write_number((int64_t)case_failures - REPORTS_MAX);
            writer(" more\n");
        }
        failed += case_failures > 0;
    }
    test_write_number((int64_t)count - failed);
    writer(" passed, ");
    test_write_number(failed);
    writer(" failed\n");
    return (int)failed;
}
