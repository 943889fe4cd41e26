/* SPDX-License-Identifier: MIT */
/*
 * The specular power cos^p of an angle, result Q15. What is known of the angle is the method's variant: its cosine in
 * Q16, as products of rounded unit vectors give it; or sin^2 in Q30, which keeps its digits at the centre of a
 * highlight. Tables are built by the library's own power function.
 */
#include "lookup.h"
#include "methods.h"

/** Bits below which a highlight is not seen: half of 2^-11 is 1/16 of an 8-bit step. */
enum { CUT_BITS = 11 };

static const int32_t exponents[] = {1 << 14, 1 << 15, 1 << 16, 1 << 17, 1 << 18, 1 << 19, 1 << 20, 1 << 21,
                                    1 << 22, 1 << 23, 1 << 24, 1 << 25, 1 << 26, 1 << 27, 1 << 28};

/* ---- What is known of the angle ---- */

/* Inside the highlight at p = 64: sin^2 up to 0.18. */
static void bench_cosine(uint32_t i, int32_t *in) {
    in[0] = 65536 - (int32_t)(method_hash(i) % 6000);
}

static void bench_sine(uint32_t i, int32_t *in) {
    in[0] = (int32_t)(method_hash(i) % 193000000);
}

static inline void empty_one(const int32_t *in, int32_t *out) {
    out[0] = in[0];
}
METHOD_LOOP(empty, 1, 1)

#define POWER_PROBLEM(name, quantity, words, items, step, text, in, bench, loop)                                      \
    static const method_problem name = {quantity,  "power",           text,     "call", 1,     words, 1, items, step, \
                                        exponents, METHOD_POINTS_MAX, 64 << 16, in,     bench, loop}

POWER_PROBLEM(power_of_cosine, METHOD_POWER_OF_COSINE, 1, 65537, 1, "every cos in Q16", NULL, bench_cosine, empty);
POWER_PROBLEM(power_of_sine, METHOD_POWER_OF_SINE, 1, (1u << 30) + 1, 16381, "every sin^2 in Q30", NULL, bench_sine,
              empty);
/* ---- A table over the cosine, from 0 to 1 ---- */

static uint16_t node[257]; /* Q15 */

/* (x / 2^31)^p, Q15. */
static uint16_t power_q15(uint32_t x, int32_t p) {
    return (uint16_t)((glint_power(x, p) + (1u << 14)) >> 15);
}

static void prepare_cosine_256(int32_t p) {
    for (uint32_t i = 0; i <= 256; i++) {
        node[i] = power_q15(i << 23, p);
    }
}

static inline void linear_256_one(const int32_t *in, int32_t *out) {
    const int32_t x = in[0] < 65536 ? in[0] : 65535;
    out[0] = lookup_between(&node[x >> 8], x & 255, 8);
}
METHOD_LOOP(linear_256, 1, 1)

/* ---- Tables over a window: [cut, 1] ---- */

static uint32_t cut;    /* first input for which the power is 0 */
static uint32_t shift;  /* brings the cut to 16 bits .. */
static uint32_t factor; /* .. and this, Q15, to 2^31 */

/* 1 - 2^(-bits / q), Q30: where (1 - u)^q falls below 2^-bits. */
static uint32_t find_cut(int32_t q) {
    const int64_t y = ((int64_t)CUT_BITS << 42) / q; /* Q26 */
    return (1u << 30) - glint_exp2(y > 31 << 26 ? -(31 << 26) : (int32_t)-y);
}

/* Nodes of (1 - u)^q for u from 0 to the cut. */
static void prepare_window_nodes(int32_t q) {
    cut = find_cut(q);
    shift = 16 - glint_leading_zeros(cut);
    factor = (1u << 31) / (cut >> shift);
    for (uint32_t i = 0; i <= 128; i++) {
        node[i] = power_q15((1u << 31) - 2 * (uint32_t)((uint64_t)cut * i / 128), q);
    }
}

static inline int32_t look_up_window(uint32_t u) {
    if (u >= cut) {
        return 0;
    }
    const uint32_t at = (u >> shift) * factor; /* below 2^31 */
    return lookup_between(&node[at >> 24], (int32_t)(at >> 12 & 0xfff), 12);
}

static void prepare_sine_window(int32_t p) {
    prepare_window_nodes(p / 2);
}

static inline void sine_window_one(const int32_t *in, int32_t *out) {
    out[0] = look_up_window((uint32_t)in[0]);
}
METHOD_LOOP(sine_window, 1, 1)

/* The window over 1 - cos, of a cosine in Q16. */
static inline void cosine_window_one(const int32_t *in, int32_t *out) {
    out[0] = look_up_window((uint32_t)(65536 - in[0]) << 14);
}
METHOD_LOOP(cosine_window, 1, 1)

/* ---- Logarithm and exponential ---- */

static int32_t exponent;

static void prepare_exponent(int32_t p) {
    exponent = p;
}

static inline void library_power_one(const int32_t *in, int32_t *out) {
    out[0] = (int32_t)((glint_power((uint32_t)in[0] << 15, exponent) + (1u << 14)) >> 15);
}
METHOD_LOOP(library_power, 1, 1)

static uint16_t logarithm[65], exponential[65]; /* log2(1 + i/64) and 2^(i/64) - 1, Q16 */

static void prepare_logarithm(int32_t p) {
    exponent = p;
    for (uint32_t i = 0; i < 65; i++) {
        const uint32_t l = (uint32_t)(glint_log2((1u << 30) + (i << 24)) + (1 << 26)) >> 10;
        const uint32_t e = (glint_exp2((int32_t)(i << 20) - (1 << 26)) - (1u << 29)) >> 13;
        logarithm[i] = (uint16_t)(l < 65536 ? l : 65535);
        exponential[i] = (uint16_t)(e < 65536 ? e : 65535);
    }
}

/* 2^-(y / 2^16), Q15, by `fraction_power`, which takes and gives Q16. */
#define EXPONENTIAL(y, fraction_power) \
    (int32_t)((65536u + (uint32_t)(fraction_power)((0u - (y)) & 0xffffu)) >> (((y) + 0xffffu) >> 16) >> 1)

static inline uint32_t exponential_linear(uint32_t fraction) {
    return (uint32_t)lookup_between(&exponential[fraction >> 10], (int32_t)(fraction & 1023), 10);
}

static inline void logarithm_64_one(const int32_t *in, int32_t *out) {
    const uint32_t x = (uint32_t)in[0];
    out[0] = 0;
    if (x == 0) {
        return;
    }
    const unsigned zeros = glint_leading_zeros(x);
    const uint32_t mantissa = x << zeros; /* Q31 */
    const uint16_t *at = &logarithm[mantissa >> 25 & 63];
    const uint32_t log2 = (uint32_t)lookup_between(at, (int32_t)(mantissa >> 13 & 0xfff), 12);
    const uint64_t y = (uint64_t)((zeros - 15) * 65536u - log2) * (uint32_t)exponent >> 16;
    if (y < 16 << 16) {
        out[0] = EXPONENTIAL((uint32_t)y, exponential_linear);
    }
}
METHOD_LOOP(logarithm_64, 1, 1)

/* ---- Squarings ---- */

static inline uint32_t square_q16(uint32_t x) {
    return (x * x + 0x8000) >> 16;
}

/* Integer p, by its binary digits; 1 is 65535. */
static inline void squaring_one(const int32_t *in, int32_t *out) {
    uint32_t power = (uint32_t)in[0] < 65536 ? (uint32_t)in[0] : 65535;
    uint32_t result = 65535;
    for (uint32_t rest = (uint32_t)exponent >> 16; rest != 0; rest >>= 1) {
        if (rest & 1) {
            result = result == 65535 ? power : (result * power + 0x8000) >> 16;
        }
        if (rest > 1) {
            power = square_q16(power);
        }
    }
    out[0] = (int32_t)((result + 1) >> 1);
}
METHOD_LOOP(squaring, 1, 1)

/* ---- A rational function: x / (p - p x + x) ---- */

static uint32_t rational_shift;

static void prepare_rational(int32_t p) {
    rational_shift = 17 - glint_leading_zeros((uint32_t)p); /* p in 15 bits; 0 to 14 */
    factor = (uint32_t)p >> rational_shift;
}

static inline void rational_one(const int32_t *in, int32_t *out) {
    const uint32_t x = (uint32_t)in[0];
    const uint32_t product = (65536 - x) * factor; /* p (1 - x), below 2^31 */
    out[0] = (int32_t)((x << 15) / ((product >> (16 - rational_shift)) + x));
}
METHOD_LOOP(rational, 1, 1)

#define P1 (1 << 16)

static const method methods[] = {
    METHOD(&power_of_cosine, "table 256 linear", "cos", "", 0, 0, 1 << 15, 514, prepare_cosine_256, linear_256, 30300,
           4020, 8, 16, 17, 43, 144, 515, 1850, 6420, 20200, 52800, 106000, 158000, 196000),
    METHOD(&power_of_cosine, "window 128 linear", "cos", "", 0, 0, 1 << 15, 258, prepare_window_nodes, cosine_window,
           36000, 5580, 127, 125, 125, 125, 125, 147, 221, 344, 589, 1080, 2050, 3960, 7860),
    METHOD(&power_of_cosine, "rational", "cos", "Schlick 1994", 0, 0, 1 << 15, 0, prepare_rational, rational, 78200,
           34500, 6, 23100, 36700, 44100, 48000, 50000, 51000, 51500, 51800, 52000, 52100, 52300, 52700),
    METHOD(&power_of_cosine, "repeated squaring", "cos", "", 0, P1, 1 << 15, 0, prepare_exponent, squaring, 0, 0, 6, 10,
           17, 32, 63, 125, 250, 499, 997, 1990, 3970, 7870, 15500),
    METHOD(&power_of_cosine, "log2 and exp2 64 linear", "cos", "", 0, 0, 1 << 15, 260, prepare_logarithm, logarithm_64,
           13500, 705, 14, 24, 41, 73, 138, 259, 483, 931, 1830, 3520, 6530, 12100, 23300),
    METHOD(&power_of_cosine, "glint_power", "cos", "", 1, 0, 1 << 15, 384, prepare_exponent, library_power, 13500, 705,
           6, 8, 12, 20, 35, 66, 128, 252, 499, 995, 1990, 3960, 7860),
    METHOD(&power_of_sine, "window 128 linear", "sin^2", "", 0, 0, 1 << 15, 258, prepare_sine_window, sine_window,
           90500, 35900, 5560, 125, 125, 125, 125, 125, 125, 130, 135, 139, 143, 143, 141),
};

const method_list methods_power = METHOD_LIST(methods);
