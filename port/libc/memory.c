/* SPDX-License-Identifier: MIT */
/*
 * The four functions that gcc and clang call even in freestanding code, for firmware without a C library. Compiled with
 * -fno-tree-loop-distribute-patterns, or the loops would be turned into calls of themselves.
 */
#include "string.h"

#include <stdint.h>

/* What one assignment moves: on ARM four registers at once; elsewhere compilers might call memcpy for that much. */
#if defined(__arm__)
#define BLOCK_WORDS 4
#else
#define BLOCK_WORDS 1
#endif

typedef struct block {
    uint32_t words[BLOCK_WORDS];
} block;

static int aligned(const void *first, const void *second) {
    return (((uintptr_t)first | (uintptr_t)second) & 3u) == 0;
}

void *memcpy(void *restrict to, const void *restrict from, size_t count) {
    uint8_t *out = to;
    const uint8_t *in = from;

    if (aligned(to, from)) {
        for (; count >= 4 * sizeof(block); count -= 4 * sizeof(block)) {
            *(block *)(void *)out = *(const block *)(const void *)in;
            *(block *)(void *)(out + sizeof(block)) = *(const block *)(const void *)(in + sizeof(block));
            *(block *)(void *)(out + 2 * sizeof(block)) = *(const block *)(const void *)(in + 2 * sizeof(block));
            *(block *)(void *)(out + 3 * sizeof(block)) = *(const block *)(const void *)(in + 3 * sizeof(block));
            out += 4 * sizeof(block);
            in += 4 * sizeof(block);
        }
        for (; count >= sizeof(block); count -= sizeof(block), out += sizeof(block), in += sizeof(block)) {
            *(block *)(void *)out = *(const block *)(const void *)in;
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
        block words;
        for (int i = 0; i < BLOCK_WORDS; i++) {
            words.words[i] = word;
        }
        for (; count >= 4 * sizeof(block); count -= 4 * sizeof(block), out += 4 * sizeof(block)) {
            *(block *)(void *)out = words;
            *(block *)(void *)(out + sizeof(block)) = words;
            *(block *)(void *)(out + 2 * sizeof(block)) = words;
            *(block *)(void *)(out + 3 * sizeof(block)) = words;
        }
        for (; count >= sizeof(block); count -= sizeof(block), out += sizeof(block)) {
            *(block *)(void *)out = words;
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
