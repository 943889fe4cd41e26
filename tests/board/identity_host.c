/* SPDX-License-Identifier: MIT */
#include "identity.h"

#include <stdio.h>

static void write_text(const char *text) {
    fputs(text, stdout);
}

int main(void) {
    return identity_run(write_text) != 0;
}
