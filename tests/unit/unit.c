/* SPDX-License-Identifier: MIT */
/* Suite: the unit tests, which run on the host and on the boards alike. */
#include "unit.h"

#include "harness.h"

int test_main(test_writer write) {
#define UNIT_ENTRY(name) TEST_CASE(name),
    static const test_case cases[] = {UNIT_CASES(UNIT_ENTRY)};
    return test_run(write, cases, TEST_COUNT(cases));
}
