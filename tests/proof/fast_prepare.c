/* SPDX-License-Identifier: MIT */
/* Fast lighting, once a frame. */
#include "proof.h"

#include "../../src/fast/fast_prepare.c"
#include "../../src/fast/fast_tables.c"
#include "../../src/frame/arena.c"
#include "lit.h"

/*@ assigns \result \from indirect: *shading;
    ensures \result <= 0x40000000; */
static uint32_t find_highlight_end(const glint_shading *shading);

/*@ requires \valid_read(weight + (0 .. 2));
    assigns \result \from indirect: weight[0 .. 2];
    ensures 1 <= \result <= 63 * 0x10000; */
static uint32_t weight_in_levels(const uint32_t weight[3]);

static glint_material material;
static glint_shading shading;
static glint_fast_terms fast;

/* A material that fast lighting takes, and its error budget. */
/* Half a level included or not. */
static void any_words(void) {
    fast.is_rounded = (uint8_t)ANY(0, 1);
    fast.ambient_word = ANY_UNSIGNED(0, UINT_MAX);
}

static void any_served(void) {
    any_shading(&shading, &material);
    material.shininess = ANY(2 * GLINT_ONE, INT32_MAX);
    shading.spare = ANY_UNSIGNED(0, 16u << 12);
    shading.fast = &fast;
    fast.local_viewer = (uint8_t)ANY(0, 1);
    any_unit(fast.half_vector);
    fast.specular_end = ANY_UNSIGNED(0, 1024) << 15;
    any_words();
}

/* Any exponent. @contract glint_square_root */
PROOF(glint_highlight_slope) {
    glint_highlight_slope(ANY(0, INT32_MAX));
}

/*
 * Any weights, shininess from 2 up, any error budget. @contract glint_log2 glint_exp2
 * @unreached 1 leading zeros of 0
 */
PROOF(find_highlight_end) {
    any_served();
    find_highlight_end(&shading);
}

/* Any highlight, and any place where it ends. @unreached 1 leading zeros of 0 */
PROOF(specular_entries) {
    any_served();
    specular_entries(&shading, ANY_UNSIGNED(0, 1u << 30));
}

/*
 * Any highlight, and none. @contract find_highlight_end glint_square_root
 * @alarms 1 a highlight that is cut somewhere has entries: both come from find_highlight_end; the image tests under
 * UBSan
 * @unreached 1 leading zeros of 0
 */
PROOF(prepare_highlight) {
    any_served();
    prepare_highlight(&fast, &shading);
}

/* Any ambient light, half a level included or not. */
PROOF(glint_fast_prepare_words) {
    any_served();
    for (int stores_spread = 0; stores_spread < 2; stores_spread++) {
        const glint_fast stored = {.stores_spread = stores_spread};
        const glint_format format = {.fast = &stored};
        glint_fast_prepare_words(&fast, &format, &shading);
    }
}

/* Any ambient and diffuse light, sum and largest, highlights and none. @unreached 1 leading zeros of 0 */
PROOF(least_lit_of) {
    any_served();
    const int32_t lit = least_lit_of(&shading);
    /*@ assert GLINT_LEAST_LIT <= lit <= INT16_MAX; */
}

/* Any focal length. */
PROOF(prepare_rays) {
    glint_frame frame;
    glint_view view;
    any_view(&view);
    frame.view = &view;
    frame.config.width = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    frame.config.height = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    prepare_rays(&fast, &frame);
}

/* Any light, or none that shows. @unreached 1 leading zeros of 0 */
PROOF(prepare_light) {
    glint_view view;
    any_lights(&view, &far_light);
    any_served();
    prepare_light(&fast, &view, &shading);
}

/* Any weight, by which are 0. */
PROOF(weight_in_levels) {
    FOR_PARTS(zeros, 0, 7) {
        uint32_t weight[3];
        for (int c = 0; c < 3; c++)
            weight[c] = zeros >> c & 1 ? 0 : ANY_UNSIGNED(1, 16u << 12);
        weight_in_levels(weight);
    }
}

/*
 * Any weights, shininess, error budget and focal length. @contract glint_square_root weight_in_levels
 * @unreached 1 leading zeros of 0
 */
PROOF(find_limits) {
    glint_frame frame;
    glint_view view;
    any_view(&view);
    frame.view = &view;
    frame.config.width = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    frame.config.height = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    any_served();
    fast.side = ANY(0, 1 << 17);
    find_limits(&frame, &fast, &shading);
}

/* A table of any power over a window, and the highlight that it was made for, of so many entries. */
static void any_highlight(int shift, uint32_t entries) {
    shading.power.direct = 0;
    shading.power.index_shift = (uint32_t)shift;
    shading.power.window = 1u << (shift + GLINT_POWER_TABLE_BITS);
    for (int i = 0; i <= GLINT_POWER_INTERVALS; i++)
        shading.power.value[i] = (uint16_t)ANY(0, 1 << 15);
    fast.sine_square_end = ANY_UNSIGNED(0, 1u << 30);
    fast.specular_end = entries << 15;
}

/* What specular_entries returns. */
#define ENTRIES(level) ((level) ? 128u << (level) : 0)

/*
 * Any N.L that a plane holds, any squared deviation; tables of any window.
 * @unreached 1 a table without nodes
 * @narrowing levels change modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 12
 */
PROOF(glint_fast_word) {
    any_served();
    FOR_PARTS(shift, GLINT_POWER_FRACTION_BITS, 30 - GLINT_POWER_TABLE_BITS) {
        FOR_PARTS(level, 0, 3) {
            any_highlight((int)shift, ENTRIES(level));
            glint_fast_word(&shading, ANY_INT, ANY_UNSIGNED(0, UINT_MAX));
        }
    }
}

/*
 * Any material, in an arena of the bytes that the largest tables take and no more; with too little room too.
 * @unreached 6 a refusal of glint_take, which is asked for no more than there is, a table without nodes, and words that
 * a sum by fours leaves
 * @narrowing levels change modulo 2^32: right wherever the true value fits
 * @options -eva-slevel 0 -eva-min-loop-unroll 4 -eva-auto-loop-unroll 16
 */
PROOF(glint_fast_make_tables) {
    static uint32_t room[GLINT_DIFFUSE_ENTRIES * 3 / 2 + 1024];
    static glint_frame frame;
    static const glint_fast stored[2] = {{.stores_spread = 0}, {.stores_spread = 1}};
    static glint_format format;
    glint_memory *const memory = &frame.memory;
    any_served();
    frame.config.format = &format;
    FOR_PARTS(level, 0, 7) {
        format.fast = &stored[level >> 2];
        fast.is_rounded = level < 4;
        any_highlight(GLINT_POWER_FRACTION_BITS, ENTRIES(level & 3));
        memory->base = (uint8_t *)room;
        memory->low = 0;
        memory->high = 2 * (sizeof room - (1024 - ENTRIES(level & 3)) * sizeof *room);
        fast.diffuse = 0;
        glint_fast_make_tables(&frame, &fast, &shading);
        memory->low = 0;
        glint_fast_make_tables(&frame, &fast, &shading); /* where they are */
        memory->low = 0;
        memory->high -= 8;
        glint_fast_make_tables(&frame, &fast, &shading);
    }
}
