/* SPDX-License-Identifier: MIT */
/**
 * @file random.h
 * Numbers that look random, the same on every machine, for a file of tests: each has a state of its own, which it may
 * set.
 */
#ifndef GLINT_TESTS_RANDOM_H
#define GLINT_TESTS_RANDOM_H

#include <stdint.h>

static uint32_t random_state = 1;

/** 24 bits of a linear congruential generator (Numerical Recipes). */
static inline uint32_t random_bits(void) {
    random_state = random_state * 1664525u + 1013904223u;
    return random_state >> 8;
}

/** From 0 to limit - 1. */
static inline uint32_t below(uint32_t limit) {
    return random_bits() % limit;
}

/** From least to most. */
static inline int any(int least, int most) {
    return least + (int)below((uint32_t)(most - least + 1));
}

/** From least to most, which it does not reach. */
static inline double between(double least, double most) {
    return least + (most - least) * random_bits() / 16777216.0;
}

#endif
