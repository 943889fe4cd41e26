/* SPDX-License-Identifier: MIT */
/** @file source.h The bytes of an input, read front to back as numbers; behind their end all are 0. */
#ifndef GLINT_FUZZ_SOURCE_H
#define GLINT_FUZZ_SOURCE_H

#include "glint.h"

#include <stdlib.h>

typedef struct source {
    const uint8_t *bytes;
    size_t left;
} source;

/** A number of `count` bytes. */
static inline uint32_t take(source *s, int count) {
    uint32_t value = 0;
    for (; count > 0 && s->left > 0; count--, s->left--)
        value = value << 8 | *s->bytes++;
    return value;
}

/** From 0 to limit - 1. */
static inline uint32_t below(source *s, uint32_t limit) {
    return take(s, limit > 256 ? 2 : 1) % limit;
}

/** Is a byte 1 where it is counted modulo `odds`? Never without bytes. */
static inline int one_in(source *s, uint32_t odds) {
    return below(s, odds) == 1;
}

/** Any number, of any magnitude. */
static inline glint_q16 any(source *s) {
    uint32_t shift = below(s, 32);
    return (int32_t)take(s, 4) >> shift;
}

/** A linear congruential generator (Numerical Recipes): 24 bits from a state that begins as anything. */
static inline uint32_t next_random(uint32_t *state) {
    *state = *state * 1664525u + 1013904223u;
    return *state >> 8;
}

/** Ends the program when a promise is broken. */
static inline void require(int condition) {
    if (!condition)
        abort();
}

static inline void *allocate(size_t size) {
    void *memory = malloc(size > 0 ? size : 1);
    require(memory != NULL);
    return memory;
}

#endif
