/* SPDX-License-Identifier: MIT */
/**
 * @file output.h
 * Files written whole or not at all, and files read whole. Takes POSIX.
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

/** FNV-1a, 64 bits. */
uint64_t bytes_hash(const void *data, size_t count);

/** Appends a byte. */
void bytes_add(host_bytes *bytes, uint8_t value);

/** Appends formatted text, of at most 1 KB. */
void bytes_print(host_bytes *bytes, const char *format, ...) PROBLEM_PRINTF(2, 3);

/**
 * Reads a file whole.
 * @param most bytes that it may have, in whole millions
 * @return false with a problem of line 0 when that fails; nothing is then to be freed
 */
bool bytes_read_file(host_bytes *bytes, const char *path, size_t most, host_problem *problem);

/**
 * Writes a new file in the same folder and moves it into place, so that neither a failure nor a signal leaves a part of
 * it or harms an older one, and of several programs that write the same file one wins. The new file has the older one's
 * permissions; one that may not be written stays, which is a problem. A link stays, and the file that it leads to is
 * replaced; one that leads to nothing is refused. What is no regular file, such as a device or a pipe, and /dev/stdout,
 * are written directly.
 * @return false with a problem of line 0 when that fails
 */
bool bytes_write_file(const host_bytes *bytes, const char *path, host_problem *problem);

/** A file to be written. */
typedef struct host_file {
    host_bytes bytes;
    const char *path;
} host_file;

/**
 * Writes two files as bytes_write_file does, and moves them into place together: where the second cannot be moved, the
 * first becomes what it was before. Both are regular files, or do not exist. Of several programs that write the same
 * pair one wins with both files, wherever the first one's folder can be locked. Only what ends a program without
 * notice, such as SIGKILL, can come between the two moves.
 * @param[out] wrong the path that cannot be written, null for none
 * @return false with a problem of line 0 when that fails
 */
bool bytes_write_pair(const host_file pair[2], const char **wrong, host_problem *problem);

/** Whether two paths lead to one regular file, by links or not. */
bool path_is_same_file(const char *a, const char *b);

/** Whether a path leads to what the program prints to. */
bool path_is_stdout(const char *path);

/** The part of a path after its last slash. */
const char *path_base_name(const char *path);

#endif
