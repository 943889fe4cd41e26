/* SPDX-License-Identifier: MIT */
/**
 * @file spread.h
 * A colour as one word, "spread": blue in bits 0 to 8, red in 10 to 19, green in 21 to 30. Of these the lowest 4, 5 and
 * 4 are fractions of a level of 5, 5 and 6 bits. The bit above each channel is clear, so that two words can be added.
 */
#ifndef GLINT_SPREAD_H
#define GLINT_SPREAD_H

#include <stdint.h>

#define GLINT_SPREAD_GUARD 0x80100200u

/** A pixel of a tile, and its colour; and N'.N' there, 1 = 2^32, and 2^14 over its root, where it is lit: suns.h. */
typedef struct glint_spread {
    uint32_t offset, colour, square, over;
} glint_spread;

/** A word packed into 16 bits: 5 red, 6 green, 5 blue; what is above them is to be cut off. */
static inline uint32_t glint_spread_pack(uint32_t word) {
#if defined(__ARM_FEATURE_SAT) && defined(__GNUC__)
    union {
        uint32_t word;
        struct {
            uint32_t blue : 5, green : 6, red : 21;
        } part;
    } packed; /* green is inserted by one instruction */
    packed.word = word >> 4;
    packed.part.green = word >> 25 & 63;
    return packed.word;
#else
    const uint32_t levels = word >> 4 & 0x07e0f81fu; /* red and blue in place, green 16 bits above its own */
    return levels | levels >> 16;
#endif
}

/** A sum of two words, each channel clamped: a guard bit that is set sets the nine below. */
static inline uint32_t glint_spread_clamp(uint32_t word) {
    uint32_t over = word & GLINT_SPREAD_GUARD;
    return word | (over - (over >> 9));
}

/** A sum of two words with a threshold in 1/128 level, as 16 bits; of that, words have 1/16 of blue and green. */
static inline uint32_t glint_spread_565(uint32_t word, uint32_t threshold) {
    return glint_spread_pack(glint_spread_clamp(word + (threshold >> 3) * 0x00200801u));
}

#endif
