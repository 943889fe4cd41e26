/* SPDX-License-Identifier: MIT */
/** @file arena.h Memory of a frame. */
#ifndef GLINT_ARENA_H
#define GLINT_ARENA_H

#include "../glint_extras.h"

/** What everything in the arena is aligned to. */
#define GLINT_ALIGNMENT (sizeof(void *))

/** Bytes, rounded up to the alignment. */
#define GLINT_ALIGNED(size) (((size) + GLINT_ALIGNMENT - 1) & ~(GLINT_ALIGNMENT - 1))

/** The first aligned byte: at most GLINT_ALIGNMENT - 1 further. An arena gives those up wherever it starts. */
static inline uint8_t *glint_align(void *memory) {
    uint8_t *bytes = memory;
    return bytes + (-(uintptr_t)bytes & (GLINT_ALIGNMENT - 1));
}

/** A word of what has any type, pixels of any format too. */
#if defined(__GNUC__)
typedef uint32_t __attribute__((may_alias)) glint_word;
#else
typedef uint32_t glint_word;
#endif

/** `size` bytes from the arena's low end, aligned for pointers; null when it is full. */
void *glint_take(glint_memory *memory, size_t size);

/** A sum of `size` bytes, whole words: another one tells that something has written there. */
uint32_t glint_sum(const void *memory, size_t size);

#endif
