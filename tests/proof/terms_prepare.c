/* SPDX-License-Identifier: MIT */
/* What a material makes of a frame's lights. */
#include "proof.h"

#include "../../src/math/numeric.c"
#include "../../src/math/tables.c"
#include "../../src/nodes/terms_prepare.c"
#include "lit.h"

/*
 * Not proven: glint_terms_prepare, glint_terms_measure, find_light_terms, has_surface, is_wanted: once a frame, they
 * call what is proven, and walk a scene's objects, which are checked. Suites `nodes` and `identity` under ASan and
 * UBSan, and fuzzing.
 */

/*@ assigns \result \from p;
    ensures \true; */
uint32_t glint_highlight_slope(glint_q16 p);

static glint_format format;
static glint_scene scene;
static glint_light lights[GLINT_LIGHTS_MAX];
static glint_view view;
static glint_frame frame;
static glint_material material;
static glint_shading shading;
static glint_light_terms terms;

/* Sums of weights, with ambient light, are below 15. */
#define MOST (15 << 12)

/* Any format, with and without gamma, any number of lights that each weigh up to `most`. */
static void any_frame(uint32_t most) {
    for (int c = 0; c < 3; c++)
        format.channel[c] = (uint8_t)ANY(0, 8);
    frame.config.format = &format;
    frame.config.gamma = ANY(0, 1) ? (const uint16_t *)1 : 0;
    frame.scene = &scene;
    frame.view = &view;
    scene.lights = lights;
    scene.light_count = ANY_UNSIGNED(0, GLINT_LIGHTS_MAX);
    any_shading(&shading, &material);
    for (int i = 0; i < GLINT_LIGHTS_MAX; i++) {
        terms.share[i] = ANY(0, 1 << 15);
        for (int c = 0; c < 3; c++) {
            shading.weights[i].diffuse[c] = ANY_UNSIGNED(0, most);
            shading.weights[i].specular[c] = ANY_UNSIGNED(0, most);
            terms.diffuse[i][c] = (uint16_t)ANY(0, UINT16_MAX);
        }
    }
}

/* Any format, with gamma or without, a weight below 15. */
PROOF(in_levels) {
    any_frame(MOST);
    in_levels(&frame.config, ANY_UNSIGNED(0, MOST), ANY(0, 2));
}

/* Any format, weights of up to 16. @unsigned */
PROOF(levels_of) {
    const uint32_t weight[3] = {ANY_UNSIGNED(0, 16u << 12), ANY_UNSIGNED(0, 16u << 12), ANY_UNSIGNED(0, 16u << 12)};
    any_frame(MOST);
    levels_of(&format, weight);
}

/* Any format, with gamma or without; ambient light below 15, up to 8 lights of up to 16. @options -eva-slevel 200 */
PROOF(set_weights) {
    any_frame(16u << 12);
    for (int c = 0; c < 3; c++)
        shading.ambient[c] = ANY_UNSIGNED(0, 15u << 23);
    set_weights(&frame, &shading, &terms);
}

/* Up to 8 lights of any weights, or none. @options -eva-slevel 200 */
PROOF(find_chroma) {
    static uint16_t weight[GLINT_LIGHTS_MAX][3];
    for (int i = 0; i < GLINT_LIGHTS_MAX; i++)
        for (int c = 0; c < 3; c++)
            weight[i][c] = (uint16_t)ANY(0, UINT16_MAX);
    find_chroma(ANY_UNSIGNED(0, 0xff), (const uint16_t(*)[3])weight, terms.chroma, terms.share);
}

/* Any chroma below 15 in sums of any bits, ambient light below 15, or more than half a level below 0. */
PROOF(set_mix) {
    static glint_material material;
    material.flags = (uint8_t)ANY(0, UINT8_MAX);
    for (int c = 0; c < 3; c++) {
        terms.chroma[c] = ANY(0, 15 << 12);
        terms.half[c] = ANY(0, 1 << 26);
        terms.ambient[c] = ANY(-(1 << 26), 15 << 27);
    }
    terms.sum_bits = ANY_UNSIGNED(0, 5);
    set_mix(&material, &terms);
}

/* Up to 8 lights, and ambient light, of up to 16 each. @unsigned @options -eva-slevel 200 */
PROOF(find_total) {
    any_frame(16u << 12);
    find_total(&frame, &shading, ANY(0, 1));
}

/* Any sum. */
PROOF(bits_of) {
    FOR_PARTS(bits, 0, 32) {
        bits_of(ANY_OF_BITS(bits));
    }
}

/* Eight shares, or four of them, of up to 1 each, any chroma below 15, any bits that sums below 15 have. */
PROOF(gather_shares) {
    any_frame(MOST);
    FOR_PARTS(bits, 0, 4) {
        terms.sum_bits = (uint32_t)bits;
        FOR_PARTS(is_sparse, 0, 1) {
            shading.lights = is_sparse ? 0x55 : 0xff;
            for (int i = 0; i < GLINT_LIGHTS_MAX; i++)
                terms.share[i] = ANY(0, 1 << 15);
            for (int c = 0; c < 3; c++)
                terms.chroma[c] = ANY(0, MOST);
            gather_shares(&shading, &terms);
        }
    }
}

/* Highlights of weights that add up to less than 15 in each channel. */
PROOF(find_lobe_levels) {
    any_frame(MOST);
    for (int i = 0; i < GLINT_LIGHTS_MAX; i++)
        terms.specular_levels[i] = ANY_UNSIGNED(0, 45 << 16 >> 3);
    const uint32_t levels = find_lobe_levels(&frame, &shading, &terms);
    /*@ assert levels <= 0x168000; */
}

/*
 * Any exponent from 7 up; highlights of up to 32, by the 32nds of their bits.
 * @contract glint_exp2
 * @unreached 5 logarithms of 0 and of 1, and leading zeros of 0
 */
PROOF(find_lobe_cut) {
    const glint_q16 shininess = ANY(WIDE, INT32_MAX);
    FOR_PARTS(up, 0, 15) {
        FOR_PARTS(i, up ? 32 : 33, 63) {
            const uint32_t least = (uint32_t)i << up;
            find_lobe_cut(ANY_UNSIGNED(least, (((uint32_t)i + 1) << up) - 1), shininess);
        }
    }
    find_lobe_cut(ANY_UNSIGNED(0, FAINT), shininess);
}

/* Any interval, any exponent. @contract glint_power */
PROOF(power_at) {
    power_at(ANY_UNSIGNED(0, GLINT_COSINE_HALF + 1), ANY(0, INT32_MAX));
}

/*
 * Any exponent. @contract glint_power
 * @alarms 1 powers rise with the cosine: of two differences one is no more than 0; `make domains` takes every cosine
 */
PROOF(fill_cosine) {
    fill_cosine(terms.cosine, ANY(0, WIDE));
}

/*@ assigns cosine[0 .. 95] \from exponent;
    ensures \initialized(cosine + (0 .. 95)); */
static void fill_cosine(uint16_t *cosine, int32_t exponent);

/*@ assigns \result \from indirect: levels, indirect: shininess;
    ensures \result <= 0x40000000; */
static uint32_t find_lobe_cut(uint32_t levels, glint_q16 shininess);

/*@ requires \valid_read(frame) && \valid_read(shading) && \valid_read(terms);
    assigns \result \from indirect: *frame, indirect: *shading, indirect: *terms;
    ensures \result <= 0x168000; */
static uint32_t find_lobe_levels(const glint_frame *frame, const glint_shading *shading,
                                 const glint_light_terms *terms);

/* Any exponent, highlights that end anywhere. @contract fill_cosine find_lobe_levels find_lobe_cut glint_square_root
 * glint_highlight_slope */
PROOF(set_lobes) {
    any_frame(MOST);
    shading.shininess = ANY(0, WIDE - 1);
    set_lobes(&frame, &shading, &terms);
    shading.shininess = ANY(WIDE, INT32_MAX);
    set_lobes(&frame, &shading, &terms);
}

/* Up to 8 lights of any kinds that show or not, of lobes of either kind. @options -eva-slevel 100 */
PROOF(place_numbers) {
    static const glint_light_type types[2] = {{0}, {.illuminate = any_illuminate, .has_cone = 1}};
    any_frame(MOST);
    for (int i = 0; i < GLINT_LIGHTS_MAX; i++)
        lights[i].type = &types[ANY(0, 1)];
    FOR_PARTS(channels, 1, 3) {
        terms.channels = (uint32_t)channels;
        terms.lobes = ANY_UNSIGNED(0, 0xff);
        terms.lobe_is_wide = (uint8_t)ANY(0, 1);
        place_numbers(&frame, &shading, &terms);
    }
}
