/* SPDX-License-Identifier: MIT */
#include "semihosting.h"

#include <stdint.h>

enum { SYS_WRITE0 = 0x04, SYS_READC = 0x07, SYS_GET_CMDLINE = 0x15, SYS_EXIT_EXTENDED = 0x20 };

/* ADP_Stopped_ApplicationExit: the reason that carries an exit status. */
static const uintptr_t application_exit = 0x20026;

static int call(int operation, const void *argument) {
    register int result __asm__("r0") = operation;
    register const void *parameter __asm__("r1") = argument;

    __asm__ volatile("bkpt 0xab" : "+r"(result) : "r"(parameter) : "memory");
    return result;
}

void semihosting_write(const char *text) {
    call(SYS_WRITE0, text);
}

int semihosting_read(void) {
    return call(SYS_READC, NULL);
}

int semihosting_arguments(char *text, size_t size) {
    const uintptr_t block[2] = {(uintptr_t)text, size};

    return call(SYS_GET_CMDLINE, block);
}

void semihosting_exit(int status) {
    const uintptr_t block[2] = {application_exit, (uintptr_t)status};

    call(SYS_EXIT_EXTENDED, block);
}
