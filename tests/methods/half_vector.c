/* SPDX-License-Identifier: MIT */
/*
 * The half vector of the local viewer and a directional light, over the pixels of a 16 x 16 tile of a 320 x 240 screen,
 * 60 degrees high: three components, Q15. Planes are not made unit between their corners.
 */
#include "math/numeric.h"
#include "methods.h"

enum { WIDTH = METHOD_SCREEN_WIDTH, HEIGHT = METHOD_SCREEN_HEIGHT, TILE = METHOD_TILE, LIGHTS = 8 };
enum { PIXELS = TILE * TILE, TILES_X = WIDTH / TILE, TILES = TILES_X * (HEIGHT / TILE) };

static const int32_t exponents[] = {8 << 16, 32 << 16, 64 << 16, 256 << 16, 1024 << 16};

/* A tile's first pixel, and a light in front of the screen, unit. */
static void input_tile(uint64_t index, int32_t *in) {
    const uint32_t tile = (uint32_t)index % TILES, light = (uint32_t)index / TILES;
    int16_t unit[3] = {13040, 19561, 22821}; /* the first is that of the benchmark scenes */
    if (light > 0) {
        const int32_t x = (int32_t)(method_hash(3 * light) >> 16) - 32768;
        const int32_t y = (int32_t)(method_hash(3 * light + 1) >> 16) - 32768;
        glint_unit(x, y, (int32_t)(method_hash(3 * light + 2) >> 17), unit);
    }
    in[0] = (int32_t)(tile % TILES_X) * TILE;
    in[1] = (int32_t)(tile / TILES_X) * TILE;
    for (int i = 0; i < 3; i++) {
        in[2 + i] = unit[i];
    }
}

static void bench_input(uint32_t i, int32_t *in) {
    input_tile(method_hash(i) % TILES, in);
}

static inline void empty_one(const int32_t *in, int32_t *out) {
    out[0] = in[0];
}
METHOD_LOOP(empty, 5, 3 * PIXELS)

static const method_problem tile = {METHOD_HALF_VECTOR,
                                    "half_vector",
                                    "every pixel of 320 x 240 under 8 lights; normals at 24 places of the highlight",
                                    "pixel",
                                    PIXELS,
                                    5,
                                    3 * PIXELS,
                                    TILES *LIGHTS,
                                    7,
                                    exponents,
                                    5,
                                    32 << 16,
                                    input_tile,
                                    bench_input,
                                    empty};

/* Ray towards the eye from a place on the screen in half pixels. */
static inline void find_ray(int32_t x, int32_t y, int32_t ray[3]) {
    ray[0] = (WIDTH - x) * 4096;
    ray[1] = (y - HEIGHT) * 4096;
    ray[2] = METHOD_FOCAL;
}

/* H at a place in half pixels. */
static inline void half_vector_at(const int32_t *in, int32_t x, int32_t y, int16_t half[3]) {
    int32_t ray[3];
    int16_t view[3];
    find_ray(x, y, ray);
    glint_unit(ray[0], ray[1], ray[2], view);
    glint_unit(in[2] + view[0], in[3] + view[1], in[4] + view[2], half);
}

static inline void library_one(const int32_t *in, int32_t *out) {
    for (int i = 0; i < PIXELS; i++, out += 3) {
        int16_t half[3];
        half_vector_at(in, 2 * (in[0] + i % TILE) + 1, 2 * (in[1] + i / TILE) + 1, half);
        for (int c = 0; c < 3; c++) {
            out[c] = half[c];
        }
    }
}
METHOD_LOOP(library, 5, 3 * PIXELS)

/* V and H each by a root and three divisions. */
static inline void divide_by_length(const int32_t v[3], int32_t unit[3]) {
    const int32_t length = (int32_t)method_square_root((uint32_t)(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
    for (int i = 0; i < 3; i++) {
        unit[i] = v[i] * 32764 / length;
    }
}

static inline void divisions_one(const int32_t *in, int32_t *out) {
    for (int i = 0; i < PIXELS; i++, out += 3) {
        int32_t v[3];
        find_ray(2 * (in[0] + i % TILE) + 1, 2 * (in[1] + i / TILE) + 1, v);
        for (int c = 0; c < 3; c++) {
            v[c] = glint_shift_right(v[c], 6); /* the longest is below 2^15 */
        }
        divide_by_length(v, v);
        for (int c = 0; c < 3; c++) {
            v[c] = glint_shift_right(v[c] + in[2 + c], 1);
        }
        divide_by_length(v, out);
    }
}
METHOD_LOOP(divisions, 5, 3 * PIXELS)

/* A plane through the mean of the four corners of a cell, with the mean slopes of its sides. */
static inline void plane_of_cell(int16_t corners[2][2][3], int32_t size, int32_t *out) {
    for (int c = 0; c < 3; c++) {
        const int32_t a = corners[0][0][c], b = corners[0][1][c], d = corners[1][0][c], e = corners[1][1][c];
        const int32_t dx = (b - a + e - d) * (8192 / size), dy = (d - a + e - b) * (8192 / size); /* Q14 */
        const int32_t middle = (a + b + d + e) * 4096 - glint_shift_right((dx + dy) * (size - 1), 1);
        for (int y = 0; y < size; y++) {
            int32_t value = middle + dy * y + 0x2000;
            int32_t *at = out + 3 * TILE * y + c;
            for (int x = 0; x < size; x++, at += 3, value += dx) {
                *at = glint_shift_right(value, 14);
            }
        }
    }
}

/* Corners lie between pixels; cells share them. */
static inline void planes(const int32_t *in, int32_t *out, int32_t size) {
    int16_t row[2][TILE + 1][3];
    for (int32_t y = 0; y <= TILE; y += size) {
        for (int32_t x = 0; x <= TILE; x += size) {
            half_vector_at(in, 2 * (in[0] + x), 2 * (in[1] + y), row[(y / size) & 1][x / size]);
        }
        for (int32_t x = 0; y > 0 && x < TILE; x += size) {
            const int upper = ((y / size) & 1) ^ 1;
            int16_t corners[2][2][3];
            for (int i = 0; i < 6; i++) {
                corners[0][i / 3][i % 3] = row[upper][x / size + i / 3][i % 3];
                corners[1][i / 3][i % 3] = row[upper ^ 1][x / size + i / 3][i % 3];
            }
            plane_of_cell(corners, size, out + 3 * (TILE * (y - size) + x));
        }
    }
}

static inline void plane_8_one(const int32_t *in, int32_t *out) {
    planes(in, out, 8);
}
METHOD_LOOP(plane_8, 5, 3 * PIXELS)

static inline void plane_16_one(const int32_t *in, int32_t *out) {
    planes(in, out, 16);
}
METHOD_LOOP(plane_16, 5, 3 * PIXELS)

static inline void fill(const int16_t half[3], int32_t *out) {
    for (int i = 0; i < PIXELS; i++, out += 3) {
        for (int c = 0; c < 3; c++) {
            out[c] = half[c];
        }
    }
}

static inline void constant_one(const int32_t *in, int32_t *out) {
    int16_t half[3];
    half_vector_at(in, 2 * in[0] + TILE, 2 * in[1] + TILE, half);
    fill(half, out);
}
METHOD_LOOP(constant, 5, 3 * PIXELS)

static inline void infinite_one(const int32_t *in, int32_t *out) {
    int16_t half[3];
    glint_unit(in[2], in[3], in[4] + GLINT_UNIT, half);
    fill(half, out);
}
METHOD_LOOP(infinite, 5, 3 * PIXELS)

static const method methods[] = {
    METHOD(&tile, "glint_unit per fragment", "", "", 1, 0, GLINT_UNIT, 708, 0, library, 41, 78, 110, 217, 432),
    METHOD(&tile, "divisions per fragment", "", "", 0, 0, GLINT_UNIT, 0, 0, divisions, 63, 119, 167, 329, 655),
    METHOD(&tile, "plane over 8", "", "", 0, 0, GLINT_UNIT, 708, 0, plane_8, 121, 212, 290, 557, 1100),
    METHOD(&tile, "plane over 16", "", "", 0, 0, GLINT_UNIT, 708, 0, plane_16, 434, 736, 994, 1890, 3670),
    METHOD(&tile, "constant over 16", "", "", 0, 0, GLINT_UNIT, 708, 0, constant, 20300, 39000, 53900, 106000, 187000),
    METHOD(&tile, "infinite viewer", "", "Blinn 1977", 0, 0, GLINT_UNIT, 708, 0, infinite, 199000, 225000, 226000,
           226000, 226000),
};

const method_list methods_half_vector = METHOD_LIST(methods);
