/* SPDX-License-Identifier: MIT */
/* Quadratic interpolation of lighting, once a frame: how far normals may turn for it. */
#include "fast_exact.h"

/* Errors of N.L and of the highlight that interpolation may make at the worst place, levels in Q12. */
#define COSINE_LIMIT 600
#define HIGHLIGHT_LIMIT 2225

/* Triangles that cover more than this part of the screen err in so many of a frame's pixels at once that they have half
 * the limits. */
#define LARGE_PART 256

/* Of an error budget, levels in Q12: what exact lighting errs, and from where on fast lighting shares it. */
#define KEPT 512
#define SHARED 2048

/*
 * sin^2 of the angle from the half vector, Q30, up to which corners are taken to face it: those behind it are beyond.
 * Highlights that reach as far as the lesser one keep to that: there sin^2 is the steepest.
 */
#define FRONT 869730877
#define NARROW_FRONT 1052266987

static uint32_t largest_level(const uint32_t weight[3]) {
    uint32_t largest = weight[0] > weight[2] ? weight[0] : weight[2];
    largest *= 31;
    largest = largest > weight[1] * 63 ? largest : weight[1] * 63;
    return largest ? largest : 1;
}

/*
 * For normals that turn by d = |Na - Nb| along a triangle's longest turn, a normal is off by at most 0.0245 d^3.
 * @return d^2, Q15, at which this makes `limit` of a level, Q12, given what turning by 1 makes, levels in Q12
 */
static int32_t find_turn(uint64_t limit, uint64_t levels) {
    const uint64_t cube = (limit << 19) / ((levels * 803 >> 15) + 1); /* d^3, Q19: 0.0245 is 803 2^-15 */
    const uint64_t square = cube < 1 << 19 ? cube * cube << 7 : UINT64_MAX;
    uint64_t turn = 0;
    for (uint64_t bit = 1 << 14; bit; bit >>= 1)
        if ((turn | bit) * (turn | bit) * (turn | bit) <= square)
            turn |= bit;
    return turn < GLINT_INTERPOLATE_TURN ? (int32_t)turn : GLINT_INTERPOLATE_TURN;
}

/* N.L, Q14, at which all light together, with all of a highlight, comes to 1 in some channel. */
static int32_t find_full(const glint_shading *shading) {
    const glint_weights *const weights = glint_weights_shown(shading);
    int32_t full = INT16_MAX;
    for (int c = 0; c < 3; c++) {
        const uint32_t diffuse = weights->diffuse[c]; /* Q12 */
        const int64_t left = (1 << 12) - (int64_t)((shading->ambient[c] + 2047) >> 11) - weights->specular[c];
        if (left < 0)
            return 0;
        if (diffuse && left * (1 << 14) < (int64_t)full * diffuse)
            full = (int32_t)(left * (1 << 14) / diffuse);
    }
    return full;
}

/*
 * What an error budget leaves for triangles that are lit exactly without one: all but what the highlight's edge takes,
 * a quarter of what is shared. Those that are interpolated anyway stay as they are.
 */
static uint64_t find_limit(const glint_shading *shading, uint32_t least_limit) {
    const uint32_t levels = shading->spare * 63, shared = levels > SHARED ? (levels - SHARED) / 4 : 0;
    return levels > least_limit + shared + KEPT ? levels - shared - KEPT : least_limit;
}

/*
 * Where a ray turns by d, V turns by at most that, and H = (L + V) / |L + V| by at most d / |L + V|, with |L + V|^2 =
 * 2 + 2 L.V. @return 1 / |L + V| at most, Q15, on the screen and GLINT_NEAR_EXTENT around it
 */
static int32_t find_bend(const glint_fast_terms *fast) {
    const int16_t *l = fast->light;
    if (glint_most(fast->center_x, fast->center_y) > fast->ray_limit)
        return 1 << 15;
    const int32_t x = (fast->center_x * fast->ray_scale >> 16) + GLINT_NEAR_EXTENT;
    const int32_t y = (fast->center_y * fast->ray_scale >> 16) + GLINT_NEAR_EXTENT;
    const int32_t cosine = l[2] - (glint_most(l[0], -l[0]) * x >> 14) - (glint_most(l[1], -l[1]) * y >> 14) - 2;
    const int32_t square = (1 << 16) + 2 * glint_least(cosine, 0);
    return square < 1 << 15 ? 1 << 15 : (glint_inverse_root((uint32_t)square << 13) >> 1) + 4;
}

void glint_interpolate_prepare(glint_fast_terms *fast, const glint_frame *frame, const glint_shading *shading) {
    glint_exact_limits *limits = &fast->exact;
    const uint32_t diffuse = largest_level(glint_weights_shown(shading)->diffuse);
    const uint32_t specular = largest_level(glint_weights_shown(shading)->specular);
    const uint32_t slope = glint_highlight_slope(shading->material->shininess); /* Q8 */
    const uint32_t highlight = HIGHLIGHT_LIMIT * glint_highlight_share(shading->material->shininess) >> 10;
    const uint32_t scale = (uint32_t)fast->scale >> 4; /* Q12 */
    limits->bend = find_bend(fast);
    limits->full = find_full(shading);
    /* with an error budget, that is what counts */
    limits->large = shading->spare ? INT32_MAX : frame->config.width * frame->config.height / LARGE_PART * 512;
    limits->turn = find_turn(find_limit(shading, COSINE_LIMIT), diffuse);
    limits->turn_specular = find_turn(find_limit(shading, highlight), ((uint64_t)specular * slope >> 8) + 1);
    const uint64_t facing = fast->sine_square_end < FRONT ? NARROW_FRONT : FRONT;
    const uint64_t front = facing * scale * scale >> 26;
    limits->front = front < UINT32_MAX ? (uint32_t)front : UINT32_MAX;
}
