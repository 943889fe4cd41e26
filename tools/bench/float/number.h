/* SPDX-License-Identifier: MIT */
/**
 * @file number.h
 * Numbers, triples and pixels of the float renderer.
 *
 * Colours are kept in levels: a channel's value times the highest level, in units that put the level into the upper
 * bits of a word. What is above 1 is clamped by the conversion, which stops at the largest word.
 */
#ifndef FLOAT_NUMBER_H
#define FLOAT_NUMBER_H

#include "renderer.h"

#define FLOAT_INLINE static inline __attribute__((always_inline))

/** 1 of a channel in levels, and half a level. */
#define FLOAT_RED (31.0f * 134217728.0f)
#define FLOAT_GREEN (63.0f * 67108864.0f)
#define FLOAT_BLUE FLOAT_RED
#define FLOAT_HALF_RED 67108864.0f
#define FLOAT_HALF_GREEN 33554432.0f
#define FLOAT_HALF_BLUE FLOAT_HALF_RED

/** What makes the whole part of x the first column whose centre is not left of it. */
#define FLOAT_COLUMN (0.5f - 1.0f / 4096)

FLOAT_INLINE float float_of(glint_q16 value) {
    return (float)value * (1.0f / 65536);
}

FLOAT_INLINE float float_root(float square) {
    return __builtin_sqrtf(square);
}

FLOAT_INLINE int32_t float_bits(float value) {
    int32_t bits;

    __builtin_memcpy(&bits, &value, sizeof bits);
    return bits;
}

/** The whole part, 0 below 0 and UINT32_MAX above what a word holds. */
FLOAT_INLINE uint32_t float_whole(float value) {
#if defined __ARM_FP && __ARM_FP & 4
    float word;
    uint32_t result;

    __asm__("vcvt.u32.f32 %0, %1" : "=t"(word) : "t"(value));
    __builtin_memcpy(&result, &word, sizeof result);
    return result;
#else
    return !(value > 0) ? 0 : value >= 4294967296.0f ? UINT32_MAX : (uint32_t)value;
#endif
}

/* ---- Triples */

FLOAT_INLINE float_triple triple(float x, float y, float z) {
    return (float_triple){x, y, z};
}

FLOAT_INLINE float_triple triple_of(const int16_t from[3]) {
    return (float_triple){(float)from[0], (float)from[1], (float)from[2]};
}

FLOAT_INLINE float dot(float_triple a, float_triple b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

FLOAT_INLINE float_triple scaled(float_triple a, float by) {
    return (float_triple){a.x * by, a.y * by, a.z * by};
}

FLOAT_INLINE float_triple sum(float_triple a, float_triple b) {
    return (float_triple){a.x + b.x, a.y + b.y, a.z + b.z};
}

FLOAT_INLINE float_triple difference(float_triple a, float_triple b) {
    return (float_triple){a.x - b.x, a.y - b.y, a.z - b.z};
}

FLOAT_INLINE float_triple product(float_triple a, float_triple b) {
    return (float_triple){a.x * b.x, a.y * b.y, a.z * b.z};
}

/** a + b times `by`. */
FLOAT_INLINE float_triple sum_scaled(float_triple a, float_triple b, float by) {
    return (float_triple){a.x + b.x * by, a.y + b.y * by, a.z + b.z * by};
}

FLOAT_INLINE float_triple larger(float_triple a, float_triple b) {
    return (float_triple){a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z};
}

FLOAT_INLINE float_triple unit(float_triple a) {
    const float square = dot(a, a);

    return square > 0 ? scaled(a, 1 / float_root(square)) : a;
}

/* ---- Pixels */

/** A pixel of levels that half a level was added to. */
FLOAT_INLINE uint16_t float_pixel(float_triple level) {
    const uint32_t red = float_whole(level.x) >> 27, green = float_whole(level.y) >> 26,
                   blue = float_whole(level.z) >> 27;

    return (uint16_t)((red << 6 | green) << 5 | blue);
}

#endif
