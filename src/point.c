/* SPDX-License-Identifier: MIT */
/*
 * Point lights. With P = -ray / (1/w), the direction from a fragment to the light at Q is Q (1/w) + ray up to its
 * length: no division by w. Distance and attenuation stay ratios to 1/w too, until the one division at the end.
 */
#include "point.h"

static glint_status prepare(const glint_light *light, glint_prepared_light *prepared, const glint_view *view) {
    (void)view;
    prepared->point.linear = light->linear;
    prepared->point.quadratic = light->quadratic;
    return light->linear < 0 || light->quadratic < 0 ? GLINT_ERROR_ATTENUATION : GLINT_OK;
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
    for (int i = 0; i < 3; i++)
        prepared->point.mantissa[i] = (int32_t)((int64_t)reduced[i] * view->focal / n);
    /* position Q32 / nearest Q28 is 2^-4, and 1/w is Q31 */
    prepared->point.shift = bits + 4 - up + 31;
    /* |light vector| / (1/w): Q12 half pixels over Q31, times the nearest w in world units */
    int64_t unit = (n << 30) / view->focal; /* n / focal, Q30: from 2^31 to 2^53 */
    unsigned size = glint_bits64((uint64_t)unit) - 31;
    prepared->point.distance_mantissa = (int32_t)glint_shift_right64(unit, size);
    prepared->point.distance_shift = 30 - (int)size - bits + 28 - 31;
}

/* x 2^shift; shift below 32, but where x is 0. */
static uint64_t shifted(uint64_t x, int shift) {
    return shift >= 0 ? (shift < 32 ? x << shift : x << 32) : shift > -64 ? x >> -shift : 0;
}

static inline int bits_of(uint32_t x) {
    return 32 - (int)glint_leading_zeros(x);
}

/*
 * 1 / (1 + linear d + quadratic d^2), Q15, for d = distance 2^exponent / inverse_w; distance below 2^16. With d = b / a
 * all three terms, times a^2, are brought below 2^61: where none of them is 2^16 times the first, which makes the
 * result 0, that leaves a 12 bits or more.
 */
static uint32_t attenuate(const glint_prepared_light *light, uint32_t inverse_w, uint32_t distance, int exponent) {
    const uint32_t linear = (uint32_t)light->point.linear, quadratic = (uint32_t)light->point.quadratic;
    uint64_t product = (uint64_t)distance * (uint32_t)light->point.distance_mantissa; /* below 2^47 */
    exponent -= light->point.distance_shift;
    int size_a = bits_of(inverse_w), size_b = (int)glint_bits64(product) + exponent;
    int top = glint_most_of(size_a - 22, glint_shift_right(size_a + size_b + bits_of(linear) - 60, 1),
                            size_b + glint_shift_right(bits_of(quadratic) - 60, 1));
    uint64_t a = shifted(inverse_w, -top), b = shifted(product, exponent - top);
    a |= a == 0;
    uint64_t one = a * a << 16;
    uint64_t sum = one + a * b * linear + b * b * quadratic;
    int down = (int)glint_bits64(sum) - 31;
    sum = shifted(sum, -down);
    one = shifted(one, -down);
    uint32_t divisor = (uint32_t)(sum >> 15);
    uint32_t result = divisor ? (uint32_t)one / divisor : 0;
    return result > 1u << 15 ? 1u << 15 : result;
}

/* Is the light here, or so near, next to the eye, that rounding alone tells where? */
static int is_at_light(const int64_t towards[3], const int32_t ray[3]) {
    unsigned distance =
        glint_bits64(glint_magnitude64(towards[0]) | glint_magnitude64(towards[1]) | glint_magnitude64(towards[2]));
    unsigned to_eye = 32 - glint_leading_zeros(glint_magnitude_bits(ray[0]) | glint_magnitude_bits(ray[1]) |
                                               glint_magnitude_bits(ray[2]));
    return distance == 0 || distance + 15 <= to_eye; /* short rays are those of small screens */
}

/* From fragment i towards the light, its length in the ray's units times 2^scale. @return scale. */
static int find_direction(const glint_prepared_light *light, const glint_fragments *fragments, uint32_t i,
                          int64_t towards[3]) {
    const int shift = light->point.shift; /* -17 to 62; below 0 only for lights far beyond all that is drawn */
    for (int c = 0; c < 3; c++) {
        int64_t position = (int64_t)light->point.mantissa[c] * fragments->inverse_w[i];
        int32_t ray = fragments->ray[i][c];
        if (shift >= 0)
            towards[c] = glint_shift_right64(position, (unsigned)shift) + ray;
        else
            towards[c] = position + glint_shift_right(ray, (unsigned)-shift);
    }
    return shift < 0 ? shift : 0;
}

/* Length of a vector of 30 bits, as a number of 16 bits times 2^exponent. */
static uint32_t find_length(const int32_t in[3], int *exponent) {
    int32_t v[3];
    unsigned zeros =
        glint_leading_zeros(glint_magnitude_bits(in[0]) | glint_magnitude_bits(in[1]) | glint_magnitude_bits(in[2]));
    int down = 17 - (int)zeros;
    for (int c = 0; c < 3; c++)
        v[c] = down > 0 ? glint_shift_right(in[c], (unsigned)down) : glint_shift_left(in[c], (unsigned)-down);
    uint32_t square = (uint32_t)(v[0] * v[0]) + (uint32_t)(v[1] * v[1]) + (uint32_t)(v[2] * v[2]);
    *exponent += down;
    return (uint32_t)(((uint64_t)square * (uint32_t)glint_inverse_root(square)) >> 30);
}

/* Depth over a distance, Q8: both in the ray's units. */
static uint16_t find_closeness(uint32_t depth, uint32_t length, int exponent) {
    const uint64_t ratio = (shifted(depth, 8 - exponent) + length) / length;
    return ratio > UINT16_MAX ? UINT16_MAX : (uint16_t)ratio;
}

void glint_point_illuminate(const glint_prepared_light *light, glint_fragments *fragments) {
    for (uint32_t i = 0; i < fragments->count; i++) {
        int64_t towards[3];
        int32_t v[3];
        int scale = find_direction(light, fragments, i, towards);
        int exponent = (int)glint_reduce(towards, v) - scale;
        glint_unit(v[0], v[1], v[2], fragments->light[i]);
        if (is_at_light(towards, fragments->ray[i])) {
            fragments->strength[i] = 0;
            fragments->closeness[i] = UINT16_MAX;
            continue;
        }
        uint32_t length = find_length(v, &exponent);
        fragments->closeness[i] = find_closeness((uint32_t)fragments->ray[i][2], length, exponent);
        fragments->strength[i] = (uint16_t)attenuate(light, (uint32_t)fragments->inverse_w[i], length, exponent);
    }
}

const glint_light_type glint_light_point = {prepare, glint_point_illuminate, glint_point_place};
