/* SPDX-License-Identifier: MIT */
/** @file depth.h This is the only depth test. A tile keeps a depth of 16 bits for each pixel, 0 where nothing has been
 * drawn. Larger is nearer, and of equal depths the first drawn stays. */
#ifndef GLINT_DEPTH_H
#define GLINT_DEPTH_H

#include "../math/product.h"

/** This is added to 1/w in Q31 before it is cut to 16 bits, so that the farthest surfaces still count as nearer than
 * nothing. */
#define GLINT_DEPTH_BIAS (1u << 15)

/** Tests the depth at `place`, and stores it where it is nearer. @return 0 for a hidden pixel */
static inline int glint_is_nearest(uint8_t *place, uint32_t z) {
    uint16_t *depth = (uint16_t *)(void *)place;
    if (z >> 15 <= *depth)
        return 0;
    *depth = (uint16_t)(z >> 15);
    return 1;
}

/*
 * Loops over pixels step through depth. Most cores load and step in one instruction: there a loop steps as it tests,
 * and is so many bytes ahead when it stores. ARMv6-M, whose stores reach nothing behind their base, steps after the
 * store.
 */
#if GLINT_SPLIT_PRODUCTS
#define GLINT_AHEAD 0
#else
#define GLINT_AHEAD 2
#endif

/** Tests the depth at `*place` as glint_is_nearest does, and steps on where GLINT_AHEAD says so. */
static GLINT_INLINE int glint_next_is_nearest(uint8_t **place, uint32_t z) {
    if (!GLINT_AHEAD)
        return glint_is_nearest(*place, z);
    const uint32_t there = *(const uint16_t *)(const void *)*place;
    *place += GLINT_AHEAD;
    GLINT_OPAQUE(*place);
    if (z >> 15 <= there)
        return 0;
    *(uint16_t *)(void *)(*place - GLINT_AHEAD) = (uint16_t)(z >> 15);
    return 1;
}

/** Steps on where glint_next_is_nearest has not. */
static GLINT_INLINE void glint_step(uint8_t **place) {
    if (GLINT_AHEAD)
        return;
    *place += 2;
    GLINT_OPAQUE(*place);
}

/** Returns the position of a loop that has tested the depth of a tile's first pixel. */
static inline const uint16_t *glint_ahead(const uint16_t *depth) {
    const uint16_t *ahead = depth + GLINT_AHEAD / 2;
    if (GLINT_AHEAD)
        GLINT_OPAQUE(ahead);
    return ahead;
}

/** Returns the index of the pixel of a tile that was depth-tested last, in pixels. */
static inline uint32_t glint_pixel_of(const uint16_t *ahead, const uint8_t *place) {
    return (uint32_t)((const uint16_t *)(const void *)place - ahead);
}

#endif
