/* SPDX-License-Identifier: MIT */
/* Prints tests/unit/checksums.h: what the unit tests' images and numbers come to on the host. */
#include "checksummed.h"
#include "harness.h"

#include <stdio.h>

static void print(void) {
    /* REUSE-IgnoreStart */
    puts("/* SPDX-License-Identifier: MIT */\n"
         "/*\n"
         " * Made by `make figures`; not to be edited. Says only that every core and compiler computes the same\n"
         " * bits: whether they are right is judged by the reference, tests/image/accuracy.c.\n"
         " */\n"
         "/* clang-format off */\n"
         "#ifndef GLINT_UNIT_CHECKSUMS_H\n#define GLINT_UNIT_CHECKSUMS_H\n\n#include <stdint.h>\n\n"
         "static const uint32_t expected_checksums[] = {");
    /* REUSE-IgnoreEnd */
    for (unsigned i = 0; i < checksummed_count; i++)
        printf("    0x%08xu, /* %s */\n", (unsigned)checksummed_compute(i), checksummed_name(i));
    puts("};\n\n#endif");
}

static void write_stderr(const char *text) {
    fputs(text, stderr);
}

/* A case, so that an image that fails to draw is reported and its table is not kept. */
int main(void) {
    static const test_case cases[] = {TEST_CASE(print)};
    return test_run(write_stderr, cases, TEST_COUNT(cases)) > 0;
}
