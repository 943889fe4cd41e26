/* SPDX-License-Identifier: MIT */
/* Point lights: their place in the units of lamps.c, and how corners see them. */
#include "point.h"
#include "lamps.h"

#include "../math/division.h"

glint_status glint_point_attenuation(const glint_light *light, glint_prepared_light *prepared) {
    if (light->linear < 0 || light->quadratic < 0)
        return GLINT_ERROR_ATTENUATION;
    (void)prepared;
    return GLINT_OK;
}

static glint_status prepare_point(const glint_light *light, glint_prepared_light *prepared, const glint_view *view) {
    (void)view;
    return glint_point_attenuation(light, prepared);
}

/* Quotients of 31 bits, with a sign: scaled / n 2^wide, scaled up to 2^59, n from 2^30 to 2^31. @return wide */
static int find_mantissas(const int64_t scaled[3], int64_t n, int32_t mantissa[3]) {
    const uint64_t all = glint_magnitude64(scaled[0]) | glint_magnitude64(scaled[1]) | glint_magnitude64(scaled[2]);
    const int wide = 61 - (int)glint_bits64(all | 1);
    for (int i = 0; i < 3; i++)
        mantissa[i] = (int32_t)(scaled[i] * ((int64_t)1 << wide) / n);
    return wide;
}

/* A number as one of 14 bits. @return n: it is 2^n times that */
static int32_t to_14_bits(uint64_t x, uint16_t *to) {
    const int32_t down = (int32_t)glint_bits64(x) - 14;
    *to = (uint16_t)(down > 0 ? x >> down : x << -down);
    return down;
}

/*
 * Brings a light to the units of lamps.c, in which a fragment's place is the way to the eye over 1/w. Such a unit is
 * nearest 2^(12 - 31) / (ray_scale focal) long where 1/w is 1, nearest in Q28; nearest is n 2^bits.
 */
static void place_lamp(const glint_light *light, glint_prepared_light *prepared, const glint_view *view, int64_t n,
                       int bits) {
    uint64_t under = (uint64_t)view->ray_scale * (uint32_t)view->focal;
    const int under_bits = (int)glint_bits64(under) - 31;
    under = under_bits > 0 ? under >> under_bits : under << -under_bits;
    const uint64_t unit = ((uint64_t)n << 31) / (under | 1u << 30); /* 30 to 32 bits; the divisor has that bit */
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
    const int32_t world[3] = {light->vector.x, light->vector.y, light->vector.z};
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
    /* position Q32 / nearest Q28 is 2^-4, and 1/w is Q31 */
    prepared->point.shift = bits + 4 - up + 31 + find_mantissas(scaled, n, prepared->point.mantissa);
    place_lamp(light, prepared, view, n, bits);
}

/* x 2^n for x below 2^31, at most 2^30: what is more counts as that. */
static inline uint32_t shift_below(uint32_t x, int n) {
    if (n < 0)
        return n > -32 ? x >> -n : 0;
    if ((int)glint_leading_zeros(x) > n + 1)
        return x << n;
    return x ? 1u << 30 : 0;
}

/* 2^(31 - zeros) 2^16 / x, from 2^15 to 2^16, for x of so many leading zeros; x is not 0. */
static inline uint32_t invert(uint32_t x, unsigned *zeros) {
    *zeros = glint_leading_zeros(x);
    return (uint32_t)glint_reciprocal16(x << *zeros >> 16);
}

/* ---- Corners ---- */

/* Brings x to at most `bits` bits. @return n: it is 2^n times the result */
static int32_t to_bits(uint64_t x, unsigned bits, uint16_t *to) {
    const int32_t down = (int32_t)glint_bits64(x) - (int32_t)bits;
    *to = (uint16_t)(down > 0 ? x >> down : x);
    return glint_most(down, 0);
}

void glint_point_bring(const glint_light *light, const glint_corner_space *space, int32_t place_exponent,
                       glint_corner_light *to) {
    const uint32_t inverse = space->inverse + (space->inverse >> 13); /* lengths are that part too short */
    /* a length of a unit of places in those of the world: inverse 2^exponent */
    const int32_t exponent = space->inverse_exponent - 28 + place_exponent;
    const uint64_t linear = glint_product_unsigned((uint32_t)light->linear, inverse),
                   quadratic = glint_product_unsigned((uint32_t)light->quadratic, inverse * (inverse >> 2) >> 14);
    to->linear_exponent = (int16_t)(to_bits(linear, 16, &to->linear) + exponent);
    to->quadratic_exponent = (int16_t)(to_bits(quadratic, 15, &to->quadratic) + 16 + 15 + 2 * exponent);
}

/* 1 / (1 + linear d + quadratic d^2), Q15, at a distance length 2^exponent, length of 16 bits. */
static inline uint32_t fade(const glint_corner_light *light, uint32_t length, int32_t exponent) {
    unsigned up;
    if (!(light->linear | light->quadratic))
        return 1u << 15;
    const uint32_t linear = shift_below(light->linear * length >> 1, light->linear_exponent + exponent + 1),
                   quadratic = shift_below((length * length >> 15) * light->quadratic >> 1,
                                           light->quadratic_exponent + 2 * exponent + 1);
    const uint32_t inverse = invert((1u << 16) + linear + quadratic, &up);
    return (inverse + (1u << (15 - up))) >> (16 - up);
}

/* Bits of a way, in units of places, below which rounding alone tells where the light is. */
#define LEAST_WAY_BITS 10

uint32_t glint_point_reach(const glint_corner_light *light, const glint_lit_point *point, glint_corner_sight *to) {
    if (!glint_corner_see(&light->place, point, light->is_gated, to) ||
        to->exponent + light->place.shift <= LEAST_WAY_BITS - 15 || (light->is_gated && to->cosine <= 0))
        return 0;
    return fade(light, to->length, to->exponent);
}

const glint_light_type glint_light_point = {.prepare = prepare_point,
                                            .has_place = 1,
                                            .place = glint_point_place,
                                            .arrive = glint_arrive_from_place,
                                            .bring = glint_point_bring,
                                            .reach = glint_point_reach};
