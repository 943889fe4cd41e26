/* SPDX-License-Identifier: MIT */
/* Computes how much of each type of light reaches a corner, and each kind of highlight there. corners.h */
#include "../math/division.h"
#include "../math/product.h"
#include "point.h"

/* ---- Vectors ---- */

uint32_t glint_corner_unit(int32_t v[3], int32_t *exponent) {
    int32_t x = v[0], y = v[1], z = v[2];
    const unsigned zeros =
        glint_leading_zeros(glint_magnitude_bits(x) | glint_magnitude_bits(y) | glint_magnitude_bits(z));
    if (zeros < 17) {
        const unsigned down = 17 - zeros;
        const int32_t half = 1 << (down - 1);
        x = glint_shift_right(x + half, down);
        y = glint_shift_right(y + half, down);
        z = glint_shift_right(z + half, down);
    } else {
        x = glint_shift_left(x, zeros - 17);
        y = glint_shift_left(y, zeros - 17);
        z = glint_shift_left(z, zeros - 17);
    }
    const uint32_t square = (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z); /* 2^28 .. 3 2^30, or 0 */
    const int32_t root = square ? glint_inverse_root(square) : 0;
    *exponent = 17 - (int32_t)zeros;
    v[0] = glint_shift_right(x * root + 0x4000, 15);
    v[1] = glint_shift_right(y * root + 0x4000, 15);
    v[2] = glint_shift_right(z * root + 0x4000, 15);
    return ((square + (1u << 13)) >> 14) * (uint32_t)root >> 16;
}

void glint_corner_see_near(const glint_corner_place *place, const glint_lit_point *point, glint_corner_sight *to) {
    const int32_t half = 1 << place->down >> 1;
    for (int i = 0; i < 3; i++)
        to->direction[i] = place->vector[i] - half - glint_shift_right(point->place[i], place->shift);
    to->length = glint_corner_unit(to->direction, &to->exponent);
    to->cosine = glint_shift_right(glint_dot32(point->normal, to->direction), 15);
}

/* ---- Point lights ---- */

/* Returns x 2^n for x below 2^31, clamped at 2^30. */
static inline uint32_t shift_below(uint32_t x, int n) {
    if (n < 0)
        return n > -32 ? x >> -n : 0;
    if ((int)glint_leading_zeros(x) > n + 1)
        return x << n;
    return x ? 1u << 30 : 0;
}

/* Returns 2^(47 - zeros) / x, from 2^15 to 2^16, where `zeros` receives the leading zeros of x; x is not 0. */
static inline uint32_t invert(uint32_t x, unsigned *zeros) {
    *zeros = glint_leading_zeros(x);
    return (uint32_t)glint_reciprocal16(x << *zeros >> 16);
}

/* Cuts x to at most `bits` bits. @return n: x is 2^n times the result */
static int32_t to_bits(uint64_t x, unsigned bits, uint16_t *to) {
    const int32_t down = (int32_t)glint_bits64(x) - (int32_t)bits;
    *to = (uint16_t)(down > 0 ? x >> down : x);
    return glint_most(down, 0);
}

void glint_point_bring(const glint_light *light, const glint_corner_space *space, int32_t place_exponent,
                       glint_corner_light *to) {
    const uint32_t inverse = space->inverse + (space->inverse >> 13); /* lengths are one part in 2^13 too short */
    /* the unit of places is inverse 2^exponent long in the world */
    const int32_t exponent = space->inverse_exponent - 28 + place_exponent;
    const uint64_t linear = glint_product_unsigned((uint32_t)light->linear, inverse),
                   quadratic = glint_product_unsigned((uint32_t)light->quadratic, inverse * (inverse >> 2) >> 14);
    to->linear_exponent = (int16_t)(to_bits(linear, 16, &to->linear) + exponent);
    to->quadratic_exponent = (int16_t)(to_bits(quadratic, 15, &to->quadratic) + 16 + 15 + 2 * exponent);
}

/* Returns 1 / (1 + linear d + quadratic d^2), Q15, at distance d = length 2^exponent, length of 16 bits. */
static inline uint32_t attenuate(const glint_corner_light *light, uint32_t length, int32_t exponent) {
    unsigned up;
    if (!(light->linear | light->quadratic))
        return 1u << 15;
    const uint32_t linear = shift_below(light->linear * length >> 1, light->linear_exponent + exponent + 1),
                   quadratic = shift_below((length * length >> 15) * light->quadratic >> 1,
                                           light->quadratic_exponent + 2 * exponent + 1);
    const uint32_t inverse = invert((1u << 16) + linear + quadratic, &up);
    return (inverse + (1u << (15 - up))) >> (16 - up);
}

/* If a way in units of places has fewer bits, its direction is nothing but rounding. */
#define LEAST_WAY_BITS 10

uint32_t glint_point_reach(const glint_corner_light *light, const glint_lit_point *point, glint_corner_sight *to) {
    if (!glint_corner_see(&light->place, point, light->is_gated, to) ||
        to->exponent + light->place.shift <= LEAST_WAY_BITS - 15 || (light->is_gated && to->cosine <= 0))
        return 0;
    return attenuate(light, to->length, to->exponent);
}

/* ---- Spots ---- */

/* Returns the part of a spot's light that its cone lets through, Q15, given the cosine between the way to the light and
 * the axis, times GLINT_UNIT^2. */
static inline uint32_t attenuate_corner_by_cone(const glint_prepared_light *light, int32_t cosine) {
    if (cosine >= light->spot.cosine_inner)
        return 1u << 15;
    /* `past` is at most inner - outer, and `slope` is 2^30 over this: their product is at most 2^30 */
    const int32_t past = glint_shift_right(cosine - light->spot.cosine_outer, light->spot.shift);
    return past > 0 ? glint_smooth_step((uint32_t)glint_shift_right(past * light->spot.slope, 15)) : 0;
}

void glint_spot_bring(const glint_light *light, const glint_corner_space *space, int32_t place_exponent,
                      glint_corner_light *to) {
    int32_t towards[3];
    glint_point_bring(light, space, place_exponent, to);
    glint_corner_towards(space, light, towards);
    for (int i = 0; i < 3; i++)
        to->axis[i] = (int16_t)towards[i];
    to->axis_excess = glint_dot(to->axis, to->axis) - glint_dot(to->source->direction, to->source->direction);
}

uint32_t glint_spot_reach(const glint_corner_light *light, const glint_lit_point *point, glint_corner_sight *to) {
    const uint32_t strength = glint_point_reach(light, point, to);
    const int32_t *const direction = to->direction;
    if (!strength)
        return 0;
    /* the cosine is corrected for the lengths of both vectors */
    const int32_t excess = glint_dot32(direction, direction) - GLINT_UNIT * GLINT_UNIT + light->axis_excess,
                  cosine =
                      direction[0] * light->axis[0] + direction[1] * light->axis[1] + direction[2] * light->axis[2];
    return strength * attenuate_corner_by_cone(light->source, cosine - glint_excess(cosine, excess)) >> 15;
}

/* ---- Highlights ---- */

/* Returns 0^p, Q15; 0^0 is 1. */
static inline uint32_t power_of_zero(const glint_power_table *table) {
    return table->exponent ? 0 : 1u << 15;
}

/* Returns x^p, Q15, for p < 2, x Q31 from 1 to 2^31; off by at most 3 steps. */
static uint32_t power_by_octaves(const glint_power_table *table, uint32_t x) {
    const unsigned zeros = glint_leading_zeros(x);
    if (!zeros)
        return 1u << 15;
    const uint32_t mantissa = (x << zeros) & 0x7fffffff; /* without its top bit, which is 1/2 */
    const uint16_t *node = &table->value[mantissa >> 25];
    const uint32_t rise = (uint32_t)(node[1] - node[0]) * (mantissa >> 13 & 0xfff);
    return (node[0] + (rise >> 12)) * table->value[GLINT_POWER_OCTAVE + zeros] >> 15;
}

/* The square of a right angle's chord. */
#define CHORD_OF_RIGHT_ANGLE (2u * GLINT_UNIT * GLINT_UNIT)

/*
 * Returns cos^p, Q15, of the angle between two vectors whose length is GLINT_UNIT to within 2^-12, given the square of
 * the chord between their ends, below 2^32.
 */
static uint32_t power_of_chord(const glint_power_table *table, uint32_t chord) {
    if (chord >= CHORD_OF_RIGHT_ANGLE)
        return power_of_zero(table);
    const uint32_t lacking = chord >> 12; /* GLINT_UNIT^2 is 2^30 less a part in 2^12 */
    if (table->direct)                    /* cos = 1 - chord / 2 */
        return power_by_octaves(table, (1u << 31) - chord - lacking);
    const uint32_t half = chord >> 16; /* sin^2 = chord - (chord / 2)^2, as much below 2^30 as the table expects */
    return glint_power_at(table, chord - half * half - lacking);
}

/*
 * Phong: the angle between R = 2 (N.L / N.N) N - L and V, by the chord R - V. R has the length of L. Without the
 * division by N.N the direction of R would be off by up to 2^-13. Whatever the lengths, |R - V| is below 2^16.
 */
uint32_t glint_highlight_of_mirror(const glint_power_table *table, const int32_t normal[3], const int32_t light[3],
                                   const int32_t view[3]) {
    const int32_t lacking = (1 << 30) - glint_dot32(normal, normal), cosine = glint_dot32(normal, light);
    const int32_t share = cosine + glint_shift_right(cosine, 15) * glint_shift_right(lacking + (1 << 14), 15);
    const int32_t scale = glint_shift_right(share + (1 << 14), 15); /* N.L / N.N, Q15 */
    const int32_t x = glint_shift_right(scale * normal[0] + (1 << 13), 14) - light[0] - view[0],
                  y = glint_shift_right(scale * normal[1] + (1 << 13), 14) - light[1] - view[1],
                  z = glint_shift_right(scale * normal[2] + (1 << 13), 14) - light[2] - view[2];
    return power_of_chord(table, (uint32_t)x * (uint32_t)x + (uint32_t)y * (uint32_t)y + (uint32_t)z * (uint32_t)z);
}

/* If L + V is shorter, the light is straight behind, and the direction of L + V is nothing but rounding. */
#define LEAST_SUM 8

/* Blinn-Phong: the angle between N and H = L + V. Before H is made unit, (N.H)^2 is compared with |H|^2 times the least
 * cos^2 of the table, rounded to the safe side: beyond it the highlight is 0. */
uint32_t glint_highlight_of_half_vector(const glint_power_table *table, const int32_t normal[3], const int32_t light[3],
                                        const int32_t view[3]) {
    int32_t x = light[0] + view[0], y = light[1] + view[1], z = light[2] + view[2];
    const int32_t dot = normal[0] * x + normal[1] * y + normal[2] * z; /* below 2^31, as |H| is at most 2 GLINT_UNIT */
    const uint32_t square = (uint32_t)x * (uint32_t)x + (uint32_t)y * (uint32_t)y + (uint32_t)z * (uint32_t)z;
    if (dot <= 0 || square < LEAST_SUM * LEAST_SUM)
        return power_of_zero(table);
    const int32_t bound = glint_shift_right(dot, 16) + 1;
    if (bound * bound < table->cosine_square_floor * (int32_t)(square >> 17))
        return 0;
    if (square >= 1u << 30) { /* the angle between light and eye is below 120 degrees */
        const int32_t root = glint_inverse_root(square >> 2);
        x = glint_shift_right(glint_shift_right(x, 1) * root + 0x4000, 15);
        y = glint_shift_right(glint_shift_right(y, 1) * root + 0x4000, 15);
        z = glint_shift_right(glint_shift_right(z, 1) * root + 0x4000, 15);
    } else {
        int32_t h[3] = {x, y, z}, exponent;
        glint_corner_unit(h, &exponent);
        x = h[0];
        y = h[1];
        z = h[2];
    }
    x -= normal[0];
    y -= normal[1];
    z -= normal[2];
    return power_of_chord(table, (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z));
}
