/* SPDX-License-Identifier: MIT */
/* Suite: each method is off by what its descriptor states, no more and not much less. */
#include "harness.h"
#include "judge.h"

#include <math.h>

static void name(const method *m) {
    test_write("  ");
    test_write(m->problem->kind);
    test_write(", ");
    test_write(m->name);
    test_write(", ");
    test_write(m->variant);
}

/* Samples find less than the whole domain does, but not less than half. */
static void test_method(const method *m) {
    for (uint32_t point = 0; point < m->problem->point_count; point++) {
        if (!method_takes(m, point)) {
            CHECK_EQUAL(m->error[point], 0);
            continue;
        }
        const int64_t found = (int64_t)ceil(method_measure(m, point, m->problem->stride).largest * 1000);
        const int most = CHECK_AT_MOST(found, m->error[point]);
        if (!CHECK_AT_MOST(m->error[point], 2 * found) || !most) {
            name(m);
            test_write(", p ");
            test_write_number(m->problem->points[point] >> 16);
            test_write("\n");
        }
    }
}

static void methods_are_off_by_what_they_state(void) {
    for (uint32_t i = 0; i < methods_count(); i++) {
        test_method(methods_get(i));
    }
}

/* Every kind has its shipped choice, of those that there are to compare. */
static void every_kind_ships_one(void) {
    for (uint32_t i = 0; i < methods_count(); i++) {
        const method_problem *problem = methods_get(i)->problem;
        uint32_t shipped = 0;
        for (uint32_t k = 0; k < methods_count(); k++) {
            shipped += methods_get(k)->problem->kind == problem->kind && methods_get(k)->shipped;
        }
        CHECK(shipped > 0);
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(methods_are_off_by_what_they_state),
        TEST_CASE(every_kind_ships_one),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
