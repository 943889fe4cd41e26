/* SPDX-License-Identifier: MIT */
/*
 * The lighting of a run of fragments in one row of a triangle, one white directional light and the infinite viewer:
 * diffuse and specular, no ambient, three colours, Q15. A run is given by the normal over w, M, at its first pixel and
 * its change per pixel, both Q28, with |M| from 1/2 to 1; set-up that a method needs for a run is counted with it. The
 * run turns by up to 10 degrees, as a row of a triangle of a torus does. Which of the lengths, 8, 16 and 32 pixels, is
 * the variant.
 */
#include "light/shade.h"
#include "lookup.h"
#include "methods.h"

static const int32_t exponents[] = {8 << 16, 32 << 16, 64 << 16, 256 << 16, 1024 << 16};

/* L is (0.4, 0.6, 0.7) made unit; H is made unit from L + (0, 0, 1). Q15. */
static const int16_t light[3] = {13042, 19563, 22824};
static const int16_t half_vector[3] = {7080, 10621, 30180};

/* Light times material, Q12: diffuse 0.85 of (0.9, 0.5, 0.3), specular 0.5 of white. */
const uint32_t methods_lighting_weights[2][3] = {{3133, 1741, 1044}, {2048, 2048, 2048}};

#define diffuse_weight methods_lighting_weights[0]
#define specular_weight methods_lighting_weights[1]

static glint_power_table table;
static uint32_t exponent; /* integer */
static unsigned sine_shift;

static void prepare(int32_t p) {
    exponent = (uint32_t)p >> 16;
    glint_power_prepare(&table, p, specular_weight[0], 0);
    sine_shift = 31 - glint_leading_zeros(table.window) - 16; /* brings what is in the window to 16 bits */
}

/* ---- Runs ---- */

/* M starts around the half vector three times in four, else where the surface turns from the light; 0.75 long. */
static void input_run(uint64_t index, uint32_t length, int32_t *in) {
    static const int32_t toward[2][3] = {{42482, 63723, 181078}, {163588, -109058, 0}}; /* Q18 */
    const uint32_t seed = (uint32_t)index * 7;
    const int32_t *base = toward[(method_hash(seed) & 3) == 0];
    for (uint32_t i = 0; i < 3; i++) {
        const int32_t offset = (int32_t)(method_hash(seed + 1 + i) % 41944) - 20972; /* up to 0.08 */
        const int32_t change = (int32_t)(method_hash(seed + 4 + i) % 31458) - 15729; /* up to 0.06 */
        in[i] = (base[i] + offset) * 1024;
        in[3 + i] = change * 1024 / (int32_t)length;
    }
}

#define RUN_PROBLEM(length)                                                          \
    static void input_##length(uint64_t index, int32_t *in) {                        \
        input_run(index, length, in);                                                \
    }                                                                                \
    static void bench_input_##length(uint32_t i, int32_t *in) {                      \
        input_run(i, length, in);                                                    \
    }                                                                                \
    static inline void empty_##length##_one(const int32_t *in, int32_t *out) {       \
        out[0] = in[0];                                                              \
    }                                                                                \
    METHOD_LOOP(empty_##length, 6, 3 * (length))                                     \
    static const method_problem run_##length = {METHOD_LIGHTING,                     \
                                                "lighting",                          \
                                                "random runs of " #length " pixels", \
                                                "pixel",                             \
                                                length,                              \
                                                6,                                   \
                                                3 * (length),                        \
                                                (1u << 22) / (length),               \
                                                61,                                  \
                                                exponents,                           \
                                                5,                                   \
                                                32 << 16,                            \
                                                input_##length,                      \
                                                bench_input_##length,                \
                                                empty_##length};

RUN_PROBLEM(8)
RUN_PROBLEM(16)
RUN_PROBLEM(32)

#define RUN(name)                                                       \
    static inline void name##_8_one(const int32_t *in, int32_t *out) {  \
        name(in, out, 8);                                               \
    }                                                                   \
    METHOD_LOOP(name##_8, 6, 24)                                        \
    static inline void name##_16_one(const int32_t *in, int32_t *out) { \
        name(in, out, 16);                                              \
    }                                                                   \
    METHOD_LOOP(name##_16, 6, 48)                                       \
    static inline void name##_32_one(const int32_t *in, int32_t *out) { \
        name(in, out, 32);                                              \
    }                                                                   \
    METHOD_LOOP(name##_32, 6, 96)

/* Colours of diffuse and specular light, Q15. */
static inline void weigh(int32_t diffuse, int32_t specular, int32_t *out) {
    const uint32_t d = diffuse > 0 ? (uint32_t)diffuse : 0;
    for (int c = 0; c < 3; c++) {
        out[c] = (int32_t)((d * diffuse_weight[c] + (uint32_t)specular * specular_weight[c]) >> 12);
    }
}

/* M of a pixel. */
static inline void step(const int32_t *in, int32_t pixel, int32_t m[3]) {
    for (int i = 0; i < 3; i++) {
        m[i] = in[i] + in[3 + i] * pixel;
    }
}

static inline int32_t dot(const int32_t a[3], const int16_t b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ---- Textbook: N, N.L, N.H and the power of every fragment, Q16 and products of 64 bits (Blinn, 1977) ---- */

static inline int32_t multiply_q16(int32_t a, int32_t b) {
    return (int32_t)glint_shift_right64((int64_t)a * b, 16);
}

static inline int32_t dot_q16(const int32_t a[3], const int32_t b[3]) {
    return multiply_q16(a[0], b[0]) + multiply_q16(a[1], b[1]) + multiply_q16(a[2], b[2]);
}

static inline int32_t power_q16(int32_t x) {
    int32_t result = 65536;
    for (uint32_t rest = exponent; rest != 0; rest >>= 1) {
        if (rest & 1) {
            result = multiply_q16(result, x);
        }
        x = multiply_q16(x, x);
    }
    return result;
}

static inline void textbook(const int32_t *in, int32_t *out, int length) {
    const int32_t l[3] = {2 * light[0], 2 * light[1], 2 * light[2]};
    const int32_t h[3] = {2 * half_vector[0], 2 * half_vector[1], 2 * half_vector[2]};
    for (int pixel = 0; pixel < length; pixel++, out += 3) {
        int32_t m[3];
        step(in, pixel, m);
        for (int i = 0; i < 3; i++) {
            m[i] = glint_shift_right(m[i], 12);
        }
        const int32_t inverse = (int32_t)(0xffffffffu / method_square_root((uint32_t)dot_q16(m, m) << 16));
        for (int i = 0; i < 3; i++) {
            m[i] = multiply_q16(m[i], inverse);
        }
        const int32_t cosine = dot_q16(m, h);
        weigh(dot_q16(m, l) >> 1, cosine > 0 ? power_q16(cosine) >> 1 : 0, out);
    }
}
RUN(textbook)

/* ---- Cosines of unit vectors in Q15, the root and the power from tables ---- */

static inline void cosine(const int32_t *in, int32_t *out, int length) {
    for (int pixel = 0; pixel < length; pixel++, out += 3) {
        int32_t m[3];
        step(in, pixel, m);
        for (int i = 0; i < 3; i++) {
            m[i] = glint_shift_right(m[i], 13);
        }
        const int32_t r = glint_inverse_root((uint32_t)(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]));
        for (int i = 0; i < 3; i++) {
            m[i] = glint_shift_right(m[i] * r + 0x4000, 15);
        }
        const int32_t h = glint_shift_right(dot(m, half_vector), 15);
        const uint32_t square = h < 32768 ? (uint32_t)(h * h) : 1u << 30;
        weigh(glint_shift_right(dot(m, light), 15), h > 0 ? lookup_power(&table, (1u << 30) - square) : 0, out);
    }
}
RUN(cosine)

/* ---- sin^2 by forward differences: M.L is linear, M.M and |M x H|^2 are quadratics ---- */

typedef struct quadratic {
    int32_t value, first, second;
} quadratic;

/* |v + t e|^2, v Q15, e Q19, both 15 bits: Q30. */
static inline void quadratic_add_square(quadratic *f, int32_t v, int32_t e) {
    const int32_t square = glint_shift_right(e * e, 8);
    f->value += v * v;
    f->first += glint_shift_right(v * e, 3) + square;
    f->second += 2 * square;
}

static inline int32_t quadratic_step(quadratic *f) {
    const int32_t value = f->value;
    f->value += f->first;
    f->first += f->second;
    return value;
}

/* Specular of q = |M x H|^2, Q30, which differences may bring a little below 0, and r = 1/|M|, Q15. */
static inline int32_t specular_of(int32_t q, uint32_t r) {
    const uint32_t sine = q > 0 ? (uint32_t)q : 0;
    if (sine >= table.window) {
        return 0;
    }
    const uint32_t u = (sine >> sine_shift) * ((r * r) >> 16); /* the window is 2^30 */
    if (u >= 1u << 30) {
        return 0;
    }
    return lookup_between(&table.value[u >> 23], (int32_t)(u >> 11 & 0xfff), 12);
}

static inline void sine(const int32_t *in, int32_t *out, int length) {
    int32_t m[3], e[3];
    quadratic c = {0, 0, 0}, q = {0, 0, 0};
    for (int i = 0; i < 3; i++) {
        m[i] = glint_shift_right(in[i], 13);
        e[i] = glint_shift_right(in[3 + i], 9);
        quadratic_add_square(&c, m[i], e[i]);
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const int32_t v = m[j] * half_vector[k] - m[k] * half_vector[j];
        const int32_t change = e[j] * half_vector[k] - e[k] * half_vector[j];
        quadratic_add_square(&q, glint_shift_right(v + 0x4000, 15), glint_shift_right(change + 0x4000, 15));
    }
    int32_t a = dot(m, light);
    const int32_t slope = glint_shift_right(dot(e, light), 4);
    for (int pixel = 0; pixel < length; pixel++, out += 3, a += slope) {
        const uint32_t r = (uint32_t)glint_inverse_root((uint32_t)quadratic_step(&c));
        weigh(glint_shift_right(glint_shift_right(a, 15) * (int32_t)r, 15), specular_of(quadratic_step(&q), r), out);
    }
}
RUN(sine)

/* ---- d = N.L and u = sin^2 exact at nodes, interpolated between ---- */

typedef struct node {
    int32_t d, u; /* Q15, Q29 */
} node;

static inline node node_at(const int32_t *in, int32_t pixel) {
    int32_t m[3];
    uint32_t q = 0;
    step(in, pixel, m);
    for (int i = 0; i < 3; i++) {
        m[i] = glint_shift_right(m[i], 13);
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const int32_t v = glint_shift_right(m[j] * half_vector[k] - m[k] * half_vector[j] + 0x4000, 15);
        q += (uint32_t)(v * v);
    }
    const uint32_t r = (uint32_t)glint_inverse_root((uint32_t)(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]));
    const uint64_t u = (uint64_t)q * (r * r) >> 31;
    const node at = {glint_shift_right(glint_shift_right(dot(m, light), 15) * (int32_t)r, 15),
                     u < 1u << 29 ? (int32_t)u : 1 << 29};
    return at;
}

static inline void weigh_node(int32_t d, int32_t u, int32_t *out) {
    weigh(d, lookup_power(&table, u > 0 ? (uint32_t)u << 1 : 0), out);
}

/* f(t) through t = 0, 4 and 8. */
static inline quadratic through(int32_t f0, int32_t f4, int32_t f8) {
    const int32_t bend = (f0 - 2 * f4 + f8) / 32;
    const quadratic f = {f0, (f8 - f0) / 8 - 7 * bend, 2 * bend};
    return f;
}

static inline void blocks(const int32_t *in, int32_t *out, int length) {
    node start = node_at(in, 0);
    for (int block = 0; block < length; block += 8) {
        const node middle = node_at(in, block + 4), end = node_at(in, block + 8);
        quadratic d = through(start.d * 1024, middle.d * 1024, end.d * 1024);
        quadratic u = through(start.u, middle.u, end.u);
        for (int pixel = 0; pixel < 8; pixel++, out += 3) {
            const int32_t diffuse = glint_shift_right(quadratic_step(&d), 10);
            weigh_node(diffuse, quadratic_step(&u), out);
        }
        start = end;
    }
}
RUN(blocks)

static inline void linear(const int32_t *in, int32_t *out, int length) {
    node at = node_at(in, 0);
    for (int block = 0; block < length; block += 8) {
        const node end = node_at(in, block + 8);
        const int32_t d_slope = (end.d - at.d) * 128, u_slope = (end.u - at.u) / 8;
        int32_t d = at.d * 1024, u = at.u;
        for (int pixel = 0; pixel < 8; pixel++, out += 3, d += d_slope, u += u_slope) {
            weigh_node(glint_shift_right(d, 10), u, out);
        }
        at = end;
    }
}
RUN(linear)

/* ---- Colours of the ends, or of the middle ---- */

/* Linear between the colours of the run's ends (Gouraud, 1971). */
static inline void gouraud(const int32_t *in, int32_t *out, int length) {
    const node first = node_at(in, 0), last = node_at(in, length);
    int32_t from[3], to[3];
    weigh_node(first.d, first.u, from);
    weigh_node(last.d, last.u, to);
    for (int c = 0; c < 3; c++) {
        to[c] = (to[c] - from[c]) * 1024 / length;
        from[c] *= 1024;
    }
    for (int pixel = 0; pixel < length; pixel++, out += 3) {
        for (int c = 0; c < 3; c++) {
            out[c] = from[c] >> 10;
            from[c] += to[c];
        }
    }
}
RUN(gouraud)

static inline void flat(const int32_t *in, int32_t *out, int length) {
    const node middle = node_at(in, length / 2);
    int32_t colour[3];
    weigh_node(middle.d, middle.u, colour);
    for (int pixel = 0; pixel < length; pixel++, out += 3) {
        for (int c = 0; c < 3; c++) {
            out[c] = colour[c];
        }
    }
}
RUN(flat)

/* ---- The library ---- */

static glint_material material;
static glint_shading shading = {.material = &material, .has_specular = 1, .changed = 1};
static glint_view view;
static glint_fragments fragments;

static void prepare_library(int32_t p) {
    glint_prepared_light *source = &view.lights[0];
    shading.shininess = p;
    glint_model_blinn_phong.prepare(&shading, specular_weight[0]);
    view.light_count = 1;
    source->type = &glint_light_directional;
    glint_unit(light[0], light[1], light[2], source->direction);
    glint_unit(half_vector[0], half_vector[1], half_vector[2], source->half_vector);
    for (int c = 0; c < 3; c++) {
        shading.weights[0].diffuse[c] = diffuse_weight[c];
        shading.weights[0].specular[c] = specular_weight[c];
    }
    fragments.count = GLINT_FRAGMENTS_MAX;
}

static inline void library(const int32_t *in, int32_t *out, int length) {
    for (int first = 0; first < length; first += GLINT_FRAGMENTS_MAX, out += 3 * GLINT_FRAGMENTS_MAX) {
        for (int i = 0; i < GLINT_FRAGMENTS_MAX; i++) {
            int32_t m[3];
            step(in, first + i, m);
            glint_unit_inline(m[0], m[1], m[2], fragments.normal[i]);
            for (int c = 0; c < 3; c++) {
                fragments.colour[i][c] = 0;
            }
        }
        glint_model_blinn_phong.light(&shading, 0, &view, &fragments, 0);
        for (int i = 0; i < 3 * GLINT_FRAGMENTS_MAX; i++) {
            out[i] = (int32_t)(fragments.colour[i / 3][i % 3] >> 8);
        }
    }
}
RUN(library)

#define LIT(length, name, source, shipped, bytes, prepare, function, ...)                                            \
    METHOD(&run_##length, name, #length " pixels", source, shipped, 0, 1 << 15, bytes, prepare, function##_##length, \
           __VA_ARGS__)

/* The power table, 129 nodes, and that of roots. */
enum { BYTES = 258 + 708 };

static const method methods[] = {
    LIT(8, "textbook", "Blinn 1977", 0, 0, prepare, textbook, 84, 255, 488, 1880, 7320),
    LIT(16, "textbook", "Blinn 1977", 0, 0, prepare, textbook, 81, 257, 488, 1860, 7430),
    LIT(32, "textbook", "Blinn 1977", 0, 0, prepare, textbook, 79, 259, 517, 2070, 8150),
    LIT(8, "cosine", "", 0, BYTES, prepare, cosine, 237, 791, 1520, 5700, 21300),
    LIT(16, "cosine", "", 0, BYTES, prepare, cosine, 237, 791, 1520, 5710, 21500),
    LIT(32, "cosine", "", 0, BYTES, prepare, cosine, 234, 791, 1520, 5730, 21500),
    LIT(8, "sin^2 by differences", "", 0, BYTES, prepare, sine, 64, 99, 114, 221, 317),
    LIT(16, "sin^2 by differences", "", 0, BYTES, prepare, sine, 69, 124, 139, 255, 360),
    LIT(32, "sin^2 by differences", "", 0, BYTES, prepare, sine, 80, 138, 164, 312, 603),
    LIT(8, "quadratic in 8", "", 0, BYTES, prepare, blocks, 122, 309, 545, 1910, 7510),
    LIT(16, "quadratic in 8", "", 0, BYTES, prepare, blocks, 72, 111, 141, 344, 927),
    LIT(32, "quadratic in 8", "", 0, BYTES, prepare, blocks, 69, 107, 120, 217, 314),
    LIT(8, "linear in 8", "", 0, BYTES, prepare, linear, 3570, 12400, 23100, 67700, 114000),
    LIT(16, "linear in 8", "", 0, BYTES, prepare, linear, 957, 3280, 6070, 19500, 58500),
    LIT(32, "linear in 8", "", 0, BYTES, prepare, linear, 236, 729, 1360, 5010, 17500),
    LIT(8, "Gouraud", "Gouraud 1971", 0, BYTES, prepare, gouraud, 6360, 12400, 22900, 66800, 112000),
    LIT(16, "Gouraud", "Gouraud 1971", 0, BYTES, prepare, gouraud, 6360, 12400, 22900, 66800, 114000),
    LIT(32, "Gouraud", "Gouraud 1971", 0, BYTES, prepare, gouraud, 6360, 9900, 17700, 52400, 109000),
    LIT(8, "flat", "", 0, BYTES, prepare, flat, 16900, 37200, 50400, 83600, 118000),
    LIT(16, "flat", "", 0, BYTES, prepare, flat, 17400, 37200, 50400, 81500, 118000),
    LIT(32, "flat", "", 0, BYTES, prepare, flat, 18700, 37200, 50400, 81500, 118000),
    LIT(8, "glint_model_blinn_phong", "", 1, BYTES, prepare_library, library, 35, 71, 84, 191, 293),
    LIT(16, "glint_model_blinn_phong", "", 1, BYTES, prepare_library, library, 36, 70, 83, 191, 287),
    LIT(32, "glint_model_blinn_phong", "", 1, BYTES, prepare_library, library, 36, 70, 81, 195, 287),
};

const method_list methods_lighting = METHOD_LIST(methods);
