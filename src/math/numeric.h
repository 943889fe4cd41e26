/* SPDX-License-Identifier: MIT */
/**
 * @file numeric.h
 * Fixed-point arithmetic, and the one table of every number format inside glint.
 *
 * | quantity | space | format | range | guaranteed by |
 * | --- | --- | --- | --- | --- |
 * | API scalars | | Q16.16, int32 | | caller |
 * | mesh position | object | int16 steps of extent / 2^15 | | caller |
 * | mesh normal | object | int16 Q15 | not 0 | caller |
 * | matrix to clip space | | int32, block exponent per object | sum of a row's magnitudes < 3 2^28 | transform.c |
 * | clip coordinates x, y, w | clip: guard band at x, y = +-w | int32, same exponent | < 3 2^28 | transform.c |
 * | normal matrix | camera | int32, a turn has rows of length 2^13 UNIT | sum of squares <= 3 2^56 | transform.c |
 * | unit vector | camera | int16, 1 = GLINT_UNIT | length 32764 +-2.3 | glint_unit |
 * | normal of a vertex | camera | int16, 1 = GLINT_UNIT | length 32752 to 32768 | geometry.c |
 * | screen x, y | screen | int16 28.4 | strictly within +-1023 px of the centre | clip.c |
 * | 1/w of a vertex | screen | int32 Q31 of the frame's nearest | 2^6 to 2^31 - 2^16 | geometry.c |
 * | 1/w of a fragment | screen | int32 Q31 of the frame's nearest | 0 to 2^31 - 1 | draw.c |
 * | depth | screen | uint16, (1/w >> 15) + 1 | 1 to 65535, 0 is empty | draw.c |
 * | normal or colour over w | screen | int32, scaled per triangle | +-2^30 | draw.c |
 * | colour of a vertex or facet | | int16, 1 = 32767 | 0 to 32767 | glint_finish_corner |
 * | strength of a light with a position | | uint16 Q15 | 0 to 2^15 | point.c |
 * | twice a triangle's area | screen | int32, 28.4 squared | < 2^31 | guard band |
 * | light weight (light times material) | | uint32 Q12 | 0 to 16 | shading.c |
 * | power table | | uint16 Q15 | 0 to 2^15 | power.c |
 * | channel of a pixel | | int32 Q27 | 0 to 15; a plane's up to 2^-12 beyond its corners' | draw.c |
 * | fragment colour | | uint32 Q23 | below 2^32: 8 lights of 2 x 16, ambient 16 | shading.c |
 */
#ifndef GLINT_NUMERIC_H
#define GLINT_NUMERIC_H

#include <limits.h>
#include <stdint.h>

/** A unit vector has this length: a little below 2^15, so that its rounded components always fit int16. */
#define GLINT_UNIT 32764

/** Forbids inlining, so that the calling loop keeps its registers. */
#if defined(__GNUC__)
#define GLINT_NOINLINE __attribute__((noinline))
#else
#define GLINT_NOINLINE
#endif

/** Forces inlining: into one caller, or into each with its own constant arguments. */
#if defined(__GNUC__)
#define GLINT_INLINE inline __attribute__((always_inline))
#else
#define GLINT_INLINE inline
#endif

/** Marks functions that loop over pixels. With GLINT_HOT_SECTION, such as ".glint_hot", each is in a section whose name
 * begins so, which a linker script may put into RAM. */
#if defined(GLINT_HOT_SECTION)
#define GLINT_HOT_NAMED(name, number) __attribute__((section(name "." #number)))
#define GLINT_HOT_NUMBERED(name, number) GLINT_HOT_NAMED(name, number)
#define GLINT_HOT GLINT_HOT_NUMBERED(GLINT_HOT_SECTION, __COUNTER__)
#else
#define GLINT_HOT
#endif

/** Marks a function of its arguments alone: the compiler may keep values in registers across the call. */
#if defined(__GNUC__)
#define GLINT_CONST __attribute__((const))
#else
#define GLINT_CONST
#endif

/** Says that a condition is seldom true. */
#if defined(__GNUC__)
#define GLINT_RARELY(x) __builtin_expect((x) != 0, 0)
#else
#define GLINT_RARELY(x) (x)
#endif

/** Declares a symbol that a descriptor names and only another descriptor needs. It is defined in a file that the other
 * brings into the link, and is null elsewhere. So a light type and an evaluation link what needs both. */
#if (defined(__ELF__) || defined(__wasm__)) && defined(__GNUC__)
#define GLINT_IF_LINKED __attribute__((weak))
#else
#define GLINT_IF_LINKED
#endif

/** Is the library built for size? Then shortcuts that change no result are left out. */
#if defined(__OPTIMIZE_SIZE__)
#define GLINT_SMALL 1
#else
#define GLINT_SMALL 0
#endif

/** Forces inlining into callers that each know some arguments. For size, there is one function for all. */
#if GLINT_SMALL
#define GLINT_SPECIAL GLINT_NOINLINE
#else
#define GLINT_SPECIAL GLINT_INLINE
#endif

/** Hides the value of a loop variable from the compiler, so that it does not transform the loop. */
#if defined(__GNUC__)
#define GLINT_OPAQUE(x) __asm__("" : "+r"(x))
#else
#define GLINT_OPAQUE(x) ((void)0)
#endif

/** Prevents the compiler from moving later code ahead, which would take registers. */
#if defined(__GNUC__)
#define GLINT_BARRIER() __asm__ volatile("")
#else
#define GLINT_BARRIER() ((void)0)
#endif

/** States what callers guarantee. Tests under sanitizers check it at every call (tests/tests.mk). */
#ifndef GLINT_REQUIRE
#define GLINT_REQUIRE(condition) ((void)0)
#endif

/* Right shifts of negative numbers are arithmetic on every compiler glint knows; this fails to compile elsewhere. */
typedef char glint_arithmetic_shift[(-1 >> 1) == -1 ? 1 : -1];

/* Products and sums have 32 bits. With a narrower or a wider int the results would differ. */
typedef char glint_int_of_32_bits[INT_MAX == 0x7fffffff ? 1 : -1];

extern const uint16_t glint_inverse_root_table[354];
extern const uint16_t glint_root_table[960];
extern const uint32_t glint_length_table[192];
extern const uint32_t glint_log2_inverse_table[32];
extern const uint32_t glint_log2_table[32];
extern const uint32_t glint_exp2_table[32];

/** Computes floor(x / 2^n), n from 0 to 31. */
static inline int32_t glint_shift_right(int32_t x, unsigned n) {
    GLINT_REQUIRE(n < 32);
    return x >> n;
}

/** Computes floor(x / 2^n), n from 0 to 63. */
static inline int64_t glint_shift_right64(int64_t x, unsigned n) {
    GLINT_REQUIRE(n < 64);
    return x >> n;
}

/** Computes x / 2^n rounded to nearest, halves up; n from 1 to 62, |x| at most 2^62. */
static inline int64_t glint_round_shift64(int64_t x, unsigned n) {
    GLINT_REQUIRE(n - 1 < 62 && x <= (int64_t)1 << 62 && x >= -((int64_t)1 << 62));
    return glint_shift_right64(x + ((int64_t)1 << (n - 1)), n);
}

/** Computes x 2^n for either sign, n from 0 to 31, modulo 2^32. */
static inline int32_t glint_shift_left(int32_t x, unsigned n) {
    GLINT_REQUIRE(n < 32);
    return (int32_t)((uint32_t)x << n);
}

/** Computes x + y modulo 2^32. Planes are evaluated so: the result is right wherever the true value fits. */
static inline int32_t glint_add_wrap(int32_t x, int32_t y) {
    return (int32_t)((uint32_t)x + (uint32_t)y);
}

/** Computes x y modulo 2^32. */
static inline int32_t glint_multiply_wrap(int32_t x, int32_t y) {
    return (int32_t)((uint32_t)x * (uint32_t)y);
}

/** Does the core count leading zeros? */
#ifndef GLINT_COUNTS_ZEROS
#if (defined(__arm__) && !defined(__ARM_FEATURE_CLZ)) || (defined(__riscv) && !defined(__riscv_zbb))
#define GLINT_COUNTS_ZEROS 0
#else
#define GLINT_COUNTS_ZEROS 1
#endif
#endif

/** Counts the leading zero bits of x, 32 for 0, where neither core nor compiler do. */
GLINT_CONST unsigned glint_leading_zeros_by_table(uint32_t x);

/** Counts the leading zero bits of x, 32 for 0. */
static inline unsigned glint_leading_zeros(uint32_t x) {
#if defined(__GNUC__) && (GLINT_COUNTS_ZEROS || GLINT_SMALL)
    return x ? (unsigned)__builtin_clz(x) : 32u;
#else
    return glint_leading_zeros_by_table(x);
#endif
}

/** Returns the bits that x needs: 0 for 0, 64 from 2^63 on. */
static inline unsigned glint_bits64(uint64_t x) {
    uint32_t high = (uint32_t)(x >> 32);
    return high ? 64u - glint_leading_zeros(high) : 32u - glint_leading_zeros((uint32_t)x);
}

static inline uint64_t glint_magnitude64(int64_t x) {
    return x < 0 ? 0u - (uint64_t)x : (uint64_t)x;
}

static inline int32_t glint_least(int32_t a, int32_t b) {
    return a < b ? a : b;
}

static inline int32_t glint_most(int32_t a, int32_t b) {
    return a > b ? a : b;
}

static inline int32_t glint_least_of(int32_t a, int32_t b, int32_t c) {
    return glint_least(glint_least(a, b), c);
}

static inline int32_t glint_most_of(int32_t a, int32_t b, int32_t c) {
    return glint_most(glint_most(a, b), c);
}

/** Returns |x| or |x| - 1, which suffices to find how many bits a component needs. */
static inline uint32_t glint_magnitude_bits(int32_t x) {
    return (uint32_t)(x ^ glint_shift_right(x, 31));
}

/* Interpolates between two nodes of the table of roots. */
static inline int32_t glint_inverse_root_between(const uint16_t node[2], uint32_t c) {
    const int32_t fraction = (int32_t)((c >> 7) & 0xffff);
    return node[0] - glint_shift_right((node[0] - node[1]) * fraction + 0x8000, 16);
}

/** Computes UNIT / sqrt(c) for c from 2^28 to 3 2^30 as an integer, times 2^15, by linear interpolation. The relative
 * error is at most 5.44e-5. */
static inline int32_t glint_inverse_root(uint32_t c) {
    GLINT_REQUIRE(c >= 1u << 28 && c <= 3u << 30);
    return glint_inverse_root_between(&glint_inverse_root_table[(c >> 23) - 32], c);
}

/** Computes 2^31 / sqrt(c) for c from 2^30 up: the result is from 2^15 to 2^16, its relative error at most 4e-5. */
static inline uint32_t glint_over_length(uint32_t c) {
    GLINT_REQUIRE(c >= 1u << 30);
    const uint32_t word =
        *(const uint32_t *)(const void *)((const uint8_t *)glint_length_table + (4 * (int32_t)(c >> 24) - 256));
    return (word - (word & 0xffff) * (c >> 8 & 0xffff)) >> 16;
}

/** Does what glint_unit does, for the loops over fragments. */
static inline void glint_unit_inline(int32_t x, int32_t y, int32_t z, int16_t out[3]) {
    unsigned zeros = glint_leading_zeros(glint_magnitude_bits(x) | glint_magnitude_bits(y) | glint_magnitude_bits(z));
    if (zeros < 17) { /* scale the largest component to 2^14 .. 2^15 */
        unsigned n = 16 - zeros;
        x = glint_shift_right(glint_shift_right(x, n) + 1, 1);
        y = glint_shift_right(glint_shift_right(y, n) + 1, 1);
        z = glint_shift_right(glint_shift_right(z, n) + 1, 1);
    } else {
        x = glint_shift_left(x, zeros - 17);
        y = glint_shift_left(y, zeros - 17);
        z = glint_shift_left(z, zeros - 17);
    }
    uint32_t c = (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z); /* 2^28 .. 3 2^30, or 0 */
    int32_t r = c ? glint_inverse_root(c) : 0;
    out[0] = (int16_t)glint_shift_right(x * r + 0x4000, 15);
    out[1] = (int16_t)glint_shift_right(y * r + 0x4000, 15);
    out[2] = (int16_t)glint_shift_right(z * r + 0x4000, 15);
}

/** Computes the unit vector in the direction of (x, y, z), of any int32 components; 0 for 0. Each component is off by
 * at most 2.3 steps from direction times UNIT, length by at most 2.3. */
void glint_unit(int32_t x, int32_t y, int32_t z, int16_t out[3]);

/** Computes a . b of two unit vectors. 1 is UNIT^2, just below 2^30; rounding may pass it by 2^-12 of it. */
static inline int32_t glint_dot(const int16_t a[3], const int16_t b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** Computes a . b, which has to fit 32 bits. */
static inline int32_t glint_dot32(const int32_t a[3], const int32_t b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** Computes 2^63 / x for x from 2^31, rounded down or nearly so: below 2^32, relative error at most 1.64e-9. It is one
 * Newton step from a 16-bit division. */
uint32_t glint_reciprocal(uint32_t x);

/** Computes the binary logarithm of x / 2^31, x from 1 to 2^31: Q26, -31 to 0, off by at most 1.93 steps. 0 gives
 * -32. */
int32_t glint_log2(uint32_t x);

/** Computes 2^y for y Q26, 0 or below: Q30, at most 2^30, off by at most 12.8 steps. */
uint32_t glint_exp2(int32_t y);

/** Computes (x / 2^31)^p for x from 0 to 2^31 and p Q16.16 from 0 up: Q30, at most 2^30. 0^0 is 1. It is off by at most
 * 25 steps up to p = 2, 220 at 32, 7050 at 1024: 7 for each unit of p. */
uint32_t glint_power(uint32_t x, int32_t p);

/** Computes the sine of a phase, 2^32 to the full angle: Q30, -2^30 to 2^30, off by at most 64.7 steps. */
int32_t glint_sine(uint32_t phase);

/** Computes the square root, rounded down. */
uint32_t glint_square_root(uint64_t x);

/** Converts degrees, Q16.16, to a phase, 2^32 to the full angle; off by at most 0.556 steps. */
uint32_t glint_phase(int32_t degrees);

#endif
