/* SPDX-License-Identifier: MIT */
/** @file arena.h Hands out the memory of a frame. */
#ifndef GLINT_ARENA_H
#define GLINT_ARENA_H

#include "../glint_extras.h"

/** Everything in the arena is aligned to this. */
#define GLINT_ALIGNMENT (sizeof(void *))

/** Rounds bytes up to the alignment. */
#define GLINT_ALIGNED(size) (((size) + GLINT_ALIGNMENT - 1) & ~(GLINT_ALIGNMENT - 1))

/** Returns the first aligned byte, at most GLINT_ALIGNMENT - 1 further. An arena gives those bytes up wherever it
 * starts. */
static inline uint8_t *glint_align(void *memory) {
    uint8_t *bytes = memory;
    return bytes + (-(uintptr_t)bytes & (GLINT_ALIGNMENT - 1));
}

/** A word may lie over any type, pixels of any format included. */
#if defined(__GNUC__)
typedef uint32_t __attribute__((may_alias)) glint_word;
#else
typedef uint32_t glint_word;
#endif

/** Takes `size` bytes from the arena's low end, aligned for pointers. @return null when the arena is full */
void *glint_take(glint_memory *memory, size_t size);

/** Sums `size` bytes up, whole words. Another sum shows that something has written there. */
uint32_t glint_sum(const void *memory, size_t size);

#endif
