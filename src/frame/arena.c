/* SPDX-License-Identifier: MIT */
/* Arena: memory handed out from the low end; clipped triangles grow from the high one. */
#include "arena.h"

#include "frame.h"

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

glint_spare glint_find_spare(const glint_frame *frame) {
    uint8_t *const low = glint_align(frame->references + frame->reference_count);
    uint8_t *const high = (uint8_t *)frame->clipped;
    return (glint_spare){low, low < high ? (uint32_t)(high - low) : 0, 0};
}

void glint_count_arena(glint_frame *frame) {
    const uint8_t *base = frame->memory.base;
    const uint8_t *low = (const uint8_t *)(frame->references + frame->reference_count);
    size_t used = (size_t)(low - base) + (size_t)(base + frame->memory.high - (const uint8_t *)frame->clipped);
    if (used > frame->stats.arena_used)
        frame->stats.arena_used = (uint32_t)used;
}
