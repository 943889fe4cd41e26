/* SPDX-License-Identifier: MIT */
/* The unit tests on the Pico, but for one: it draws 200 pictures, which takes its emulator minutes. */
#include "harness.h"
#include "unit/unit.h"

#include <stddef.h>

int test_main(test_writer write) {
#define UNIT_ENTRY(name) TEST_CASE(name),
    static const test_case all[] = {UNIT_CASES(UNIT_ENTRY)};
    static test_case cases[TEST_COUNT(all)];
    unsigned count = 0;

    for (unsigned i = 0; i < TEST_COUNT(all); i++) {
        if (all[i].run == same_bits_for_every_tile_and_arena) {
            write("not run here: ");
            write(all[i].name);
            write("\n");
        } else {
            cases[count++] = all[i];
        }
    }
    return test_run(write, cases, count);
}
