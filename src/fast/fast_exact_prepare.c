/* SPDX-License-Identifier: MIT */
/* Exact lighting, once a frame: how far its quadratics reach, and where highlights end. */
#include "fast_exact.h"

/* Error of a highlight that a bent half vector may make at the worst place, in 1/64 of a level. */
#define BEND_LIMIT 24

static uint32_t most_levels(const uint32_t weight[3]) {
    uint32_t largest = weight[0] > weight[2] ? weight[0] : weight[2];
    largest *= 31;
    return largest > weight[1] * 63 ? largest : weight[1] * 63;
}

/* Two rows that take N to its deviation from H: x - hx (H + z) / (1 + hz), and y alike. */
static void find_across(glint_exact_limits *limits, const int16_t h[3]) {
    const int32_t inverse = glint_inverse_of_one_and(h[2]);
    for (int row = 0; row < 2; row++) {
        const int32_t along = glint_shift_right(h[row] * inverse, 15);
        for (int c = 0; c < 3; c++) {
            const int32_t part = c == 2 ? h[row] : glint_shift_right(h[c] * along + 0x4000, 15);
            const int32_t value = (c == row ? GLINT_UNIT : 0) - part;
            limits->across[row][c] = (int16_t)glint_shift_right(value * limits->scale + 0x4000, 15);
        }
    }
}

/*
 * At d from where H is known with its slope, in units of the focal length, H is off by at most 0.15 (2 d / |L + V|)^2
 * where L and V are less than 120 degrees apart: by 0.15 d^2 straight before the light.
 */
static void find_bent_extent(glint_exact_limits *limits, const glint_fast_terms *fast, const glint_shading *shading) {
    const uint32_t slope = glint_highlight_slope(shading->material->shininess);                  /* Q8 */
    const uint32_t weight = most_levels(glint_weights_shown(shading)->specular) + 1;             /* Q12 */
    const uint64_t error = ((uint64_t)BEND_LIMIT << (30 + 20 - 6)) / ((uint64_t)weight * slope); /* Q30 */
    const uint32_t d = glint_square_root(error * 20 / 3);                                        /* Q15 */
    const unsigned zeros = glint_leading_zeros((uint32_t)fast->ray_scale);
    /* a pixel in units of the focal length is ray_scale 2^-26 */
    const uint64_t extent = ((uint64_t)d << 26 >> 11) / (uint32_t)fast->ray_scale; /* sixteenths */
    limits->error = error < 1 << 28 ? (int32_t)(error >> 16) : 1 << 12;
    limits->extent = extent < 1 << 10 ? (int32_t)extent : 1 << 10;
    while (limits->cell < 5 && (24 << limits->cell) * limits->bend >> 14 <= limits->extent)
        limits->cell++;
    limits->pixel_shift = 26 - 18 + zeros;
    limits->pixel = (int32_t)((uint32_t)fast->ray_scale << zeros >> 18);
}

void glint_exact_prepare(glint_fast_terms *fast, const glint_frame *frame, const glint_shading *shading) {
    glint_exact_limits *limits = &fast->exact;
    const uint32_t entries = fast->specular_end >> 15, cut = fast->sine_square_end;
    glint_interpolate_prepare(fast, frame, shading);
    if (!cut)
        return;
    const uint64_t density = ((uint64_t)entries << 46) / cut; /* entries over sin^2 from 0 to 1, Q16 */
    const unsigned bits = glint_bits64(density - 1) - 16;
    if (bits > 24)
        return;
    limits->scale = (int32_t)glint_square_root(density << (30 - 16) >> bits);
    limits->scale = limits->scale < INT16_MAX ? limits->scale : INT16_MAX;
    limits->shift = 24 - bits;
    limits->limit = entries << (6 + limits->shift);
    limits->end = entries << 20;
    limits->cut = glint_shift_right((fast->cut + 1) * limits->scale, 15) + 1;
    limits->cut_diagonal = glint_shift_right((fast->cut_diagonal + 1) * limits->scale, 15) + 1;
    limits->behind = -(int32_t)(glint_square_root((uint64_t)((1u << 30) - cut)) / 2);
    if (fast->local_viewer)
        find_bent_extent(limits, fast, shading);
    else
        find_across(limits, fast->half_vector);
}
