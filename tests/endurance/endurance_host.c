/* SPDX-License-Identifier: MIT */
/* endurance FRAMES */
#include "endurance.h"

#include <stdio.h>
#include <stdlib.h>

static void write_text(const char *text) {
    fputs(text, stdout);
    fflush(stdout);
}

int main(int argc, char **argv) {
    const uint32_t frames = argc == 2 ? (uint32_t)strtoul(argv[1], NULL, 10) : 0;
    if (!frames) {
        fputs("endurance FRAMES\n", stderr);
        return 2;
    }
    const uint32_t differing = endurance_run(frames, write_text);
    printf("%d passed, %d failed\n", !differing, differing != 0);
    return differing != 0;
}
