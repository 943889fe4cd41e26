/* SPDX-License-Identifier: MIT */
/**
 * @file semihosting.h
 * Text, arguments and exit status through the debugger or emulator (Arm, "Semihosting for AArch32 and AArch64"; the
 * same operations in RISC-V Semihosting 0.2).
 * Without one, start-up code's fault handler makes every call return -1, so that firmware runs all the same.
 */
#ifndef GLINT_SEMIHOSTING_H
#define GLINT_SEMIHOSTING_H

#include <stddef.h>

void semihosting_write(const char *text);

/** Waits for a character. @return the character, or -1. */
int semihosting_read(void);

/** Fills in the program's arguments, one string. @return 0, or -1 when there are none or they do not fit. */
int semihosting_arguments(char *text, size_t size);

void semihosting_exit(int status);

/** board_checkpoint for boards whose text goes this way. */
void semihosting_checkpoint(const char *name);

/** One call, as the core makes it; defined by the core's port. @return its result, -1 when nobody answers. */
int semihosting_call(int operation, const void *argument);

#endif
