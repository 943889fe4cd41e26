/* SPDX-License-Identifier: MIT */
/**
 * @file basics.h
 * Memory, problems, and files.
 */
#ifndef GLINT_HOST_BASICS_H
#define GLINT_HOST_BASICS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/*
 * Heap memory for the host program. Running out of it ends the program with one line on stderr and status 2: nothing
 * on the host can go on without, and no output file exists before all of it is in memory.
 */

/** Zeroed room for `count` items of `size` bytes, never null; the caller frees it. */
void *memory_new(size_t count, size_t size);

/**
 * Makes room for one more item in an array that holds `count` of them.
 * @param array the array, or null when `*capacity` is 0
 * @param capacity items that there is room for; raised by at least half when it has to grow
 * @return the array, moved perhaps; the caller frees it
 */
void *memory_grow(void *array, size_t *capacity, size_t count, size_t size);

/* ---- What is wrong with an input: one line for the user ---- */

#if defined(__GNUC__)
#define PROBLEM_PRINTF(at, first) __attribute__((format(printf, at, first)))
#else
#define PROBLEM_PRINTF(at, first)
#endif

/** Most bytes of a token that a message shows, its end included. */
#define PROBLEM_QUOTE_SIZE 32

typedef struct host_problem {
    size_t line;    /**< Line of the file, from 1; 0 when it is the file as a whole. */
    char text[240]; /**< What is wrong, without a line end. */
} host_problem;

/** Most warnings of an input. */
#define PROBLEM_WARNINGS_MAX 24

/** Tells of statements of an input that are ignored while all others are followed. */
typedef struct host_warnings {
    host_problem list[PROBLEM_WARNINGS_MAX];
    size_t count;
} host_warnings;

/** Notes a problem. @return false, so that a check can end with it. */
bool problem_set(host_problem *problem, size_t line, const char *format, ...) PROBLEM_PRINTF(3, 4);

/** Copies a token for a message: shortened, bytes that are no printable ASCII shown as '?'. @return `out`. */
const char *problem_quote(char out[PROBLEM_QUOTE_SIZE], const char *start, size_t length);

/** Prints `file:line: text` as one line on stderr; `glint: text` when `file` is null. */
void problem_print(const char *file, const host_problem *problem);

/** Prints a file's warnings, a line each. */
void problem_print_warnings(const char *file, const host_warnings *warnings);

/* ---- Files written whole or not at all, and files read whole. Takes POSIX ---- */

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
 * Writes two files as bytes_write_file does, and moves neither into place before both are written. Both are regular
 * files, or do not exist.
 * @param[out] wrong the path that cannot be written, null for none
 * @return false with a problem of line 0 when that fails
 */
bool bytes_write_pair(const host_file pair[2], const char **wrong, host_problem *problem);

/** Returns whether two paths name the same regular file, directly or by links. */
bool path_is_same_file(const char *a, const char *b);

/** Returns whether a path names the file that standard output goes to. */
bool path_is_stdout(const char *path);

/** The part of a path after its last slash. */
const char *path_base_name(const char *path);

#endif
