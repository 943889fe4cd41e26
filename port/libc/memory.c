/* SPDX-License-Identifier: MIT */
/*
 * The four functions that gcc and clang call even in freestanding code, for firmware without a C library. Compiled with
 * -fno-tree-loop-distribute-patterns, or the loops would be turned into calls of themselves.
 */
#include "string.h"

#include <stdint.h>

/* What one assignment moves without a call of memcpy: on ARM by several registers at once; and how many make a turn. */
#if !defined(__arm__)
#define BLOCK_WORDS 1
#define TURN_BLOCKS 4
#elif defined(__OPTIMIZE_SIZE__)
#define BLOCK_WORDS 4
#define TURN_BLOCKS 1
#elif defined(__thumb2__)
#define BLOCK_WORDS 16
#define TURN_BLOCKS 1
#else
#define BLOCK_WORDS 8
#define TURN_BLOCKS 2
#endif

typedef struct block {
    uint32_t words[BLOCK_WORDS];
} block;

#define TURN (TURN_BLOCKS * sizeof(block))

static inline void copy_turn(uint8_t *to, const uint8_t *from) {
    block *out = (block *)(void *)to;
    const block *in = (const block *)(const void *)from;

    out[0] = in[0];
    if (TURN_BLOCKS > 1) {
        out[1] = in[1];
    }
    if (TURN_BLOCKS > 2) {
        out[2] = in[2];
        out[3] = in[3];
    }
}

static int aligned(const void *first, const void *second) {
    return (((uintptr_t)first | (uintptr_t)second) & 3u) == 0;
}

void *memcpy(void *restrict to, const void *restrict from, size_t count) {
    uint8_t *out = to;
    const uint8_t *in = from;

    if (aligned(to, from)) {
        for (; count >= TURN; count -= TURN, out += TURN, in += TURN) {
            copy_turn(out, in);
        }
        for (; count >= 4; count -= 4, out += 4, in += 4) {
            *(uint32_t *)(void *)out = *(const uint32_t *)(const void *)in;
        }
    }
    for (; count > 0; count--) {
        *out++ = *in++;
    }
    return to;
}

void *memmove(void *to, const void *from, size_t count) {
    uint8_t *out = to;
    const uint8_t *in = from;

    if ((uintptr_t)out <= (uintptr_t)in) {
        for (size_t i = 0; i < count; i++) {
            out[i] = in[i];
        }
    } else {
        for (size_t i = count; i > 0; i--) {
            out[i - 1] = in[i - 1];
        }
    }
    return to;
}

void *memset(void *to, int value, size_t count) {
    uint8_t *out = to;
    const uint32_t word = (uint8_t)value * 0x01010101u;

    if (aligned(to, to)) {
        if (count >= TURN) {
            for (size_t i = 0; i < TURN; i += 4, out += 4, count -= 4) {
                *(uint32_t *)(void *)out = word;
            }
        }
        for (; count >= TURN; count -= TURN, out += TURN) {
            copy_turn(out, out - TURN);
        }
        for (; count >= 4; count -= 4, out += 4) {
            *(uint32_t *)(void *)out = word;
        }
    }
    for (; count > 0; count--) {
        *out++ = (uint8_t)value;
    }
    return to;
}

int memcmp(const void *first, const void *second, size_t count) {
    const uint8_t *a = first;
    const uint8_t *b = second;

    for (size_t i = 0; i < count; i++) {
        if (a[i] != b[i]) {
            return a[i] < b[i] ? -1 : 1;
        }
    }
    return 0;
}
