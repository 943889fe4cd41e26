/* SPDX-License-Identifier: MIT */
/* Point lights. */
#include "proof.h"

#include "../../src/point.c"
#include "bits.h"
#include "ranges.h"

#define MOST (1 << 30)

/* What glint_point_place hands on. */
static void any_placed(glint_prepared_light *light) {
    for (int c = 0; c < 3; c++)
        light->point.mantissa[c] = ANY(-(1 << 29), 1 << 29);
    light->point.shift = ANY(-17, 62);
    light->point.distance_mantissa = ANY(1 << 30, INT32_MAX);
    light->point.distance_shift = ANY(-46, 44);
    light->point.linear = ANY(0, INT32_MAX);
    light->point.quadratic = ANY(0, INT32_MAX);
}

static void any_fragment(glint_fragments *fragments) {
    fragments->count = 1;
    fragments->inverse_w[0] = ANY(0, INT32_MAX);
    for (int c = 0; c < 3; c++)
        fragments->ray[0][c] = ANY(-MOST, MOST);
}

/* Stands on the length of a vector of three components of 15 bits: at most sqrt(3) 2^15; UBSan in the image tests. */
/*@ requires \valid_read(in + (0 .. 2)) && \valid(exponent);
    requires \subset(in[0 .. 2], (-0x40000000 .. 0x3fffffff));
    requires 0 <= *exponent <= 64;
    assigns \result \from in[0 .. 2];
    assigns *exponent \from *exponent, in[0 .. 2];
    ensures -15 <= *exponent <= 81;
    admit ensures \result < 0x10000; */
static uint32_t find_length(const int32_t in[3], int *exponent);

/*@ requires \valid_read(light);
    requires distance < 0x10000;
    requires -15 <= exponent <= 81;
    assigns \result \from *light, inverse_w, distance, exponent;
    ensures \result <= 0x8000; */
static uint32_t attenuate(const glint_prepared_light *light, uint32_t inverse_w, uint32_t distance, int exponent);

/* Any attenuation. */
PROOF(point_prepare) {
    glint_view view;
    glint_light light;
    glint_prepared_light prepared;
    light.linear = ANY_INT;
    light.quadratic = ANY_INT;
    prepare(&light, &prepared, &view);
}

/*
 * Any position, any camera, the nearest w by its bits. @contract glint_bits64 glint_reduce
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
        glint_point_place(&light, &prepared, &view);
    }
    /*@ assert \subset(prepared.point.mantissa[0 .. 2], (-0x20000000 .. 0x20000000)); */
    /*@ assert -17 <= prepared.point.shift <= 62; */
    /*@ assert -46 <= prepared.point.distance_shift <= 44; */
}

/* Any light and 1/w, distances of 16 bits. @contract glint_bits64 */
PROOF(attenuate) {
    glint_prepared_light light;
    any_placed(&light);
    attenuate(&light, ANY_UNSIGNED(0, INT32_MAX), ANY_UNSIGNED(0, 0xffff), ANY(-15, 81));
}

/* Any light, any ray of up to 2^30 and any 1/w. @contract glint_bits64 */
PROOF(find_direction) {
    glint_prepared_light light;
    glint_fragments fragments;
    int64_t towards[3];
    any_placed(&light);
    any_fragment(&fragments);
    find_direction(&light, &fragments, 0, towards);
    is_at_light(towards, fragments.ray[0]);
}

/* A component of exactly so many bits, as glint_magnitude_bits counts, or fewer. */
static int32_t any_component(int bits, int exactly, int negative) {
    const int32_t magnitude = (int32_t)(exactly ? ANY_OF_BITS(bits) : ANY_UNSIGNED(0, (1u << bits) - 1));
    return negative ? -1 - magnitude : magnitude;
}

/*
 * Any vector of 30 bits but 0, by the bits of the first, the largest, and by signs: an OR and a sum tell no places
 * apart.
 * @contract glint_inverse_root
 * @narrowing a shift to the left, of components that have the room by their leading zeros
 * @options -eva-subdivide-non-linear 20
 */
PROOF(find_length_itself) {
    FOR_PARTS(bits, 0, 30) {
        FOR_PARTS(signs, 0, 7) {
            int exponent = ANY(0, 64);
            int32_t v[3];
            for (int c = 0; c < 3; c++)
                v[c] = any_component((int)bits, c == 0, signs >> c & 1);
            if (bits || signs)
                find_length(v, &exponent);
        }
    }
}

/* Any light and fragment. @contract glint_bits64 glint_reduce glint_unit find_length attenuate */
PROOF(glint_point_illuminate) {
    glint_prepared_light light;
    glint_fragments fragments;
    any_placed(&light);
    any_fragment(&fragments);
    glint_point_illuminate(&light, &fragments);
}
