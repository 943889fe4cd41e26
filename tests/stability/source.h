/* SPDX-License-Identifier: MIT */
/** @file source.h Random numbers of scenes that a seed makes, the same whoever compiles them. */
#ifndef GLINT_STABILITY_SOURCE_H
#define GLINT_STABILITY_SOURCE_H

#include <stdint.h>

/* C leaves open in which order the arguments of a call, the items of a list and the operands of an operator are
 * computed: no expression draws twice. */
typedef struct source {
    uint64_t state;
} source;

/** 64 bits: SplitMix64 (Steele, Lea and Flood, 2014). */
static inline uint64_t next(source *random) {
    uint64_t z = random->state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/** From 0 to limit - 1. */
static inline uint32_t below(source *random, uint32_t limit) {
    return (uint32_t)((next(random) >> 32) * limit >> 32);
}

static inline int one_in(source *random, uint32_t count) {
    return below(random, count) == 0;
}

#endif
