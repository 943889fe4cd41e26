/* SPDX-License-Identifier: MIT */
/**
 * @file output.h
 * Files written whole or not at all, and files read whole.
 */
#ifndef GLINT_HOST_OUTPUT_H
#define GLINT_HOST_OUTPUT_H

#include "problem.h"

#include <stdint.h>

/** Bytes that grow; free `data`. */
typedef struct host_bytes {
    uint8_t *data;
    size_t count;
    size_t capacity;
} host_bytes;

/** Appends a byte. */
void bytes_add(host_bytes *bytes, uint8_t value);

/** Appends formatted text, of at most 1 KB. */
void bytes_print(host_bytes *bytes, const char *format, ...) PROBLEM_PRINTF(2, 3);

/** Reads a file whole. @return false with a problem of line 0 when that fails; nothing is then to be freed. */
bool bytes_read_file(host_bytes *bytes, const char *path, host_problem *problem);

/**
 * Writes a file beside its place and moves it there, so that a failure leaves neither a part of it nor harms an older
 * one; what is no regular file, such as a device, is written directly.
 * @return false with a problem of line 0 when that fails
 */
bool bytes_write_file(const host_bytes *bytes, const char *path, host_problem *problem);

/** The part of a path after its last slash. */
const char *path_base_name(const char *path);

#endif
