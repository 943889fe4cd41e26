/* SPDX-License-Identifier: MIT */
/* A suite as a host program: the report on stdout, exit status 1 when a case failed. */
#include "harness.h"

#include <stdio.h>

static void write_stdout(const char *text) {
    fputs(text, stdout);
    fflush(stdout);
}

int main(void) {
    return test_main(write_stdout) > 0;
}
