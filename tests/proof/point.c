/* SPDX-License-Identifier: MIT */
/* Point lights. */
#include "proof.h"

#include "../../src/light/point.c"
#include "bits.h"
#include "ranges.h"

#define MOST (1 << 30)

/* What glint_point_place hands on. */
static void any_placed(glint_prepared_light *light) {
    for (int c = 0; c < 3; c++)
        light->point.mantissa[c] = ANY_INT;
    light->point.shift = ANY(-16, 122);
    light->point.distance_mantissa = ANY(1 << 30, INT32_MAX);
    light->point.linear = ANY_UNSIGNED(0, UINT_MAX);
    light->point.quadratic = ANY_UNSIGNED(0, UINT_MAX);
    light->point.linear_shift = ANY(-58, 63);
    light->point.quadratic_shift = ANY(-85, 126);
}

static void any_fragment(glint_fragments *fragments) {
    fragments->count = 1;
    fragments->inverse_w[0] = ANY(0, INT32_MAX);
    for (int c = 0; c < 3; c++) {
        fragments->ray[0][c] = ANY(c < 2 ? -MOST : 0, MOST);
        fragments->normal[0][c] = ANY_COMPONENT;
    }
    fragments->is_gated = (uint8_t)ANY(0, 1);
}

/*@ requires \valid_read(scaled + (0 .. 2)) && \valid(mantissa + (0 .. 2));
    requires \subset(scaled[0 .. 2], (-0x800000000000000 .. 0x800000000000000));
    requires 0x40000000 <= n <= 0x7fffffff;
    assigns \result, mantissa[0 .. 2] \from scaled[0 .. 2], n;
    ensures 1 <= \result <= 60;
    ensures \initialized(mantissa + (0 .. 2)); */
static int find_mantissas(const int64_t scaled[3], int64_t n, int32_t mantissa[3]);

/*@ requires \valid_read(light) && \valid_read(ray + (0 .. 2)) && \valid(to);
    assigns *to \from indirect: *light, inverse_w, ray[0 .. 2];
    ensures \initialized(to) && 0 <= to->exponent <= 51; */
static void towards_far(const glint_prepared_light *light, int32_t inverse_w, const int32_t *ray, towards *to);

/* Stands on glint_magnitude_bits, which has at most 31. */
/*@ requires \valid_read(v);
    assigns \result \from *v;
    admit ensures 1 <= \result <= 32; */
static inline unsigned zeros_of(const towards *v);

/*@ requires \valid_read(v) && 1 <= zeros <= 32;
    requires 0 <= v->exponent <= 51;
    assigns \result \from *v, zeros;
    ensures -15 <= \result.exponent <= 67; */
static inline towards to_15_bits_of(const towards *v, unsigned zeros);

/*@ requires \valid_read(normal + (0 .. 2)) && \valid_read(v);
    assigns \result \from normal[0 .. 2], *v;
    ensures \result == 0 || \result == 1; */
static inline int faces_away(const int16_t *normal, const towards *v);

/* Stands on what glint_unit does: the same steps; and on a root's relative error of at most 5.44e-5, which leaves a
 * length of 2^28 and more no less than 2^14 but for rounding: `make domains` takes every root. */
/*@ requires \valid_read(v) && \valid(direction + (0 .. 2));
    assigns \result, direction[0 .. 2] \from *v;
    ensures \result <= 0xffff;
    admit ensures \result >= 1;
    ensures \initialized(direction + (0 .. 2));
    admit ensures \subset(direction[0 .. 2], (-32767 .. 32767)); */
static inline uint32_t find_distance(const towards *v, int16_t *direction);

/*@ requires x < 0x80000000;
    requires -115 <= n <= 322;
    assigns \result \from x, n;
    ensures \result <= 0x40000000; */
static inline uint32_t shift_below(uint32_t x, int n);

#define ONE_OF_4(x, n) ((x) == (n) || (x) == (n) + 1 || (x) == (n) + 2 || (x) == (n) + 3)
#define ONE_OF_16(x, n) (ONE_OF_4(x, n) || ONE_OF_4(x, (n) + 4) || ONE_OF_4(x, (n) + 8) || ONE_OF_4(x, (n) + 12))

/*@ requires x > 0;
    requires \valid(zeros);
    assigns \result, *zeros \from x;
    ensures 0x8000 <= \result <= 0x10000;
    ensures \initialized(zeros);
    ensures x < 0x10000 || *zeros <= 15;
    ensures ONE_OF_16(*zeros, 0) || ONE_OF_16(*zeros, 16); */
static inline uint32_t invert(uint32_t x, unsigned *zeros);

/*@ requires \valid_read(light);
    requires distance < 0x10000;
    requires -15 <= exponent <= 67;
    assigns \result \from *light, inverse_w, distance, exponent;
    ensures \result <= 0x8000; */
static inline uint32_t attenuate(const glint_prepared_light *light, uint32_t inverse_w, uint32_t distance,
                                 int exponent);

/* Any attenuation. */
PROOF(prepare_point) {
    glint_view view;
    glint_light light;
    glint_prepared_light prepared;
    light.linear = ANY_INT;
    light.quadratic = ANY_INT;
    prepare_point(&light, &prepared, &view);
}

/*
 * Any position, any camera, the nearest w by its bits. @contract glint_bits64 glint_reduce find_mantissas
 * @narrowing a mantissa is shifted by as many bits as it has above 31
 */
PROOF(glint_point_place) {
    glint_view view;
    glint_light light;
    glint_prepared_light prepared;
    any_view(&view);
    light.vector = (glint_vector){ANY_INT, ANY_INT, ANY_INT};
    FOR_PARTS(bits, 13, 58) {
        const int64_t least = (int64_t)1 << (bits - 1);
        view.nearest = ANY_LONG(least, bits < 58 ? 2 * least - 1 : least);
        prepared.point.linear_shift = ANY(17 - 31, 17);
        prepared.point.quadratic_shift = ANY(34 - 31, 34);
        glint_point_place(&light, &prepared, &view);
    }
    /*@ assert -16 <= prepared.point.shift <= 122; */
    /*@ assert -58 <= prepared.point.linear_shift <= 63 && -85 <= prepared.point.quadratic_shift <= 126; */
}

/* Any x below 2^31, by its bits, and any shift. */
PROOF(shift_below) {
    FOR_PARTS(bits, 0, 31) {
        shift_below(ANY_OF_BITS(bits), ANY(-115, -1));
        FOR_PARTS(n, 0, 31) {
            shift_below(ANY_OF_BITS(bits), n);
        }
        shift_below(ANY_OF_BITS(bits), ANY(32, 322));
    }
}

/* Any x but 0, by its bits. @unreached 2 leading zeros of 0, and division by a table, which `setup` tests whole */
PROOF(invert) {
    unsigned zeros;
    FOR_PARTS(bits, 1, 32) {
        invert(ANY_OF_BITS(bits), &zeros);
    }
}

static int64_t any_long_of(int bits, int exactly, int negative) {
    const int64_t least = exactly ? (int64_t)1 << bits >> 1 : 0;
    const int64_t magnitude = ANY_LONG(least, ((int64_t)1 << bits) - 1);
    return negative ? -1 - magnitude : magnitude;
}

/*
 * Any numbers of up to 59 bits, by the bits of the first, the largest, and by signs, over any of 31 bits.
 * @contract glint_bits64
 */
PROOF(find_mantissas) {
    FOR_PARTS(bits, 0, 59) {
        FOR_PARTS(signs, 0, 7) {
            int64_t scaled[3];
            int32_t mantissa[3];
            for (int c = 0; c < 3; c++)
                scaled[c] = any_long_of((int)bits, c == 0, signs >> c & 1);
            find_mantissas(scaled, ANY(1 << 30, INT32_MAX), mantissa);
        }
    }
}

/* Any light and 1/w, distances of 16 bits. @contract invert shift_below */
PROOF(attenuate) {
    glint_prepared_light light;
    any_placed(&light);
    attenuate(&light, ANY_UNSIGNED(0, INT32_MAX), ANY_UNSIGNED(0, 0xffff), ANY(-15, 67));
}

/* Any depth, lengths of 16 bits or none. @contract invert shift_below */
PROOF(glint_point_closeness) {
    glint_fragments fragments;
    fragments.ray[0][2] = ANY(0, INT32_MAX);
    fragments.length[0] = ANY_UNSIGNED(0, 0xffff);
    fragments.exponent[0] = (int8_t)ANY(-15, 67);
    const uint32_t closeness = glint_point_closeness(&fragments, 0);
    /*@ assert 1 <= closeness <= 0xffff; */
}

/* Any light near or far, any ray of up to 2^30 and any 1/w. */
PROOF(towards_near) {
    glint_prepared_light light;
    glint_fragments fragments;
    any_placed(&light);
    light.point.shift = ANY(32, 122);
    any_fragment(&fragments);
    towards_near(&light, fragments.inverse_w[0], fragments.ray[0]);
}

/* Any light far beyond what is drawn, any ray of up to 2^30 and any 1/w. @contract glint_reduce */
PROOF(towards_far) {
    glint_prepared_light light;
    glint_fragments fragments;
    towards to;
    any_placed(&light);
    light.point.shift = ANY(-16, 31);
    any_fragment(&fragments);
    towards_far(&light, fragments.inverse_w[0], fragments.ray[0], &to);
}

/* Any ray, any leading zeros. */
PROOF(is_at_light) {
    glint_fragments fragments;
    any_fragment(&fragments);
    is_at_light(ANY_UNSIGNED(0, 32), fragments.ray[0]);
}

/* A component of exactly so many bits, as glint_magnitude_bits counts, or fewer. */
static int32_t any_component(int bits, int exactly, int negative) {
    const int32_t magnitude = (int32_t)(exactly ? ANY_OF_BITS(bits) : ANY_UNSIGNED(0, (1u << bits) - 1));
    return negative ? -1 - magnitude : magnitude;
}

/* A vector of so many bits, the first component's; by signs. */
static towards any_towards(int bits, int signs) {
    towards v;
    v.x = any_component(bits, 1, signs & 1);
    v.y = any_component(bits, 0, signs >> 1 & 1);
    v.z = any_component(bits, 0, signs >> 2 & 1);
    v.exponent = ANY(0, 51);
    return v;
}

/*
 * Any vector, by the bits of the first, the largest, and by signs: an OR and a sum tell no places apart.
 * @narrowing a shift to the left, of components that have the room by their leading zeros
 */
PROOF(to_15_bits_of) {
    FOR_PARTS(bits, 0, 31) {
        FOR_PARTS(signs, 0, 7) {
            const towards v = any_towards((int)bits, (int)signs);
            to_15_bits_of(&v, 32 - (unsigned)bits);
        }
    }
}

/*
 * Any vector of 15 bits, any normal.
 * @alarms 2 a product of vectors is no more than that of their lengths, of which a normal's is below 2^15 and the other
 * below 2^15 sqrt(3); suite `point` under UBSan
 */
PROOF(faces_away) {
    glint_fragments fragments;
    const towards v = {ANY(-32768, 32768), ANY(-32768, 32768), ANY(-32768, 32768), 0};
    any_fragment(&fragments);
    faces_away(fragments.normal[0], &v);
}

/*
 * Any vector of 15 bits but 0, by signs.
 * @contract glint_inverse_root
 * @narrowing directions, as in glint_unit
 * @options -eva-subdivide-non-linear 20
 */
PROOF(find_distance) {
    FOR_PARTS(signs, 0, 7) {
        int16_t direction[3];
        const towards v = {signs & 1 ? ANY(-32768, -16384) : ANY(16384, 32768),
                           signs & 2 ? ANY(-32768, 0) : ANY(0, 32768), signs & 4 ? ANY(-32768, 0) : ANY(0, 32768), 0};
        find_distance(&v, direction);
    }
}

/* Any light and fragment. @contract towards_far zeros_of glint_unit to_15_bits_of faces_away find_distance attenuate */
PROOF(glint_point_illuminate) {
    glint_prepared_light light;
    glint_fragments fragments;
    any_placed(&light);
    any_fragment(&fragments);
    glint_point_illuminate(&light, &fragments);
    /*@ assert fragments.strength[0] <= 0x8000; */
}
