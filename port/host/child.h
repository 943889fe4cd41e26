/* SPDX-License-Identifier: MIT */
/**
 * @file child.h
 * A program run under limits, for what may crash, hang, or eat memory. Takes POSIX.
 */
#ifndef GLINT_HOST_CHILD_H
#define GLINT_HOST_CHILD_H

#include "output.h"

/** What a program may take. */
typedef struct child_limits {
    unsigned seconds;   /**< Of time that passes, and of a core's. */
    unsigned megabytes; /**< Of memory, in units of 2^20 bytes. */
    size_t output;      /**< Bytes that it may print. */
} child_limits;

/**
 * Runs a program, which reads nothing, and keeps what it prints on stdout. It can write
 * nothing into files. It is over when this
 * returns, whatever it did.
 * @param arguments the program, with or without its folder as for execvp, what it takes, and a null pointer
 * @param out set; the caller frees its data
 * @return false with a problem of line 0 when it could not be run, did not end in time, printed too much, was ended by
 *         a signal, or has an exit status other than 0: then it says what its first line on stderr does; nothing is
 *         then to be freed
 */
bool child_run(char *const arguments[], const child_limits *limits, host_bytes *out, host_problem *problem);

#endif
