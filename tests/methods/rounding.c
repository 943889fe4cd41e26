/* SPDX-License-Identifier: MIT */
/*
 * From a colour, Q23, to one of the 64 levels of green in RGB565, at 8 x 8 pixels. Variant `pixel`: what a pixel is off
 * by; variant `8 x 8`: what their mean is off by, which is what the eye sees of dithering.
 */
#include "methods.h"
#include "pixel/pixel.h"

enum { PIXELS = 64, BITS = 6, TOP = (1 << BITS) - 1 };

static const int32_t no_points[1] = {0};

static void input_value(uint64_t index, int32_t *in) {
    in[0] = (int32_t)index;
}

static void bench_value(uint32_t i, int32_t *in) {
    in[0] = (int32_t)(method_hash(i) >> 9);
}

static inline void empty_one(const int32_t *in, int32_t *out) {
    for (int i = 0; i < PIXELS; i++) {
        out[i] = *(const volatile int32_t *)in;
    }
}
METHOD_LOOP(empty, 1, PIXELS)

static const method_problem pixel = {METHOD_LEVEL,
                                     "rounding",
                                     "every value in Q23 at 8 x 8 pixels",
                                     "pixel",
                                     PIXELS,
                                     1,
                                     PIXELS,
                                     (1 << 23) + 1,
                                     127,
                                     no_points,
                                     1,
                                     0,
                                     input_value,
                                     bench_value,
                                     empty};
static const method_problem mean = {METHOD_MEAN_LEVEL,
                                    "rounding",
                                    "every value in Q23; mean of 8 x 8 pixels",
                                    "pixel",
                                    PIXELS,
                                    1,
                                    PIXELS,
                                    (1 << 23) + 1,
                                    127,
                                    no_points,
                                    1,
                                    0,
                                    input_value,
                                    bench_value,
                                    empty};

/* Each pixel's level is found anew, as if each had a colour of its own. */
#define ROUNDING(name)                                                        \
    static inline void name##_one(const int32_t *in, int32_t *out) {          \
        for (uint32_t i = 0; i < PIXELS; i++) {                               \
            out[i] = (int32_t)name##_level(*(const volatile int32_t *)in, i); \
        }                                                                     \
    }                                                                         \
    METHOD_LOOP(name, 1, PIXELS)

/* 8 bits, 1 is 255. */
static inline uint32_t byte_of(int32_t value) {
    return (uint32_t)(value < 1 << 23 ? value >> 15 : 255);
}

static inline uint32_t truncate_level(int32_t value, uint32_t i) {
    (void)i;
    return byte_of(value) >> 2;
}
ROUNDING(truncate)

static inline uint32_t byte_nearest_level(int32_t value, uint32_t i) {
    (void)i;
    const uint32_t level = (byte_of(value) + 2) >> 2;
    return level < TOP ? level : TOP;
}
ROUNDING(byte_nearest)

/* By the library: scaled, half a level included, and cut off. */
static inline uint32_t level_of(int32_t value, uint32_t threshold) {
    return glint_level(glint_to_levels(value * (1 << (GLINT_CHANNEL_BITS - 23)), BITS), BITS, threshold);
}

static inline uint32_t down_level(int32_t value, uint32_t i) {
    (void)i;
    return level_of(value, 0);
}
ROUNDING(down)

static inline uint32_t nearest_level(int32_t value, uint32_t i) {
    (void)i;
    return level_of(value, GLINT_NEAREST);
}
ROUNDING(nearest)

static inline uint32_t dithered_level(int32_t value, uint32_t i) {
    static const glint_target target = {0, 3, 1};
    return level_of(value, glint_threshold(&target, i));
}
ROUNDING(dithered)

/* A threshold for each pixel without a pattern. */
static inline uint32_t random_level(int32_t value, uint32_t i) {
    return level_of(value, method_hash(i) >> 25);
}
ROUNDING(random)

#define BOTH(name, source, shipped, bytes, function, error, mean_error)                \
    METHOD(&pixel, name, "pixel", source, shipped, 0, TOP, bytes, 0, function, error), \
        METHOD(&mean, name, "8 x 8", source, shipped, 0, TOP, bytes, 0, function, mean_error)

static const method methods[] = {
    BOTH("truncate 8 bits", "", 0, 0, truncate, 3990, 3990),
    BOTH("round 8 bits", "", 0, 0, byte_nearest, 5990, 5990),
    BOTH("times 63 truncated", "", 0, 0, down, 4060, 4060),
    BOTH("times 63 rounded", "", 1, 0, nearest, 2030, 2030),
    BOTH("dithered 8 x 8", "Bayer 1973", 1, 64, dithered, 4020, 32),
    BOTH("dithered at random", "Roberts 1962", 0, 0, random, 4060, 507),
};

const method_list methods_rounding = METHOD_LIST(methods);
