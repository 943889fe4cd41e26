/* SPDX-License-Identifier: MIT */
/**
 * @file framebuffer.h
 * What stands for a panel in a benchmark: finished tiles are copied to a framebuffer in memory, as an LCD controller
 * would have it, in blocks of several words.
 */
#ifndef GLINT_BENCH_FRAMEBUFFER_H
#define GLINT_BENCH_FRAMEBUFFER_H

#include <stddef.h>
#include <stdint.h>

/* What one assignment moves without a call of memcpy. */
#if defined(__thumb2__)
#define FRAMEBUFFER_BLOCK_WORDS 16
#elif defined(__arm__)
#define FRAMEBUFFER_BLOCK_WORDS 8
#else
#define FRAMEBUFFER_BLOCK_WORDS 4
#endif

typedef struct framebuffer_block {
    uint32_t words[FRAMEBUFFER_BLOCK_WORDS];
} framebuffer_block;

/** Copies rows of 32 pixels of 16 bits, what most tiles are made of. */
static inline void framebuffer_copy_rows(uint8_t *to, size_t pitch, const uint8_t *from, size_t stride, int rows) {
    for (; rows > 0; rows--, to += pitch, from += stride) {
        framebuffer_block *out = (framebuffer_block *)(void *)to;
        const framebuffer_block *in = (const framebuffer_block *)(const void *)from;
        for (size_t i = 0; i < 16 / FRAMEBUFFER_BLOCK_WORDS; i++) {
            out[i] = in[i];
        }
    }
}

/** Copies rows of any bytes. */
static inline void framebuffer_copy_any(uint8_t *to, size_t pitch, const uint8_t *from, size_t stride, size_t bytes,
                                        int rows, size_t blocks) {
    for (; rows > 0; rows--, to += pitch, from += stride) {
        framebuffer_block *out = (framebuffer_block *)(void *)to;
        const framebuffer_block *in = (const framebuffer_block *)(const void *)from;
        for (size_t i = 0; i < blocks; i++) {
            out[i] = in[i];
        }
        for (size_t i = blocks * sizeof *in; i < bytes; i++) {
            to[i] = from[i];
        }
    }
}

/** Copies a rectangle: rows of so many bytes, `pitch` and `stride` apart. */
static inline void framebuffer_copy(void *to, size_t pitch, const void *from, size_t stride, size_t bytes, int rows) {
    const int aligned = (((uintptr_t)to | (uintptr_t)from | pitch | stride) & 3) == 0;

    if (aligned && bytes % 64 == 0) {
        for (size_t i = 0; i < bytes; i += 64) {
            framebuffer_copy_rows((uint8_t *)to + i, pitch, (const uint8_t *)from + i, stride, rows);
        }
    } else {
        framebuffer_copy_any(to, pitch, from, stride, bytes, rows, aligned ? bytes / sizeof(framebuffer_block) : 0);
    }
}

#endif
