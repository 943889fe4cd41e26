/* SPDX-License-Identifier: MIT */
/* The unit tests on the Pico, but for those that draw many pictures: its emulator takes a minute for them. */
#include "harness.h"
#include "unit/unit.h"

#include <stddef.h>

static void (*const left_out[])(void) = {
    same_bits_for_every_tile_and_arena,  bad_meshes_are_refused,    farthest_row_is_drawn,
    clusters_that_face_away_are_dropped, unknown_flags_are_refused, frames_refuse_small_arenas,
    arena_one_byte_short_is_refused};

static int is_left_out(void (*run)(void)) {
    for (unsigned i = 0; i < TEST_COUNT(left_out); i++)
        if (left_out[i] == run)
            return 1;
    return 0;
}

int test_main(test_writer write) {
#define UNIT_ENTRY(name) TEST_CASE(name),
    static const test_case all[] = {UNIT_CASES(UNIT_ENTRY)};
    static test_case cases[TEST_COUNT(all)];
    unsigned count = 0;

    for (unsigned i = 0; i < TEST_COUNT(all); i++) {
        if (is_left_out(all[i].run)) {
            write("not run here: ");
            write(all[i].name);
            write("\n");
        } else {
            cases[count++] = all[i];
        }
    }
    return test_run(write, cases, count);
}
