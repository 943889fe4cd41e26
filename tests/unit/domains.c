/* SPDX-License-Identifier: MIT */
#include "domains.h"

#include "fixture.h"
#include "glint.h"
#include "math/numeric.h"
#include "pixel/pixel.h"

static int64_t leading_zeros(int64_t x) {
    return glint_leading_zeros((uint32_t)x);
}

static int64_t magnitude_bits(int64_t x) {
    return glint_magnitude_bits((int32_t)x);
}

static int64_t inverse_root(int64_t x) {
    return glint_inverse_root((uint32_t)x);
}

static int64_t inverse(int64_t x) {
    return glint_inverse((uint32_t)x);
}

static int64_t reciprocal(int64_t x) {
    return glint_reciprocal((uint32_t)x);
}

static int64_t logarithm(int64_t x) {
    return glint_log2((uint32_t)x);
}

static int64_t exponential(int64_t x) {
    return glint_exp2((int32_t)x);
}

static int64_t sine_of_phase(int64_t x) {
    return glint_sine((uint32_t)x);
}

static int64_t phase(int64_t x) {
    return glint_phase((int32_t)x);
}

static int64_t sine(int64_t x) {
    return glint_sin((int32_t)x);
}

static int64_t cosine(int64_t x) {
    return glint_cos((int32_t)x);
}

#define POWER(name, exponent)                                 \
    static int64_t name(int64_t x) {                          \
        return glint_power((uint32_t)x, (int32_t)(exponent)); \
    }
POWER(power_least, 1)
POWER(power_half, GLINT_ONE / 2)
POWER(power_1, GLINT_ONE)
POWER(power_2, 2 * GLINT_ONE)
POWER(power_32, 32 * GLINT_ONE)
POWER(power_100_3, GLINT_Q16(100.3))
POWER(power_1024, 1024 * GLINT_ONE)
POWER(power_largest, INT32_MAX)

/* The channels of a grey. */
static void channels_of_grey(int64_t x, int32_t channel[3]) {
    const uint32_t colour[3] = {(uint32_t)x, (uint32_t)x, (uint32_t)x};
    glint_channels_of(colour, channel);
}

#define LEVEL(name, bits)                                                           \
    static int64_t name(int64_t x) {                                                \
        int32_t channel[3];                                                         \
        channels_of_grey(x, channel);                                               \
        return glint_level(glint_to_levels(channel[1], bits), bits, GLINT_NEAREST); \
    }
LEVEL(level_15, 4)
LEVEL(level_31, 5)
LEVEL(level_63, 6)
LEVEL(level_255, 8)

#define LUMA(name, top)                                       \
    static int64_t name(int64_t x) {                          \
        int32_t channel[3];                                   \
        channels_of_grey(x, channel);                         \
        return glint_luma_level(channel, top, GLINT_NEAREST); \
    }
LUMA(luma_1, 1)
LUMA(luma_15, 15)
LUMA(luma_255, 255)

static int64_t channel(int64_t x) {
    return glint_channel_of((int16_t)x);
}

/* An output table of squares: entry i is (i / 256)^2, the last one 1. */
#define SQUARE(i) ((i) * (i) - (i) / 256)
#define SQUARES4(i) SQUARE(i), SQUARE((i) + 1), SQUARE((i) + 2), SQUARE((i) + 3)
#define SQUARES16(i) SQUARES4(i), SQUARES4((i) + 4), SQUARES4((i) + 8), SQUARES4((i) + 12)
#define SQUARES64(i) SQUARES16(i), SQUARES16((i) + 16), SQUARES16((i) + 32), SQUARES16((i) + 48)
#define SQUARES SQUARES64(0), SQUARES64(64), SQUARES64(128), SQUARES64(192), SQUARE(256)

static int64_t gamma_of_squares(int64_t x) {
    static const uint16_t squares[3][GLINT_GAMMA_ENTRIES] = {{SQUARES}, {SQUARES}, {SQUARES}};
    const glint_config config = {.format = &glint_format_grey8, .gamma = squares}; /* no levels of its channels */
    int32_t colour[1][3];
    channels_of_grey(x, colour[0]);
    glint_finish_colours(&config, colour, 1);
    return colour[0][1];
}

static int64_t dither_threshold(int64_t x) {
    const glint_target target = {0, 3, 1};
    return glint_threshold(&target, (uint32_t)x);
}

#define FULL_RANGE INT32_MIN, INT32_MAX
#define Q31_RANGE 0, (int64_t)1 << 31
#define COLOUR_RANGE 0, UINT32_MAX

const domain domains[DOMAIN_COUNT] = {
    {"leading_zeros", 0, UINT32_MAX, leading_zeros},
    {"magnitude_bits", FULL_RANGE, magnitude_bits},
    {"inverse_root", 1 << 28, (int64_t)3 << 30, inverse_root},
    {"inverse", 1 << 28, 3 << 28, inverse},
    {"reciprocal", (int64_t)1 << 31, UINT32_MAX, reciprocal},
    {"log2", Q31_RANGE, logarithm},
    {"exp2", INT32_MIN, 0, exponential},
    {"power_least", Q31_RANGE, power_least},
    {"power_half", Q31_RANGE, power_half},
    {"power_1", Q31_RANGE, power_1},
    {"power_2", Q31_RANGE, power_2},
    {"power_32", Q31_RANGE, power_32},
    {"power_100_3", Q31_RANGE, power_100_3},
    {"power_1024", Q31_RANGE, power_1024},
    {"power_largest", Q31_RANGE, power_largest},
    {"sine_of_phase", 0, UINT32_MAX, sine_of_phase},
    {"phase", FULL_RANGE, phase},
    {"sin", FULL_RANGE, sine},
    {"cos", FULL_RANGE, cosine},
    {"level_15", COLOUR_RANGE, level_15},
    {"level_31", COLOUR_RANGE, level_31},
    {"level_63", COLOUR_RANGE, level_63},
    {"level_255", COLOUR_RANGE, level_255},
    {"luma_1", COLOUR_RANGE, luma_1},
    {"luma_15", COLOUR_RANGE, luma_15},
    {"luma_255", COLOUR_RANGE, luma_255},
    {"channel", 0, GLINT_COLOUR_ONE, channel},
    {"gamma_of_squares", COLOUR_RANGE, gamma_of_squares},
    {"dither_threshold", 0, 63, dither_threshold},
};

uint32_t domain_checksum(const domain *function, uint32_t count) {
    uint32_t checksum = FIXTURE_CHECKSUM_START;
    const int64_t width = function->last - function->first;
    for (uint32_t i = 0; i < count; i++) {
        const uint64_t value = (uint64_t)function->value(function->first + width * i / (count - 1));
        const uint8_t bytes[4] = {(uint8_t)value, (uint8_t)(value >> 8), (uint8_t)(value >> 16),
                                  (uint8_t)(value >> 24)};
        checksum = fixture_checksum_add(checksum, bytes, 4);
    }
    return checksum;
}
