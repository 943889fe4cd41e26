/* SPDX-License-Identifier: MIT */
/*
 * The perspective divide. Variant `colour`: three attributes of a fragment, interpolated over w, are divided by 1/w:
 * colour w 2^-16 over w, w Q31, to Q15. Variant `position`: a vertex's clip coordinates x, y over w, to sixteenths of a
 * pixel, w being 1023 pixels.
 */
#include "light/colour.h"
#include "methods.h"

static const int32_t no_points[1] = {0};

/* ---- Colours ---- */

/* Three colours and 1/w, of Q31, which perspective brings down to 1/16 within a triangle. */
static void input_colour(uint64_t index, int32_t *in) {
    const uint32_t seed = (uint32_t)index * 4;
    const uint32_t w = (method_hash(seed) >> 1 | 1u << 30) >> (method_hash(seed ^ 0x55555555u) & 3);
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t colour = method_hash(seed + 1 + i) >> 17;
        in[i] = (int32_t)(colour * (w >> 16) + (colour * (w & 0xffff) >> 16));
    }
    in[3] = (int32_t)w;
}

static void bench_colour(uint32_t i, int32_t *in) {
    input_colour(i, in);
}

static inline void empty_colour_one(const int32_t *in, int32_t *out) {
    out[0] = in[0];
    out[1] = in[1];
    out[2] = in[2] + in[3];
}
METHOD_LOOP(empty_colour, 4, 3)

static const method_problem colours = {METHOD_COLOUR_OVER_W,
                                       "divide",
                                       "random colours; 1/w from 1/8 to 1",
                                       "pixel",
                                       1,
                                       4,
                                       3,
                                       1u << 24,
                                       61,
                                       no_points,
                                       1,
                                       0,
                                       input_colour,
                                       bench_colour,
                                       empty_colour};

static inline void colour_wide_one(const int32_t *in, int32_t *out) {
    for (int i = 0; i < 3; i++) {
        out[i] = (int32_t)(((int64_t)in[i] << 16) / in[3]);
    }
}
METHOD_LOOP(colour_wide, 4, 3)

/* Both brought up to the full 32 bits; 15 of them are left of the divisor. */
static inline void colour_short_one(const int32_t *in, int32_t *out) {
    const unsigned zeros = glint_leading_zeros((uint32_t)in[3]);
    const uint32_t w = ((uint32_t)in[3] << zeros) >> 16;
    for (int i = 0; i < 3; i++) {
        const uint32_t quotient = ((uint32_t)in[i] << zeros) / w;
        out[i] = (int32_t)(quotient < 32767 ? quotient : 32767);
    }
}
METHOD_LOOP(colour_short, 4, 3)

static uint16_t inverse[257]; /* 1/x, x from 1/2 to 1: Q15 */

static void prepare_inverse(int32_t p) {
    (void)p;
    for (uint32_t i = 0; i <= 256; i++) {
        const uint32_t value = (1u << 24) / (256 + i);
        inverse[i] = (uint16_t)(value < 65536 ? value : 65535);
    }
}

/* Right in the middle of what each entry stands for. */
static void prepare_nearest_64(int32_t p) {
    (void)p;
    for (uint32_t i = 0; i < 64; i++) {
        inverse[i] = (uint16_t)((1u << 23) / (128 + 2 * i + 1));
    }
}

static void prepare_nearest_256(int32_t p) {
    (void)p;
    for (uint32_t i = 0; i < 256; i++) {
        inverse[i] = (uint16_t)((1u << 25) / (512 + 2 * i + 1));
    }
}

/* Three products with a reciprocal, Q15, of w in its upper 16 bits. */
static inline void multiply(const int32_t *in, unsigned zeros, uint32_t reciprocal, int32_t *out) {
    for (int i = 0; i < 3; i++) {
        const uint32_t colour = ((((uint32_t)in[i] << zeros) + 0x4000) >> 15) * reciprocal; /* Q31 */
        const uint32_t rounded = (colour + 0x8000) >> 16;
        out[i] = (int32_t)(rounded < 32767 ? rounded : 32767);
    }
}

static inline void colour_nearest_one(const int32_t *in, int32_t *out) {
    const unsigned zeros = glint_leading_zeros((uint32_t)in[3]);
    const uint32_t w = (uint32_t)in[3] << zeros;
    multiply(in, zeros, inverse[w >> 23 & 255], out);
}
METHOD_LOOP(colour_nearest, 4, 3)

static inline void colour_linear_one(const int32_t *in, int32_t *out) {
    const unsigned zeros = glint_leading_zeros((uint32_t)in[3]);
    const uint32_t w = (uint32_t)in[3] << zeros;
    const uint16_t *at = &inverse[w >> 23 & 255];
    const uint32_t reciprocal = (uint32_t)(at[0] - (((at[0] - at[1]) * (int32_t)(w >> 8 & 0x7fff) + 0x4000) >> 15));
    multiply(in, zeros, reciprocal, out);
}
METHOD_LOOP(colour_linear, 4, 3)

/* r (2 - w r). */
static inline void colour_newton_one(const int32_t *in, int32_t *out) {
    const unsigned zeros = glint_leading_zeros((uint32_t)in[3]);
    const uint32_t w = (uint32_t)in[3] << zeros;
    const uint32_t r = inverse[w >> 25 & 63];
    const uint32_t rest = (0u - (w >> 16) * r) >> 15; /* 2 - w r, Q16 */
    multiply(in, zeros, (r * rest) >> 16, out);
}
METHOD_LOOP(colour_newton, 4, 3)

/* glint_resolve_colour of a fragment at its triangle's first corner, whose planes are level. */
static glint_attributes attributes;
static glint_part part;
static glint_fragments fragments;

static void prepare_library(int32_t p) {
    (void)p;
    fragments.attributes = &attributes;
    fragments.part = &part;
}

static inline void colour_library_one(const int32_t *in, int32_t *out) {
    glint_plane *planes = attributes.main;
    int16_t colour[3];
    for (int i = 0; i < 3; i++) {
        planes[i].start = in[i];
    }
    fragments.inverse_w[0] = in[3];
    glint_resolve_colour(&fragments, 0, planes, colour);
    for (int i = 0; i < 3; i++) {
        out[i] = colour[i];
    }
}
METHOD_LOOP(colour_library, 4, 3)

/* ---- Positions ---- */

/* Inside the guard band, |x| and |y| below w; w from 2^20 to 2^30. */
static void input_position(uint64_t index, int32_t *in) {
    const uint32_t seed = (uint32_t)index * 4;
    const int32_t w = (int32_t)((method_hash(seed) >> 3 | 1u << 28) >> (method_hash(seed + 1) % 9));
    in[0] = (int32_t)((int64_t)(int32_t)method_hash(seed + 2) * w >> 31);
    in[1] = (int32_t)((int64_t)(int32_t)method_hash(seed + 3) * w >> 31);
    in[2] = w;
}

static void bench_position(uint32_t i, int32_t *in) {
    input_position(i, in);
}

static inline void empty_position_one(const int32_t *in, int32_t *out) {
    out[0] = in[0];
    out[1] = in[1] + in[2];
}
METHOD_LOOP(empty_position, 3, 2)

static const method_problem positions = {METHOD_POSITION_OVER_W,
                                         "divide",
                                         "random x and y below w; 1 being 1023 pixels",
                                         "vertex",
                                         1,
                                         3,
                                         2,
                                         1u << 24,
                                         61,
                                         no_points,
                                         1,
                                         0,
                                         input_position,
                                         bench_position,
                                         empty_position};

enum { SIXTEENTHS = 16 * GLINT_GUARD_BAND };

static inline int32_t nearest_quotient(int64_t x, int32_t w) {
    return (int32_t)((x < 0 ? x - w / 2 : x + w / 2) / w);
}

static inline void position_wide_one(const int32_t *in, int32_t *out) {
    out[0] = nearest_quotient((int64_t)in[0] * SIXTEENTHS, in[2]);
    out[1] = nearest_quotient((int64_t)in[1] * SIXTEENTHS, in[2]);
}
METHOD_LOOP(position_wide, 3, 2)

/* x in 31 bits over w in 16 gives Q15; times 16 x 1023 it fits 32 bits. */
static inline void position_short_one(const int32_t *in, int32_t *out) {
    const unsigned zeros = glint_leading_zeros((uint32_t)in[2]) - 1;
    const int32_t w = glint_shift_left(in[2], zeros) >> 15;
    for (int i = 0; i < 2; i++) {
        /* NOLINTNEXTLINE(clang-analyzer-core.DivideZero): w has 16 bits, for the input is above 0 */
        out[i] = glint_shift_right(glint_shift_left(in[i], zeros) / w * SIXTEENTHS + 0x4000, 15);
    }
}
METHOD_LOOP(position_short, 3, 2)

/* One 32-bit division for a reciprocal of 16 bits, and two products. */
static inline void position_reciprocal_one(const int32_t *in, int32_t *out) {
    const unsigned zeros = glint_leading_zeros((uint32_t)in[2]);
    const int32_t reciprocal = (int32_t)(0x7fffffffu / (((uint32_t)in[2] << zeros) >> 16)); /* Q15, below 2^16 */
    for (int i = 0; i < 2; i++) {
        const int32_t x = glint_shift_right(glint_shift_left(in[i], zeros - 1), 16) * reciprocal; /* x / w, Q30 */
        out[i] = glint_shift_right(glint_shift_right(x, 13) * SIXTEENTHS + 0x10000, 17);
    }
}
METHOD_LOOP(position_reciprocal, 3, 2)

static inline void position_library_one(const int32_t *in, int32_t *out) {
    static const glint_transform middle = {.nearest = 1, .center_x = 1 << 10, .center_y = 1 << 10};
    const glint_position position = {in[0], in[1], in[2]};
    glint_vertex vertex;
    glint_project(&middle, &position, &vertex);
    out[0] = vertex.x;
    out[1] = vertex.y;
}
METHOD_LOOP(position_library, 3, 2)

static const method methods[] = {
    METHOD(&colours, "64 bit division", "colour", "", 0, 0, 32768, 0, 0, colour_wide, 8),
    METHOD(&colours, "32 bit division", "colour", "", 0, 0, 32768, 0, 0, colour_short, 8),
    METHOD(&colours, "reciprocal table 256 nearest", "colour", "", 0, 0, 32768, 512, prepare_nearest_256,
           colour_nearest, 499),
    METHOD(&colours, "reciprocal table 256 linear", "colour", "", 0, 0, 32768, 514, prepare_inverse, colour_linear, 16),
    METHOD(&colours, "reciprocal table 64 and Newton", "colour", "", 0, 0, 32768, 128, prepare_nearest_64,
           colour_newton, 24),
    METHOD(&colours, "glint_resolve_colour", "colour", "", 1, 0, 32768, 0, prepare_library, colour_library, 16),
    METHOD(&positions, "64 bit division", "position", "", 0, 0, SIXTEENTHS, 0, 0, position_wide, 8),
    METHOD(&positions, "32 bit division", "position", "", 0, 0, SIXTEENTHS, 0, 0, position_short, 16),
    METHOD(&positions, "16 bit reciprocal", "position", "", 0, 0, SIXTEENTHS, 0, 0, position_reciprocal, 31),
    METHOD(&positions, "glint_project", "position", "", 1, 0, SIXTEENTHS, 0, 0, position_library, 10),
};

const method_list methods_divide = METHOD_LIST(methods);
