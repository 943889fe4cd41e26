/* SPDX-License-Identifier: MIT */
/**
 * @file memory.h
 * Heap memory for the host program. Running out of it ends the program with one line on stderr and status 2: nothing
 * on the host can go on without, and no output file exists before all of it is in memory.
 */
#ifndef GLINT_HOST_MEMORY_H
#define GLINT_HOST_MEMORY_H

#include <stddef.h>

/** Zeroed room for `count` items of `size` bytes, never null; the caller frees it. */
void *memory_new(size_t count, size_t size);

/**
 * Makes room for one more item in an array that holds `count` of them.
 * @param array the array, or null when `*capacity` is 0
 * @param capacity items that there is room for; raised by at least half when it has to grow
 * @return the array, moved perhaps; the caller frees it
 */
void *memory_grow(void *array, size_t *capacity, size_t count, size_t size);

#endif
