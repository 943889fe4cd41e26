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
    const unsigned linear_bits = glint_leading_zeros((uint32_t)light->linear) & 31,
                   quadratic_bits = glint_leading_zeros((uint32_t)light->quadratic) & 31;
    prepared->point.linear = (uint32_t)light->linear << linear_bits;
    prepared->point.quadratic = (uint32_t)light->quadratic << quadratic_bits;
    prepared->point.linear_shift = 17 - (int32_t)linear_bits; /* the distance's is not known yet */
    prepared->point.quadratic_shift = 34 - (int32_t)quadratic_bits;
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
    const int32_t shift = 30 - (int32_t)size - bits + 28 - 31;
    prepared->point.linear_shift -= shift;
    prepared->point.quadratic_shift -= 2 * shift;
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

/*
 * 1 / (1 + linear d + quadratic d^2), Q15, for d = distance 2^exponent / inverse_w, distance from 2^14 to 2^16; numbers
 * of 32 bits with a power of two each.
 */
static inline uint32_t attenuate(const glint_prepared_light *light, uint32_t inverse_w, uint32_t distance,
                                 int exponent) {
    if (!(light->point.linear | light->point.quadratic))
        return 1u << 15;
    if (!inverse_w)
        return 0;
    unsigned zeros, up;
    const uint32_t ratio = distance * invert(inverse_w, &zeros);
    const uint32_t d = glint_product_high_unsigned(ratio, (uint32_t)light->point.distance_mantissa);
    const int bits = exponent + (int)zeros;
    const uint32_t linear =
        shift_below(glint_product_high_unsigned(d, light->point.linear), light->point.linear_shift + bits);
    const uint32_t quadratic =
        shift_below(glint_product_high_unsigned(glint_product_high_unsigned(d, d), light->point.quadratic),
                    light->point.quadratic_shift + 2 * bits);
    const uint32_t inverse = invert((1u << 16) + linear + quadratic, &up); /* of Q16, from 2^16 to 2^16 + 2^31 */
    return (inverse + (1u << (15 - up))) >> (16 - up);
}

/* From a fragment towards the light, in the ray's units times 2^-exponent. */
typedef struct towards {
    int32_t x, y, z;
    int exponent;
} towards;

/* Leading zeros of its largest component. */
static inline unsigned zeros_of(const towards *v) {
    return glint_leading_zeros(glint_magnitude_bits(v->x) | glint_magnitude_bits(v->y) | glint_magnitude_bits(v->z));
}

/* Is the light here, or so near, next to the eye, that rounding alone tells where? */
static inline int is_at_light(unsigned zeros, const int32_t ray[3]) {
    const unsigned bits = 32 - zeros;
    if (bits > 32 - 15) /* then no ray is so long */
        return 0;
    const towards eye = {ray[0], ray[1], ray[2], 0};
    return bits == 0 || bits + 15 <= 32 - zeros_of(&eye); /* short rays are those of small screens */
}

/* A component of Q (1/w), a product of 61 bits of which its high half is left, times 2^-down. */
static inline int32_t part_of_position(int32_t mantissa, int32_t inverse_w, unsigned down) {
    return glint_shift_right(glint_product_high(mantissa, inverse_w), down);
}

/* Of a light as far away as what is drawn, or nearer. */
static inline towards towards_near(const glint_prepared_light *light, int32_t inverse_w, const int32_t ray[3]) {
    const int32_t *const mantissa = light->point.mantissa;
    const unsigned down = (unsigned)glint_least(light->point.shift - 32, 31);
    return (towards){part_of_position(mantissa[0], inverse_w, down) + ray[0],
                     part_of_position(mantissa[1], inverse_w, down) + ray[1],
                     part_of_position(mantissa[2], inverse_w, down) + ray[2], 0};
}

/* Of one far beyond: 30 bits of 61 or more. */
static GLINT_NOINLINE void towards_far(const glint_prepared_light *light, int32_t inverse_w, const int32_t ray[3],
                                       towards *to) {
    const int shift = light->point.shift; /* below 32; below 0 only for lights far beyond all that is drawn */
    int64_t far[3];
    int32_t v[3];
    for (int c = 0; c < 3; c++) {
        const int64_t position = glint_product(light->point.mantissa[c], inverse_w);
        far[c] = shift < 0 ? position + glint_shift_right(ray[c], (unsigned)-shift)
                           : glint_shift_right64(position, (unsigned)shift) + ray[c];
    }
    const unsigned exponent = glint_reduce(far, v);
    *to = (towards){v[0], v[1], v[2], (int)exponent - (shift < 0 ? shift : 0)};
}

/* A component of a vector, times 2^-down. */
static inline int32_t scale_down(int32_t component, int down) {
    return down > 0 ? glint_shift_right(glint_shift_right(component, (unsigned)down - 1) + 1, 1)
                    : glint_shift_left(component, (unsigned)-down);
}

/* The same vector with 15 bits, of so many leading zeros. */
static inline towards to_15_bits_of(const towards *v, unsigned zeros) {
    const int down = 17 - (int)zeros;
    return (towards){scale_down(v->x, down), scale_down(v->y, down), scale_down(v->z, down), v->exponent + down};
}

/*
 * Does a surface face away from what lies there, whatever the direction is rounded to? Its components are off by at
 * most 2.4 of UNIT, N.L by 4.2 |v| over |v|, and |v| is below 1.74 2^15.
 */
static inline int faces_away(const int16_t normal[3], const towards *v) {
    return normal[0] * v->x + normal[1] * v->y + normal[2] * v->z < -(9 << 15);
}

/* A vector's direction, unit, and its length times GLINT_UNIT / 2^15, of 16 bits; v has 15. */
static inline uint32_t find_distance(const towards *v, int16_t direction[3]) {
    const int32_t x = v->x, y = v->y, z = v->z;
    const uint32_t square = (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z);
    const int32_t root = glint_inverse_root(square);
    direction[0] = (int16_t)glint_shift_right(x * root + 0x4000, 15);
    direction[1] = (int16_t)glint_shift_right(y * root + 0x4000, 15);
    direction[2] = (int16_t)glint_shift_right(z * root + 0x4000, 15);
    return ((square + (1u << 13)) >> 14) * (uint32_t)root >> 16;
}

/* Direction to a light, unit, strength there, and how far it is. Of what is gated strength alone, which is 0. */
static inline void illuminate_one(const glint_prepared_light *light, glint_fragments *fragments, uint32_t i) {
    const int32_t *const ray = fragments->ray[i], inverse_w = fragments->inverse_w[i];
    int16_t *const direction = fragments->light[i];
    towards v;
    if (light->point.shift >= 32) {
        v = towards_near(light, inverse_w, ray);
    } else {
        towards far; /* of v itself no address is taken: it stays in registers */
        towards_far(light, inverse_w, ray, &far);
        v = far;
    }
    const unsigned zeros = zeros_of(&v);
    if (is_at_light(zeros, ray)) {
        fragments->strength[i] = 0;
        fragments->length[i] = 0;
        glint_unit(v.x, v.y, v.z, direction);
        return;
    }
    v = to_15_bits_of(&v, zeros);
    if (fragments->is_gated && faces_away(fragments->normal[i], &v)) {
        fragments->strength[i] = 0;
        fragments->length[i] = 0;
        return;
    }
    const uint32_t length = find_distance(&v, direction);
    fragments->strength[i] = (uint16_t)attenuate(light, (uint32_t)inverse_w, length, v.exponent);
    fragments->length[i] = length;
    fragments->exponent[i] = (int8_t)v.exponent;
}

uint32_t glint_point_closeness(const glint_fragments *fragments, uint32_t i) {
    unsigned zeros;
    if (!fragments->length[i])
        return UINT16_MAX;
    const uint32_t depth = (uint32_t)fragments->ray[i][2], inverse = invert(fragments->length[i], &zeros);
    const uint32_t ratio =
        shift_below(glint_product_high_unsigned(depth, inverse << 15), (int)zeros - 22 - fragments->exponent[i]);
    return (uint32_t)glint_least((int32_t)ratio, UINT16_MAX - 1) + 1;
}

void glint_point_illuminate(const glint_prepared_light *light, glint_fragments *fragments) {
    for (uint32_t i = 0; i < fragments->count; i++)
        illuminate_one(light, fragments, i);
}

const glint_light_type glint_light_point = {prepare_point, glint_point_illuminate, glint_point_place, 0, 0};
