/* SPDX-License-Identifier: MIT */
/*
 * Normalisation. Variant `root`: 1/sqrt(c) in Q15 for c from 1/4 to 1 in Q30, the range that a shift by an even number
 * of bits brings any c to. Variant `vector`: a vector of three int32 made unit, in all.
 */
#include "math/numeric.h"
#include "methods.h"

static const int32_t no_points[1] = {0};

/* ---- 1/sqrt(c) ---- */

static void input_root(uint64_t index, int32_t *in) {
    in[0] = (1 << 28) + (int32_t)index;
}

static void bench_root(uint32_t i, int32_t *in) {
    input_root(method_hash(i) % (3u << 28), in);
}

static inline void empty_root_one(const int32_t *in, int32_t *out) {
    out[0] = in[0];
}
METHOD_LOOP(empty_root, 1, 1)

static const method_problem root = {METHOD_ROOT, "normalise", "every c from 1/4 to 1 in Q30",
                                    "call",      1,           1,
                                    1,           3u << 28,    12289,
                                    no_points,   1,           0,
                                    input_root,  bench_root,  empty_root};

static uint16_t table[49]; /* 1/sqrt, Q15; 1/sqrt(1/4) does not fit and is 65535 */

/* 2^30 / sqrt(c), c from 2^28 to 2^30: Q15. */
static uint32_t root_q15(uint32_t c) {
    const uint64_t inverse = ((uint64_t)1 << 60) / c; /* Q30, 2^30 to 2^32 */
    const uint32_t whole = inverse > 0xffffffffu ? 0xffffffffu : (uint32_t)inverse;
    const uint32_t half = method_square_root(whole);
    return half + (whole - half * half > half);
}

static uint16_t clamp16(uint32_t x) {
    return (uint16_t)(x < 65536 ? x : 65535);
}

/* Each entry is right in the middle of what it stands for. */
static void prepare_nearest(int32_t p) {
    (void)p;
    for (uint32_t i = 0; i < 48; i++) {
        table[i] = clamp16(root_q15(((16 + i) << 24) + (1u << 23)));
    }
}

/* Nodes lowered by half of what a chord lies above the curve, where they have neighbours. */
static void prepare_linear(int32_t p) {
    (void)p;
    for (uint32_t i = 0; i <= 48; i++) {
        uint32_t value = root_q15((16 + i) << 24);
        if (i > 0 && i < 48) {
            value -= (root_q15((15 + i) << 24) - 2 * value + root_q15((17 + i) << 24)) / 16;
        }
        table[i] = clamp16(value);
    }
}

static inline uint32_t linear_6(uint32_t c) {
    const uint16_t *at = &table[(c >> 24) - 16];
    return (uint32_t)(at[0] - glint_shift_right((at[0] - at[1]) * (int32_t)(c >> 8 & 0xffff), 16));
}

/* r (3 - c r^2) / 2 (Newton), r Q15 below 2^16. */
static inline uint32_t newton(uint32_t c) {
    const uint32_t r = table[(c >> 24) - 16];
    const uint32_t product = (c >> 14) * ((r * r) >> 16); /* c r^2, Q30 */
    return (r * (((3u << 30) - product) >> 16) + 0x4000) >> 15;
}

static inline uint32_t root_and_divide(uint32_t c) {
    const uint32_t s = method_square_root(c); /* Q15 */
    return ((1u << 30) + s / 2) / s;
}

static inline uint32_t library_root(uint32_t c) {
    return (uint32_t)glint_inverse_root(c);
}

#define ROOT(name)                                                          \
    static inline void root_##name##_one(const int32_t *in, int32_t *out) { \
        out[0] = (int32_t)name((uint32_t)in[0]);                            \
    }                                                                       \
    METHOD_LOOP(root_##name, 1, 1)

ROOT(linear_6)
ROOT(newton)
ROOT(root_and_divide)
ROOT(library_root)

/* ---- Vectors ---- */

static int32_t random_component(uint32_t seed, unsigned bits) {
    return glint_shift_right((int32_t)method_hash(seed), 32 - bits);
}

/* Components of 8 to 30 bits, some of them much smaller than the largest. */
static void input_vector(uint64_t index, int32_t *in) {
    const uint32_t seed = (uint32_t)index * 4;
    const uint32_t choice = method_hash(seed);
    const unsigned bits = 8 + choice % 23;
    for (uint32_t i = 0; i < 3; i++) {
        const unsigned less = i == (choice >> 16) % 3 ? 0 : (choice >> (8 + 4 * i)) % 8;
        in[i] = random_component(seed + 1 + i, bits - less < 2 ? 2 : bits - less);
    }
    in[(choice >> 16) % 3] |= 1 << (bits - 2);
}

static void bench_vector(uint32_t i, int32_t *in) {
    input_vector(i, in);
}

static inline void empty_vector_one(const int32_t *in, int32_t *out) {
    out[0] = in[0];
    out[1] = in[1];
    out[2] = in[2];
}
METHOD_LOOP(empty_vector, 3, 3)

static const method_problem vector = {METHOD_UNIT_VECTOR,
                                      "normalise",
                                      "random vectors of 8 to 30 bits",
                                      "call",
                                      1,
                                      3,
                                      3,
                                      1u << 24,
                                      61,
                                      no_points,
                                      1,
                                      0,
                                      input_vector,
                                      bench_vector,
                                      empty_vector};

/* Components to 14 bits and a sign, the largest between 2^13 and 2^14. @return the length's square, 2^26 to 3 2^28 */
static inline uint32_t reduce(const int32_t *in, int32_t v[3]) {
    const unsigned zeros = glint_leading_zeros(glint_magnitude_bits(in[0]) | glint_magnitude_bits(in[1]) |
                                               glint_magnitude_bits(in[2]) | 1);
    for (int i = 0; i < 3; i++) {
        v[i] = zeros < 18 ? glint_shift_right(glint_shift_right(in[i], 17 - zeros) + 1, 1)
                          : glint_shift_left(in[i], zeros - 18);
    }
    return (uint32_t)(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static inline void scale(const int32_t v[3], uint32_t r, unsigned down, int32_t *out) {
    for (int i = 0; i < 3; i++) {
        out[i] = glint_shift_right(v[i] * (int32_t)r + (1 << (down - 1)), down);
    }
}

/* With a root for c from 1/4 to 1. */
#define VECTOR(name)                                                          \
    static inline void vector_##name##_one(const int32_t *in, int32_t *out) { \
        int32_t v[3];                                                         \
        uint32_t c = reduce(in, v);                                           \
        unsigned down = 15;                                                   \
        if (c < 1u << 28) {                                                   \
            c <<= 2;                                                          \
            down = 14;                                                        \
        }                                                                     \
        scale(v, name(c), down, out);                                         \
    }                                                                         \
    METHOD_LOOP(vector_##name, 3, 3)

VECTOR(linear_6)

/* 64 bits throughout: what a general fixed-point library does. */
static inline void vector_wide_one(const int32_t *in, int32_t *out) {
    const unsigned zeros = glint_leading_zeros(glint_magnitude_bits(in[0]) | glint_magnitude_bits(in[1]) |
                                               glint_magnitude_bits(in[2]) | 1);
    int32_t v[3];
    uint64_t c = 0;
    for (int i = 0; i < 3; i++) {
        v[i] = zeros > 2 ? glint_shift_left(in[i], zeros - 2) : in[i];
        c += (uint64_t)((int64_t)v[i] * v[i]);
    }
    uint64_t length = 0;
    for (uint64_t bit = (uint64_t)1 << 62; bit != 0; bit >>= 2) {
        if (c >= length + bit) {
            c -= length + bit;
            length = (length >> 1) + bit;
        } else {
            length >>= 1;
        }
    }
    for (int i = 0; i < 3; i++) {
        out[i] = (int32_t)((int64_t)v[i] * 32768 / (int64_t)length);
    }
}
METHOD_LOOP(vector_wide, 3, 3)

static inline void vector_library_one(const int32_t *in, int32_t *out) {
    int16_t unit[3];
    glint_unit(in[0], in[1], in[2], unit);
    out[0] = unit[0];
    out[1] = unit[1];
    out[2] = unit[2];
}
METHOD_LOOP(vector_library, 3, 3)

static const method methods[] = {
    METHOD(&root, "table 6 bit linear", "root", "", 0, 0, 1 << 15, 98, prepare_linear, root_linear_6, 71),
    METHOD(&root, "table 6 bit and Newton", "root", "", 0, 0, 1 << 15, 96, prepare_nearest, root_newton, 94),
    METHOD(&root, "square root and division", "root", "Woo 1985", 0, 0, 1 << 15, 0, 0, root_root_and_divide, 18),
    METHOD(&root, "glint_inverse_root", "root", "", 1, 0, GLINT_UNIT, 708, 0, root_library_root, 14),
    METHOD(&vector, "table 6 bit linear", "vector", "", 0, 0, 1 << 15, 98, prepare_linear, vector_linear_6, 76),
    METHOD(&vector, "64 bit root and divisions", "vector", "", 0, 0, 1 << 15, 0, 0, vector_wide, 8),
    METHOD(&vector, "glint_unit", "vector", "", 1, 0, GLINT_UNIT, 708, 0, vector_library, 19),
};

const method_list methods_normalise = METHOD_LIST(methods);
