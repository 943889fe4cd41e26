/* SPDX-License-Identifier: MIT */
/*
 * Suite: every function of one argument over its whole domain against double precision. The largest error found is to
 * be what the function's contract states: not above it, and no less than 0.8 of it.
 *
 * domains [STRIDE [SEED [NAME]]]: domains of more than 2^24 arguments are gone through in steps of STRIDE, from an
 * argument that SEED chooses; those at an edge are all tried. A STRIDE of 1 is all.
 */
#include "domains.h"

#include "harness.h"
#include "pixel/pixel.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* pixel.h declares memcpy by itself, so string.h stays out. */
static int is_same(const char *a, const char *b) {
    for (; *a != '\0' && *a == *b; a++, b++) {
    }
    return *a == *b;
}

static const double pi = 3.14159265358979323846;

static double exact_leading_zeros(int64_t x) {
    return x ? 31 - (int)log2((double)x) : 32;
}

static double exact_magnitude_bits(int64_t x) {
    return x < 0 ? (double)(-1 - x) : (double)x;
}

static double exact_inverse_root(int64_t x) {
    return GLINT_UNIT * 32768.0 / sqrt((double)x);
}

static double exact_inverse(int64_t x) {
    return 0x1p48 / (double)x;
}

static double exact_reciprocal(int64_t x) {
    return 0x1p63 / (double)x;
}

static double exact_log2(int64_t x) {
    return x ? (log2((double)x) - 31) * 0x1p26 : -32 * 0x1p26;
}

static double exact_exp2(int64_t x) {
    return exp2((double)x / 0x1p26 + 30);
}

static double exact_sine_of_phase(int64_t x) {
    return sin((double)x / 0x1p31 * pi) * 0x1p30;
}

/* Modulo a turn. */
static double exact_phase(int64_t x) {
    const double turns = (double)(x % (360 * 65536)) / (360 * 65536.0);
    return (turns < 0 ? turns + 1 : turns) * 0x1p32;
}

static double exact_sin(int64_t x) {
    return sin((double)(x % (360 * 65536)) / 65536 * pi / 180) * 65536;
}

static double exact_cos(int64_t x) {
    return cos((double)(x % (360 * 65536)) / 65536 * pi / 180) * 65536;
}

static double power(int64_t x, double p) {
    return pow((double)x / 0x1p31, p) * 0x1p30;
}

static double exact_power_least(int64_t x) {
    return power(x, 0x1p-16);
}

static double exact_power_half(int64_t x) {
    return sqrt((double)x / 0x1p31) * 0x1p30;
}

static double exact_power_1(int64_t x) {
    return (double)x / 2;
}

static double exact_power_2(int64_t x) {
    return (double)x / 0x1p31 * ((double)x / 0x1p31) * 0x1p30;
}

static double exact_power_32(int64_t x) {
    return power(x, 32);
}

static double exact_power_100_3(int64_t x) {
    return power(x, (int32_t)(100.3 * 65536 + 0.5) / 65536.0);
}

static double exact_power_1024(int64_t x) {
    return power(x, 1024);
}

static double exact_power_largest(int64_t x) {
    return power(x, INT32_MAX / 65536.0);
}

static double clamped(int64_t x) {
    return x < 1 << 23 ? (double)x : 0x1p23;
}

static double exact_level_1(int64_t x) {
    return clamped(x) / 0x1p23;
}

static double exact_level_15(int64_t x) {
    return clamped(x) * 15 / 0x1p23;
}

static double exact_level_31(int64_t x) {
    return clamped(x) * 31 / 0x1p23;
}

static double exact_level_63(int64_t x) {
    return clamped(x) * 63 / 0x1p23;
}

static double exact_level_255(int64_t x) {
    return clamped(x) * 255 / 0x1p23;
}

static double exact_channel(int64_t x) {
    return (double)x * 0x1p27 / 32767;
}

static double exact_gamma_of_squares(int64_t x) {
    const double at = clamped(x) / 0x1p15, entry = floor(at);
    const double low = entry * entry - (entry == 256), high = (entry + 1) * (entry + 1) - (entry + 1 >= 256);
    return (low + (entry == 256 ? 0 : high - low) * (at - entry)) / 65535 * 0x1p27;
}

/* Bayer's matrix by its definition: M(2n) is 4 M(n) + {0, 2; 3, 1} in the quarters; 2 M + 1 of 128. */
static double exact_dither_threshold(int64_t i) {
    static const int quarter[2][2] = {{0, 2}, {3, 1}};
    int level = 0;
    for (int bit = 0; bit < 3; bit++)
        level = 4 * level + quarter[i >> (3 + bit) & 1][i >> bit & 1];
    return 2 * level + 1;
}

/* Colours are clamped here. */
#define FULL (1 << 23)

/* As the contract states it: in steps of the result, or as a part of it. */
typedef struct reference {
    const char *name;
    double (*exact)(int64_t x);
    double stated;
    int relative;
    double modulus; /* or 0 */
    int64_t dense;  /* up to here no argument is left out */
} reference;

static const reference references[] = {
    {"leading_zeros", exact_leading_zeros, 0, 0, 0, 0},
    {"magnitude_bits", exact_magnitude_bits, 0, 0, 0, 0},
    {"inverse_root", exact_inverse_root, 5.44e-5, 1, 0, 0},
    {"inverse", exact_inverse, 3.1e-6, 1, 0, 0},
    {"reciprocal", exact_reciprocal, 1.64e-9, 1, 0, 0},
    {"log2", exact_log2, 1.93, 0, 0, 0},
    {"exp2", exact_exp2, 12.8, 0, 0, 0},
    {"power_least", exact_power_least, 25, 0, 0, 0},
    {"power_half", exact_power_half, 20.7, 0, 0, 0},
    {"power_1", exact_power_1, 18.1, 0, 0, 0},
    {"power_2", exact_power_2, 23.8, 0, 0, 0},
    {"power_32", exact_power_32, 220, 0, 0, 0},
    {"power_100_3", exact_power_100_3, 700, 0, 0, 0},
    {"power_1024", exact_power_1024, 7050, 0, 0, 0},
    {"power_largest", exact_power_largest, 7 * 32768, 0, 0, 0},
    {"sine_of_phase", exact_sine_of_phase, 64.7, 0, 0, 0},
    {"phase", exact_phase, 0.556, 0, 0x1p32, 0},
    {"sin", exact_sin, 0.504, 0, 0, 0},
    {"cos", exact_cos, 0.504, 0, 0, 0},
    {"level_15", exact_level_15, 0.500002, 0, 0, FULL},
    {"level_31", exact_level_31, 0.500002, 0, 0, FULL},
    {"level_63", exact_level_63, 0.500002, 0, 0, FULL},
    {"level_255", exact_level_255, 0.500002, 0, 0, FULL},
    {"luma_1", exact_level_1, 0.5, 0, 0, FULL},
    {"luma_15", exact_level_15, 0.5005, 0, 0, FULL},
    {"luma_255", exact_level_255, 0.5084, 0, 0, FULL},
    {"channel", exact_channel, 1, 0, 0, 0},
    {"gamma_of_squares", exact_gamma_of_squares, 3400, 0, 0, FULL},
    {"dither_threshold", exact_dither_threshold, 0, 0, 0, 0},
};

static int64_t stride = 101;
static int64_t seed;

static double error_at(const domain *function, const reference *r, int64_t x) {
    const double exact = r->exact(x);
    double error = fabs((double)function->value(x) - exact);
    if (r->modulus > 0 && error > r->modulus / 2)
        error = r->modulus - error;
    return r->relative ? error / exact : error;
}

/* The largest error so far, and where it is. */
typedef struct extreme {
    double error;
    int64_t at;
} extreme;

/* Those of first to last, both included, that are in the domain. */
static void try_range(const domain *function, const reference *r, int64_t first, int64_t last, int64_t step,
                      extreme *worst) {
    const int64_t end = last < function->last ? last : function->last;
    for (int64_t x = first > function->first ? first : function->first; x <= end; x += step) {
        const double error = error_at(function, r, x);
        if (error > worst->error)
            *worst = (extreme){error, x};
    }
}

/* Arguments beside an edge that are all tried. */
#define BESIDE 64

/* The ends of a domain, zero, and powers of two, where functions change over to another shift or table. */
static void try_edges(const domain *function, const reference *r, extreme *worst) {
    try_range(function, r, function->first, function->first + BESIDE, 1, worst);
    try_range(function, r, function->last - BESIDE, function->last, 1, worst);
    for (int64_t power = 1; power <= (int64_t)1 << 32; power *= 2) {
        try_range(function, r, power - BESIDE, power + BESIDE, 1, worst);
        try_range(function, r, -power - BESIDE, -power + BESIDE, 1, worst);
    }
}

static void check_domain(const domain *function, const reference *r) {
    const int64_t step = function->last - function->first > 1 << 24 ? stride : 1;
    extreme worst = {-1, 0};
    try_range(function, r, function->first + (step > 1 ? seed : 0), function->last, step, &worst);
    try_edges(function, r, &worst);
    if (r->dense > 0)
        try_range(function, r, 0, r->dense, 1, &worst);
    char line[160];
    snprintf(line, sizeof line, "  %s: at most %.6g off, at %lld; %.6g stated\n", r->name, worst.error,
             (long long)worst.at, r->stated);
    test_write(line);
    CHECK(worst.error <= r->stated);
    CHECK(worst.error >= 0.8 * r->stated);
}

/* Cases run in order, one for each function from the first on. */
static unsigned next;

static void check_next(void) {
    const unsigned i = next++;
    if (CHECK(is_same(domains[i].name, references[i].name)))
        check_domain(&domains[i], &references[i]);
}

static void write_out(const char *text) {
    fputs(text, stdout);
}

int main(int count, char **arguments) {
    test_case cases[DOMAIN_COUNT];
    unsigned first = 0, end = DOMAIN_COUNT;
    for (unsigned i = 0; i < DOMAIN_COUNT; i++) {
        cases[i] = (test_case){references[i].name, check_next};
        if (count > 1 && is_same(arguments[1], "names"))
            puts(references[i].name);
        if (count > 3 && is_same(arguments[3], references[i].name))
            first = i, end = i + 1;
    }
    if (count > 1)
        stride = strtoll(arguments[1], NULL, 10);
    if (count > 2)
        seed = strtoll(arguments[2], NULL, 10) % stride;
    next = first;
    return stride > 0 && test_run(write_out, cases + first, end - first) > 0;
}
