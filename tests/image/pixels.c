/* SPDX-License-Identifier: MIT */
/*
 * Suite: every pixel of thousands of pictures is what it was: a change that moves one
 * shows in the commit that renews the table (`make figures`).
 */
#include "harness.h"
#include "pixel_sums.h"
#include "pixel_table.h"

static unsigned next;

static void keeps_its_sums(void) {
    const unsigned index = next++;
    uint32_t found;
    CHECK(pixel_sums_draw(index, &found));
    CHECK_EQUAL(found, pixel_table[index]);
}

int test_main(test_writer write) {
    static test_case cases[TEST_COUNT(pixel_table)];
    if (pixel_sums_count != TEST_COUNT(cases)) {
        write("pixel_table.h is of other kinds: make figures\n");
        return 1;
    }
    for (unsigned i = 0; i < TEST_COUNT(cases); i++)
        cases[i] = (test_case){pixel_sums_name(i), keeps_its_sums};
    return test_run(write, cases, TEST_COUNT(cases));
}
