/* SPDX-License-Identifier: MIT */
/** @file string.h The functions of memory.c, for firmware without a C library: it stands in for the standard header. */
#ifndef GLINT_STRING_H
#define GLINT_STRING_H

#include <stddef.h>

void *memcpy(void *restrict to, const void *restrict from, size_t count);
void *memmove(void *to, const void *from, size_t count);
void *memset(void *to, int value, size_t count);
int memcmp(const void *first, const void *second, size_t count);

#endif
