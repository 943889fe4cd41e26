/* SPDX-License-Identifier: MIT */
/* Point lights: brings their places to the units of lamps.c. */
#include "point.h"
#include "lamps.h"

#include "../math/division.h"

static glint_status prepare_point(const glint_light *light, glint_prepared_light *prepared, const glint_view *view) {
    (void)prepared, (void)view;
    return glint_light_grows(light) ? GLINT_ERROR_ATTENUATION : GLINT_OK;
}

/* Sets mantissa = scaled / n 2^up, 31 bits and a sign, for `scaled` up to 2^59 and n from 2^30 to 2^31. @return up */
static int find_mantissas(const int64_t scaled[3], int64_t n, int32_t mantissa[3]) {
    const uint64_t all = glint_magnitude64(scaled[0]) | glint_magnitude64(scaled[1]) | glint_magnitude64(scaled[2]);
    const int up = 61 - (int)glint_bits64(all | 1);
    for (int i = 0; i < 3; i++)
        mantissa[i] = (int32_t)(scaled[i] * ((int64_t)1 << up) / n);
    return up;
}

/* Scales x to 14 bits, rounded down. @return n: x is 2^n times the result */
static int32_t to_14_bits(uint64_t x, uint16_t *to) {
    const int32_t down = (int32_t)glint_bits64(x) - 14;
    *to = (uint16_t)(down > 0 ? x >> down : x << -down);
    return down;
}

/*
 * Brings a light to the units of lamps.c, in which a fragment's place is the vector to the eye over 1/w. Where 1/w is
 * 1, such a unit is nearest 2^(12 - 31) / (ray_scale focal) long, with `nearest` in Q28: n 2^bits.
 */
static void place_lamp(const glint_light *light, glint_prepared_light *prepared, const glint_view *view, int64_t n,
                       int bits) {
    uint64_t under = (uint64_t)view->ray_scale * (uint32_t)view->focal;
    const int under_bits = (int)glint_bits64(under) - 31;
    under = under_bits > 0 ? under >> under_bits : under << -under_bits;
    const uint64_t unit = ((uint64_t)n << 31) / (under | 1u << 30); /* 30 to 32 bits; `under` has bit 30 anyway */
    const int exponent = bits - under_bits - 31 + 12;
    const uint32_t unit16 = (uint32_t)(unit >> 16);
    const int up = (int)glint_leading_zeros((uint32_t)view->ray_scale) - 1;
    int64_t place[3];
    for (int c = 0; c < 3; c++)
        place[c] = glint_product(prepared->point.mantissa[c], view->ray_scale << up);
    prepared->lamp.shift = prepared->point.shift + 24 + up - (int32_t)glint_reduce(place, prepared->lamp.place);
    prepared->lamp.linear_shift =
        (int16_t) - (to_14_bits(unit * (uint32_t)light->linear, &prepared->lamp.linear) + exponent);
    prepared->lamp.quadratic_shift =
        (int16_t) - (to_14_bits((uint64_t)unit16 * unit16 * (uint32_t)light->quadratic, &prepared->lamp.quadratic) +
                     2 * (exponent + 16) + 16);
}

void glint_point_place(const glint_light *light, glint_prepared_light *prepared, const glint_view *view) {
    const int32_t world[3] = {light->position.x, light->position.y, light->position.z};
    int64_t relative[3];
    int32_t reduced[3];
    for (int i = 0; i < 3; i++) {
        relative[i] = 0;
        for (int j = 0; j < 3; j++)
            relative[i] += view->rotation[i][j] * ((int64_t)world[j] - view->eye[j]); /* Q32, below 2^52 */
    }
    int up = (int)glint_reduce(relative, reduced);
    int bits = (int)glint_bits64((uint64_t)view->nearest) - 31; /* nearest = n 2^bits, Q28 */
    int64_t n = bits > 0 ? glint_shift_right64(view->nearest, (unsigned)bits) : view->nearest * ((int64_t)1 << -bits);
    int64_t scaled[3];
    for (int i = 0; i < 3; i++)
        scaled[i] = (int64_t)reduced[i] * view->focal;
    /* positions are Q32 and `nearest` is Q28, so that quotients are Q4; and 1/w is Q31 */
    prepared->point.shift = bits + 4 - up + 31 + find_mantissas(scaled, n, prepared->point.mantissa);
    place_lamp(light, prepared, view, n, bits);
}

const glint_light_type glint_light_point = {.prepare = prepare_point,
                                            .has_place = 1,
                                            .places = &glint_lamp_places,
                                            .place = glint_point_place,
                                            .arrive = glint_arrive_from_place,
                                            .bring = glint_point_bring,
                                            .reach = glint_point_reach};
