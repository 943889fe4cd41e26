/* SPDX-License-Identifier: MIT */
/*
 * Point lights. With P = -ray / (1/w), the direction from a fragment to the light at Q is Q (1/w) + ray up to its
 * length: no division by w. Distance and attenuation stay ratios to 1/w too, until the one division at the end.
 */
#include "point.h"

#include "../math/division.h"

glint_status glint_point_attenuation(const glint_light *light, glint_prepared_light *prepared) {
    if (light->linear < 0 || light->quadratic < 0)
        return GLINT_ERROR_ATTENUATION;
    prepared->point.linear_bits = glint_leading_zeros((uint32_t)light->linear) & 31;
    prepared->point.quadratic_bits = glint_leading_zeros((uint32_t)light->quadratic) & 31;
    prepared->point.linear = (uint32_t)light->linear << prepared->point.linear_bits;
    prepared->point.quadratic = (uint32_t)light->quadratic << prepared->point.quadratic_bits;
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
    /* |light vector| / (1/w): Q12 half pixels over Q31, times the nearest w in world units */
    int64_t unit = (n << 30) / view->focal; /* n / focal, Q30: from 2^31 to 2^53 */
    unit += glint_shift_right64(unit, 13);  /* over GLINT_UNIT / 2^15, which find_distance's lengths are times */
    unsigned size = glint_bits64((uint64_t)unit) - 31;
    prepared->point.distance_mantissa = (int32_t)glint_shift_right64(unit, size);
    prepared->point.distance_shift = 30 - (int)size - bits + 28 - 31;
}

/* The high half of a product. */
static inline uint32_t high_product(uint32_t a, uint32_t b) {
    return (uint32_t)(glint_product_unsigned(a, b) >> 32);
}

/* x 2^n for x below 2^31, at most 2^30: what is more counts as that. */
static uint32_t shift_below(uint32_t x, int n) {
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

/*
 * 1 / (1 + linear d + quadratic d^2), Q15, for d = distance 2^exponent / inverse_w, distance from 2^14 to 2^16; numbers
 * of 32 bits with a power of two each.
 */
static uint32_t attenuate(const glint_prepared_light *light, uint32_t inverse_w, uint32_t distance, int exponent) {
    if (!(light->point.linear | light->point.quadratic))
        return 1u << 15;
    if (!inverse_w)
        return 0;
    unsigned zeros, up;
    const uint32_t ratio = distance * invert(inverse_w, &zeros);
    const uint32_t d = high_product(ratio, (uint32_t)light->point.distance_mantissa);
    const int bits = exponent + (int)zeros - 15 - light->point.distance_shift; /* d 2^bits */
    const uint32_t linear =
        shift_below(high_product(d, light->point.linear), 32 + bits - (int)light->point.linear_bits);
    const uint32_t quadratic = shift_below(high_product(high_product(d, d), light->point.quadratic),
                                           64 + 2 * bits - (int)light->point.quadratic_bits);
    const uint32_t inverse = invert((1u << 16) + linear + quadratic, &up); /* of Q16, from 2^16 to 2^16 + 2^31 */
    return (inverse + (1u << (15 - up))) >> (16 - up);
}

/* Leading zeros of a vector's largest component. */
static inline unsigned zeros_of(const int32_t v[3]) {
    return glint_leading_zeros(glint_magnitude_bits(v[0]) | glint_magnitude_bits(v[1]) | glint_magnitude_bits(v[2]));
}

/* Is the light here, or so near, next to the eye, that rounding alone tells where? */
static int is_at_light(const int32_t towards[3], const int32_t ray[3]) {
    const unsigned bits = 32 - zeros_of(towards), to_eye = 32 - zeros_of(ray);
    return bits == 0 || bits + 15 <= to_eye; /* short rays are those of small screens */
}

/*
 * From fragment i towards the light, as 30 bits in the ray's units times 2^-n; Q (1/w) is a product of 61 bits, of
 * which all but lights far beyond what is drawn leave its high half. @return n
 */
static int find_direction(const glint_prepared_light *light, const glint_fragments *fragments, uint32_t i,
                          int32_t towards[3]) {
    const int shift = light->point.shift; /* below 0 only for lights far beyond all that is drawn */
    int64_t far[3];
    for (int c = 0; c < 3; c++) {
        const int64_t position = glint_product(light->point.mantissa[c], fragments->inverse_w[i]);
        const int32_t ray = fragments->ray[i][c];
        if (shift >= 32)
            towards[c] =
                glint_shift_right((int32_t)glint_shift_right64(position, 32), (unsigned)glint_least(shift - 32, 31)) +
                ray;
        else
            far[c] = shift < 0 ? position + glint_shift_right(ray, (unsigned)-shift)
                               : glint_shift_right64(position, (unsigned)shift) + ray;
    }
    return shift >= 32 ? 0 : (int)glint_reduce(far, towards) - (shift < 0 ? shift : 0);
}

/* A vector's direction, unit, and length times GLINT_UNIT / 2^15, of 16 bits times a power of two; v is not 0. */
static uint32_t find_distance(int32_t v[3], int *exponent, int16_t direction[3]) {
    const int down = 17 - (int)zeros_of(v); /* to components of 15 bits */
    for (int c = 0; c < 3; c++)
        v[c] = down > 0 ? glint_shift_right(glint_shift_right(v[c], (unsigned)down - 1) + 1, 1)
                        : glint_shift_left(v[c], (unsigned)-down);
    const uint32_t square = (uint32_t)(v[0] * v[0]) + (uint32_t)(v[1] * v[1]) + (uint32_t)(v[2] * v[2]);
    const int32_t root = glint_inverse_root(square);
    for (int c = 0; c < 3; c++)
        direction[c] = (int16_t)glint_shift_right(v[c] * root + 0x4000, 15);
    *exponent += down;
    return ((square + (1u << 13)) >> 14) * (uint32_t)root >> 16;
}

/* Direction to a light, unit, strength there, and how far it is. */
static void illuminate_one(const glint_prepared_light *light, glint_fragments *fragments, uint32_t i) {
    int32_t v[3];
    int exponent = find_direction(light, fragments, i, v);
    fragments->strength[i] = 0;
    fragments->length[i] = 0;
    if (is_at_light(v, fragments->ray[i])) {
        glint_unit(v[0], v[1], v[2], fragments->light[i]);
        return;
    }
    const uint32_t length = find_distance(v, &exponent, fragments->light[i]);
    fragments->strength[i] = (uint16_t)attenuate(light, (uint32_t)fragments->inverse_w[i], length, exponent);
    fragments->length[i] = length;
    fragments->exponent[i] = (int8_t)exponent;
}

uint32_t glint_point_closeness(const glint_fragments *fragments, uint32_t i) {
    unsigned zeros;
    if (!fragments->length[i])
        return UINT16_MAX;
    const uint32_t depth = (uint32_t)fragments->ray[i][2], inverse = invert(fragments->length[i], &zeros);
    const uint32_t ratio = shift_below(high_product(depth, inverse << 15), (int)zeros - 22 - fragments->exponent[i]);
    return (uint32_t)glint_least((int32_t)ratio, UINT16_MAX - 1) + 1;
}

void glint_point_illuminate(const glint_prepared_light *light, glint_fragments *fragments) {
    for (uint32_t i = 0; i < fragments->count; i++)
        illuminate_one(light, fragments, i);
}

const glint_light_type glint_light_point = {prepare_point, glint_point_illuminate, glint_point_place, 0};
