/* SPDX-License-Identifier: MIT */
/*
 * From amounts of diffuse and specular light, Q15, to a pixel of RGB565, under two materials: one whose ambient,
 * diffuse and specular parts sum to 1 (variant `sum 1`), and one that exceeds 1 in its highlights and clamps (variant
 * `clamping`).
 */
#include "light/model.h"
#include "methods.h"
#include "pixel/pixel.h"

static const int32_t no_points[1] = {0};

const uint32_t methods_colour_weights[2][3][3] = {
    {{205, 102, 61}, {1843, 1024, 614}, {2048, 2048, 2048}},   /* 0.05, 0.45, 0.5 */
    {{553, 307, 184}, {3133, 1741, 1044}, {2048, 2048, 2048}}, /* 0.15, 0.85, 0.5 */
};

static const uint32_t (*weights)[3]; /* ambient, diffuse, specular; Q12 */

static void input_lights(uint64_t index, int32_t *in) {
    in[0] = (int32_t)(index >> 15);
    in[1] = (int32_t)(index & 0x7fff);
}

static void bench_lights(uint32_t i, int32_t *in) {
    input_lights(method_hash(i) >> 2, in);
}

static inline void empty_one(const int32_t *in, int32_t *out) {
    out[0] = in[0] + in[1];
}
METHOD_LOOP(empty, 2, 1)

#define COLOUR_PROBLEM(name)                                           \
    static const method_problem name = {METHOD_COLOUR,                 \
                                        "colour",                      \
                                        "every pair of lights in Q15", \
                                        "pixel",                       \
                                        1,                             \
                                        2,                             \
                                        1,                             \
                                        1u << 30,                      \
                                        16381,                         \
                                        no_points,                     \
                                        1,                             \
                                        0,                             \
                                        input_lights,                  \
                                        bench_lights,                  \
                                        empty}
COLOUR_PROBLEM(fair);
COLOUR_PROBLEM(clamping);

int methods_colour_clamps(const method_problem *problem) {
    return problem == &clamping;
}

/* ---- Multiply and clamp ---- */

static void prepare_fair(int32_t p) {
    (void)p;
    weights = methods_colour_weights[0];
}

static void prepare_clamping(int32_t p) {
    (void)p;
    weights = methods_colour_weights[1];
}

/* Q15, clamped, times 31 or 63. */
static inline uint32_t channel(const int32_t *in, int c, uint32_t top) {
    const uint32_t sum =
        weights[0][c] * 8 + (((uint32_t)in[0] * weights[1][c] + (uint32_t)in[1] * weights[2][c]) >> 12);
    return ((sum < 32768 ? sum : 32768) * top + 16384) >> 15;
}

static inline void multiply_one(const int32_t *in, int32_t *out) {
    out[0] = (int32_t)(channel(in, 0, 31) << 11 | channel(in, 1, 63) << 5 | channel(in, 2, 31));
}
METHOD_LOOP(multiply, 2, 1)

/* In 8 bits, of which the lower ones are dropped. */
static inline uint32_t truncated(const int32_t *in, int c, unsigned drop) {
    const uint32_t sum =
        weights[0][c] * 8 + (((uint32_t)in[0] * weights[1][c] + (uint32_t)in[1] * weights[2][c]) >> 12);
    return (sum < 32768 ? sum * 255 >> 15 : 255) >> drop;
}

static inline void truncate_one(const int32_t *in, int32_t *out) {
    out[0] = (int32_t)(truncated(in, 0, 3) << 11 | truncated(in, 1, 2) << 5 | truncated(in, 2, 3));
}
METHOD_LOOP(truncate, 2, 1)

/* ---- One table for each light, of three channels in a word, added ---- */

/* Bits 22 to 30 green, 11 to 19 red, 0 to 8 blue: levels of 6, 5 and 5 bits and a fraction; above each, room to
 * overflow. */
static uint32_t tables[2][256];

static uint32_t field(uint32_t q15, uint32_t top, unsigned fraction) {
    const uint32_t value = (q15 * top + (1u << (14 - fraction))) >> (15 - fraction);
    return value < 511 ? value : 511;
}

/* Entry i of ambient and `which`, Q15. The diffuse table has the half that rounds. */
static uint32_t spread(uint32_t i, int which) {
    uint32_t value[3];
    for (int c = 0; c < 3; c++) {
        value[c] = (weights[1 + which][c] * i * 8 / 255) + (which ? 0 : weights[0][c] * 8);
    }
    const uint32_t word = field(value[1], 63, 3) << 22 | field(value[0], 31, 4) << 11 | field(value[2], 31, 4);
    return which ? word : word + (4u << 22) + (8u << 11) + 8u;
}

static void prepare_tables(const uint32_t (*of)[3]) {
    weights = of;
    for (uint32_t i = 0; i < 256; i++) {
        tables[0][i] = spread(i, 0);
        tables[1][i] = spread(i, 1);
    }
}

static void prepare_fair_tables(int32_t p) {
    (void)p;
    prepare_tables(methods_colour_weights[0]);
}

static void prepare_clamping_tables(int32_t p) {
    (void)p;
    prepare_tables(methods_colour_weights[1]);
}

/* Of 0 to 255, rounded. */
static inline uint32_t sum_of_tables(const int32_t *in) {
    return tables[0][((uint32_t)in[0] * 255 + 16384) >> 15] + tables[1][((uint32_t)in[1] * 255 + 16384) >> 15];
}

static inline int32_t pack(uint32_t word) {
    return (int32_t)((word >> 4 & 0xf800) | (word >> 20 & 0x7e0) | (word >> 4 & 31));
}

static inline void add_one(const int32_t *in, int32_t *out) {
    out[0] = pack(sum_of_tables(in));
}
METHOD_LOOP(add, 2, 1)

static inline void add_and_clamp_one(const int32_t *in, int32_t *out) {
    uint32_t word = sum_of_tables(in);
    const uint32_t over = word & 0x80100200u;
    word |= over - (over >> 9);
    out[0] = pack(word);
}
METHOD_LOOP(add_and_clamp, 2, 1)

/* ---- The library ---- */

static const glint_config config = {.format = &glint_format_rgb565};

static void add_library_lights(const int32_t *in, int32_t channel[3]) {
    uint32_t colour[3];
    for (int c = 0; c < 3; c++) {
        colour[c] = weights[0][c] << 11;
    }
    glint_add_light(colour, (uint32_t)in[0], weights[1]);
    glint_add_light(colour, (uint32_t)in[1], weights[2]);
    glint_channels_of(colour, channel);
}

static void library(const int32_t *in, int32_t *out, uint32_t count) {
    int32_t row[GLINT_FRAGMENTS_MAX][3];
    uint16_t pixels[GLINT_FRAGMENTS_MAX];
    for (uint32_t some; count > 0; in += 2 * some, out += some, count -= some) {
        some = count < GLINT_FRAGMENTS_MAX ? count : GLINT_FRAGMENTS_MAX;
        for (uint32_t i = 0; i < some; i++) {
            add_library_lights(in + 2 * i, row[i]);
        }
        glint_finish_colours(&config, row, some);
        const glint_run run = {0, 0, (uint8_t)some};
        config.format->store(pixels, 5, &run, &run + 1, (const int32_t(*)[3])row);
        for (uint32_t i = 0; i < some; i++) {
            out[i] = pixels[i];
        }
    }
}

static const method methods[] = {
    METHOD(&fair, "multiply and clamp", "sum 1", "", 0, 0, 1, 0, prepare_fair, multiply, 4130),
    METHOD(&fair, "multiply and truncate", "sum 1", "", 0, 0, 1, 0, prepare_fair, truncate, 8020),
    METHOD(&fair, "added tables", "sum 1", "", 0, 0, 1, 2048, prepare_fair_tables, add, 5060),
    METHOD(&fair, "added tables and clamp", "sum 1", "", 0, 0, 1, 2048, prepare_fair_tables, add_and_clamp, 5060),
    METHOD(&fair, "glint_add_light", "sum 1", "", 1, 0, 1, 0, prepare_fair, library, 4120),
    METHOD(&clamping, "multiply and clamp", "clamping", "", 0, 0, 1, 0, prepare_clamping, multiply, 4130),
    METHOD(&clamping, "multiply and truncate", "clamping", "", 0, 0, 1, 0, prepare_clamping, truncate, 7790),
    METHOD(&clamping, "added tables", "clamping", "", 0, 0, 1, 2048, prepare_clamping_tables, add, 256000),
    METHOD(&clamping, "added tables and clamp", "clamping", "", 0, 0, 1, 2048, prepare_clamping_tables, add_and_clamp,
           5260),
    METHOD(&clamping, "glint_add_light", "clamping", "", 1, 0, 1, 0, prepare_clamping, library, 4120),
};

const method_list methods_colour = METHOD_LIST(methods);
