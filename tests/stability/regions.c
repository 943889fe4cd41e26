/* SPDX-License-Identifier: MIT */
/* Suite: in every region the plain method fails, and the library keeps to its contract. A region is a case. */
#include "harness.h"
#include "region.h"

#define REGIONS_MAX 64

static unsigned region_next;

static void run_next(void) {
    region_figures figures = {0};
    const char *topic;
    const region *which = region_at(region_next++, &topic);
    which->measure(&figures);
    region_check(which, &figures);
}

int test_main(test_writer write) {
    static test_case cases[REGIONS_MAX];
    const char *topic;
    const region *which;
    unsigned count = 0;
    for (; count < REGIONS_MAX && (which = region_at(count, &topic)); count++)
        cases[count] = (test_case){which->name, run_next};
    return test_run(write, cases, count);
}
