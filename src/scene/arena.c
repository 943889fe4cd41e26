/* SPDX-License-Identifier: MIT */
/* Hands out the memory of a frame from the arena's low end; clipped triangles grow from the high one. */
#include "arena.h"

void *glint_take(glint_memory *memory, size_t size) {
    size_t start = GLINT_ALIGNED(memory->low);
    if (size > memory->high - start) /* high is aligned, and no less than low */
        return 0;
    memory->low = start + size;
    return memory->base + start;
}

uint32_t glint_sum(const void *memory, size_t size) {
    const glint_word *const words = memory;
    const size_t count = size / sizeof *words;
    uint32_t sum = 0;
    size_t i = 0;
    for (; i + 4 <= count; i += 4)
        sum += (uint32_t)words[i] + words[i + 1] + words[i + 2] + words[i + 3];
    for (; i < count; i++)
        sum += words[i];
    return sum;
}
