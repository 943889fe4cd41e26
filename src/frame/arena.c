/* SPDX-License-Identifier: MIT */
/* Arena: memory handed out from the low end; clipped triangles grow from the high one. */
#include "arena.h"

#include "frame.h"

void *glint_take(glint_memory *memory, size_t size) {
    size_t start = GLINT_ALIGNED(memory->low);
    if (start > memory->high || size > memory->high - start)
        return 0;
    memory->low = start + size;
    return memory->base + start;
}

void glint_count_arena(glint_frame *frame) {
    const uint8_t *base = frame->memory.base;
    const uint8_t *low = (const uint8_t *)(frame->references + frame->reference_count);
    size_t used = (size_t)(low - base) + (size_t)(base + frame->memory.high - (const uint8_t *)frame->clipped);
    if (used > frame->stats.arena_used)
        frame->stats.arena_used = (uint32_t)used;
}
