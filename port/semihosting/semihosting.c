/* SPDX-License-Identifier: MIT */
#include "semihosting.h"

#include <stdint.h>

enum { SYS_WRITE0 = 0x04, SYS_READC = 0x07, SYS_GET_CMDLINE = 0x15, SYS_EXIT_EXTENDED = 0x20 };

/* ADP_Stopped_ApplicationExit: the reason that carries an exit status. */
static const uintptr_t application_exit = 0x20026;

void semihosting_write(const char *text) {
    semihosting_call(SYS_WRITE0, text);
}

int semihosting_read(void) {
    return semihosting_call(SYS_READC, NULL);
}

int semihosting_arguments(char *text, size_t size) {
    const uintptr_t block[2] = {(uintptr_t)text, size};

    return semihosting_call(SYS_GET_CMDLINE, block);
}

void semihosting_exit(int status) {
    const uintptr_t block[2] = {application_exit, (uintptr_t)status};

    semihosting_call(SYS_EXIT_EXTENDED, block);
}

static int ends_with(const char *text, const char *end) {
    const char *at = end;

    for (; *text != '\0'; text++) {
        at = *text == *at ? at + 1 : end + (*text == *end);
    }
    return *at == '\0';
}

void semihosting_checkpoint(const char *name) {
    char arguments[128];

    semihosting_write(name);
    semihosting_write(" done\n");
    if (semihosting_arguments(arguments, sizeof arguments) == 0 && ends_with(arguments, "stop")) {
        semihosting_read();
    }
}
