/* SPDX-License-Identifier: MIT */
/** @file stdlib.h What the host program uses of it. */
#ifndef GLINT_WEB_STDLIB_H
#define GLINT_WEB_STDLIB_H

#include <stddef.h>

void *malloc(size_t size);
void *calloc(size_t count, size_t size);
void *realloc(void *memory, size_t size);
void free(void *memory); /**< Does nothing: web.c takes all memory back at once. */
void qsort(void *items, size_t count, size_t size, int (*compare)(const void *, const void *));
void exit(int status) __attribute__((noreturn));

static inline int abs(int value) {
    return value < 0 ? -value : value;
}

#endif
