/* SPDX-License-Identifier: MIT */
/* How far polynomials may be off. */
#include "proof.h"

#include "../../src/math/tables.c"
#include "../../src/nodes/bound.c"
#include "../../src/nodes/reach.c"
#include "../../src/nodes/sort.c"
#include "lit.h"

/*@ requires 0x10000000 <= c <= 0xC0000000;
    assigns \result \from c;
    ensures 18892 <= \result <= 65525; */
static inline int32_t glint_inverse_root(uint32_t c);

/*@ assigns \result \from square;
    ensures \result <= 0x40000; */
uint32_t glint_root_above(uint32_t square);

static glint_frame frame;
static glint_view view;
static glint_shading shading;
static glint_material material;
static glint_model model;
static glint_light_terms terms;
static glint_region region;

/* Most levels, Q8, that a weight of 15 makes. Of lights of three colours there may be three times as many. */
#define LEVELS_Q8 (15u << 16)

/* The nearness of a light right there. */
#define NEAREST (384 << 7 | 127)

static const glint_light_type types[3] = {
    {0}, {.illuminate = any_illuminate}, {.illuminate = any_illuminate, .has_cone = 1}};

/* Any material and lights. */
static void any_material(void) {
    any_shading(&shading, &material);
    any_view(&view);
    frame.view = &view;
    material.model = &model;
    shading.shininess = ANY(0, INT32_MAX);
    shading.terms = &terms;
    model.lobe = (uint8_t)ANY(GLINT_LOBE_OTHER, GLINT_LOBE_MIRROR);
    terms.lobe_is_wide = (uint8_t)ANY(0, 1);
    terms.lobe_has_strip = (uint8_t)ANY(0, 1);
    terms.lobes = ANY_UNSIGNED(0, 0xff);
    terms.placed = ANY_UNSIGNED(0, 0xff);
    terms.cones = ANY_UNSIGNED(0, 0xff);
    terms.lobe_cut = ANY(0, 4098);
    terms.lobe_diagonal = ANY(0, 5800);
    terms.lobe_shift = ANY_UNSIGNED(0, 12);
    terms.ambient_levels = ANY_UNSIGNED(0, LEVELS_Q8);
    terms.slope = ANY_UNSIGNED(0, 1u << 15);
    terms.crest = ANY(0, 1 << 16);
    terms.spread = ANY_UNSIGNED(0, 3245);
    terms.limit = ANY_UNSIGNED(0, 204);
    terms.most_of_sums = ANY_UNSIGNED(0, 112);
    terms.most_of_one = ANY_UNSIGNED(0, 224);
    for (int i = 0; i < GLINT_LIGHTS_MAX; i++) {
        terms.diffuse_levels[i] = ANY_UNSIGNED(0, LEVELS_Q8);
        terms.specular_levels[i] = ANY_UNSIGNED(0, LEVELS_Q8);
        view.lights[i].type = &types[ANY(0, 2)];
        view.lights[i].spot.slope = ANY(0, 1 << 30);
        view.lights[i].spot.shift = ANY_UNSIGNED(0, 15);
    }
}

/* What nodes leave of a region. */
static void any_region(void) {
    region.turn = ANY_UNSIGNED(0, 1 << 16);
    region.reach = ANY_UNSIGNED(0, 1 << 14);
    region.slant = ANY_UNSIGNED(0, 30336);
    region.near = ANY_UNSIGNED(0, 1 << 13);
    for (int i = 0; i < GLINT_LIGHTS_MAX; i++) {
        region.nearness[i] = (uint16_t)ANY(0, NEAREST);
        region.strength[i] = (uint16_t)ANY(0, 1 << 14);
        region.near_of[i] = (uint16_t)ANY(0, 1 << 13);
        region.side_least[i] = (int16_t)ANY(-(1 << 14), 1 << 14);
        region.side_most[i] = (int16_t)ANY(-(1 << 14), 1 << 14);
        region.axis_of[i] = (uint16_t)ANY(0, UINT16_MAX);
    }
    region.colour = ANY_UNSIGNED(0, 1 << 14);
    region.levels = ANY_UNSIGNED(0, 3 * LEVELS_Q8 >> 4);
    region.lit = ANY_UNSIGNED(0, 0xff);
    region.dark = ANY_UNSIGNED(0, 0xff);
    region.outside = ANY_UNSIGNED(0, 0xffff);
    region.far = ANY_UNSIGNED(0, 0xff);
    region.unfit = ANY_UNSIGNED(0, 0xff);
    region.steep = ANY_UNSIGNED(0, 0xff);
    region.left = ANY_UNSIGNED(0, 0xff);
    region.axis = ANY_UNSIGNED(0, UINT32_MAX >> 1);
    region.has_edge = ANY(0, 1);
    region.folds = ANY(0, 1);
    region.held = ANY_UNSIGNED(0, 0xff);
    region.sides = ANY_UNSIGNED(0, 0xff);
    region.cones = ANY_UNSIGNED(0, 0xff);
    region.lobes = ANY_UNSIGNED(0, 0xff);
    region.summed = ANY_UNSIGNED(0, 0xff);
    region.shine = ANY_UNSIGNED(0, 408);
    region.slope = ANY_UNSIGNED(0, 1u << 15);
}

/* Any square, by its bits. @contract glint_inverse_root @unsigned @unreached 1 leading zeros of 0 */
PROOF(glint_root_above) {
    FOR_PARTS(bits, 0, 32) {
        glint_root_above(ANY_OF_BITS(bits));
    }
}

/* Unit vectors of any components. */
PROOF(glint_square_apart) {
    int16_t a[3], b[3];
    any_unit(a);
    any_unit(b);
    glint_square_apart(a, b);
}

/* Sides of up to 2^25. */
PROOF(glint_hypotenuse) {
    glint_hypotenuse(ANY_UNSIGNED(0, 1 << 25), ANY_UNSIGNED(0, 1 << 25));
}

/* Any focal length, regions of up to 2046 pixels across and down; any 1/w and what it changes by, by their bits.
 * @unsigned @unreached 1 a number of no bits */
PROOF(glint_region_measure) {
    glint_w_range w;
    FOR_PARTS(least, 0, 16) {
        FOR_PARTS(change, 1, 17) {
            w.least = ANY_OF_BITS(least);
            w.change = change < 17 ? ANY_OF_BITS(change) : 0x10000;
            glint_region_measure(ANY_UNSIGNED(1 << 10, 1u << 31), ANY_UNSIGNED(0, 1 << 16), &w, &region);
        }
    }
}

/* Any closeness, by its bits, and half vector. @unsigned */
PROOF(glint_nearness_of) {
    FOR_PARTS(bits, 0, 16) {
        const uint32_t nearness = glint_nearness_of(ANY_OF_BITS(bits), ANY_UNSIGNED(0, INT16_MAX));
        /*@ assert nearness <= 49279; */
    }
}

/* Any nearness, by its closeness. @unsigned */
PROOF(glint_closeness_of) {
    FOR_PARTS(code, 0, 384) {
        const uint32_t closeness = glint_closeness_of(ANY_UNSIGNED((uint32_t)code << 7, (uint32_t)code << 7 | 127));
        /*@ assert closeness <= 65536; */
    }
}

/* Stands on its driver. */
/*@ assigns \result \from nearness;
    ensures \result <= 65536; */
static inline uint32_t glint_closeness_of(uint32_t nearness);

/* Any lights, any nearness. @contract glint_closeness_of @unsigned */
PROOF(glint_region_place) {
    any_region();
    glint_region_place(ANY_UNSIGNED(0, 0xff), ANY_UNSIGNED(0, 0xff), &region);
}

/* Any |L + V|^2 / 2, all that it reads of a nearness, by its bits. @contract glint_inverse_root @unsigned
 * @unreached 1 leading zeros of 0 */
PROOF(turn_of_axis) {
    any_material();
    any_region();
    FOR_PARTS(bits, 0, 7) {
        region.nearness[0] = (uint16_t)ANY_OF_BITS(bits);
        const uint32_t axis = turn_of_axis(&frame, &region, 0);
        /*@ assert axis <= 65535; */
    }
}

/* Stands on its driver. */
/*@ assigns \result \from *frame, *region, l;
    ensures \result <= 65535; */
static inline uint32_t turn_of_axis(const glint_frame *frame, const glint_region *region, uint32_t l);

/* Any lights, any nearness. @contract glint_closeness_of turn_of_axis @unsigned
 * @options -eva-slevel 20 */
PROOF(glint_region_sort) {
    any_material();
    any_region();
    glint_region_sort(&frame, &shading, &region);
}

/* Any region. @contract glint_root_above @unsigned @options -eva-slevel 300 */
PROOF(glint_region_fits) {
    any_material();
    any_region();
    glint_region_fits(&shading, ANY(0, 1), &region);
}

/* A region that polynomials may fit: its turn and its place are at most 2 together, by eighths; mirrored lobes turn
 * twice as far. */
static void any_fitting(int eighth) {
    const uint32_t turn = (uint32_t)eighth * GLINT_WIDEST / 8, rest = GLINT_WIDEST - turn;
    any_material();
    any_region();
    region.turn = ANY_UNSIGNED(turn, turn + GLINT_WIDEST / 8);
    region.near = ANY_UNSIGNED(0, TOO_NEAR);
    region.slant = ANY_UNSIGNED(0, STEEPEST);
    region.axis = ANY_UNSIGNED(0, rest);
    region.place = ANY_UNSIGNED(0, rest);
    for (int i = 0; i < GLINT_LIGHTS_MAX; i++) {
        region.near_of[i] = (uint16_t)ANY(0, TOO_NEAR);
        region.place_of[i] = (uint16_t)ANY(0, 7 << 11);
        region.axis_of[i] = (uint16_t)ANY(0, (int)rest);
    }
    region.of_colour = ANY_UNSIGNED(0, 1 << 23);
    model.lobe = (uint8_t)ANY(GLINT_LOBE_OTHER, eighth < 4 ? GLINT_LOBE_MIRROR : GLINT_LOBE_HALF_VECTOR);
}

/*
 * Any region that polynomials may fit, by eighths of its turn.
 * @unsigned
 * @alarms 2 a larger number has the larger square; suite `nodes`
 * @unreached 14 what quadratics are off by
 * @options -eva-slevel 300
 */
PROOF(glint_plane_error) {
    FOR_PARTS(eighth, 0, 7) {
        any_fitting((int)eighth);
        glint_plane_error(&shading, ANY(0, 1), &region);
    }
}

/* Any region that polynomials may fit, by eighths of its turn. @unsigned @options -eva-slevel 300 */
PROOF(glint_region_sum_lobes) {
    FOR_PARTS(eighth, 0, 7) {
        any_fitting((int)eighth);
        glint_region_sum_lobes(&shading, ANY(0, 1), &region);
    }
}

/* Any region. */
PROOF(glint_region_part_lobes) {
    any_region();
    glint_region_part_lobes(&region);
}

/*
 * Any region that polynomials may fit, by eighths of its turn.
 * @unsigned
 * @unreached 4 what planes are off by, and slopes times more than highlights turn by here
 * @options -eva-slevel 300
 */
PROOF(glint_region_bound) {
    FOR_PARTS(eighth, 0, 7) {
        any_fitting((int)eighth);
        glint_region_bound(&frame, &shading, &region);
    }
}

/*
 * The same over length.
 * @unsigned
 * @unreached 4 what planes are off by, and slopes times more than highlights turn by here
 * @options -eva-slevel 300
 */
PROOF(glint_error_over_length) {
    FOR_PARTS(eighth, 0, 7) {
        any_fitting((int)eighth);
        if (glint_region_bound(&frame, &shading, &region))
            glint_error_over_length(&frame, &shading, &region);
    }
}

/* And between nodes. @unsigned @options -eva-slevel 300 */
PROOF(glint_error_between) {
    FOR_PARTS(eighth, 0, 7) {
        any_fitting((int)eighth);
        glint_error_between(&shading, &region);
    }
}

/* Any turn of a region and its axes. @unsigned */
PROOF(glint_lobe_bulge) {
    any_material();
    any_region();
    const int32_t bulge = glint_lobe_bulge(&shading, &region, ANY_UNSIGNED(0, GLINT_LIGHTS_MAX - 1));
    /*@ assert 0 <= bulge <= 0x20000000; */
}

/* Any bulge. */
PROOF(glint_find_lobe_bounds) {
    any_material();
    glint_find_lobe_bounds(&shading, ANY(0, 0x20000000));
}

/* Deviations of 15 bits and a sign. */
PROOF(glint_lobe_range_take) {
    glint_lobe_range range = glint_lobe_range_of(ANY_SHORT, ANY_SHORT);
    glint_lobe_range_take(&range, ANY_SHORT, ANY_SHORT);
}

static void any_range(glint_interval *range) {
    range->least = ANY(-0x10000, 0xffff);
    range->most = ANY(-0x10000, 0xffff);
}

/*@ assigns \result \from *table, u;
    ensures \result <= 0x8000; */
static inline uint32_t glint_power_at(const glint_power_table *table, uint32_t u);

/* Any deviation where a highlight shows. @contract glint_power_at */
PROOF(slope_from) {
    any_material();
    shading.shininess = ANY(7 << 16, INT32_MAX);
    FOR_PARTS(part, 0, 63) {
        slope_from(&shading, ANY((int)part << 8, ((int)part << 8) + 0xff));
    }
}

/*@ requires 0 <= r < 0x4000;
    assigns \result \from *shading, r;
    ensures \result <= 0x8000; */
static uint32_t slope_from(const glint_shading *shading, int32_t r);

/* Any light, any deviations at nodes. @contract slope_from */
PROOF(glint_region_add_lobe) {
    glint_lobe_bounds of;
    glint_lobe_range range;
    any_material();
    any_region();
    of.is_wide = (uint8_t)ANY(0, 1);
    of.bulge = ANY(0, 0x20000000);
    of.straight = of.diagonal = ANY(0, 0x30002000);
    of.below = of.edge = ANY_INT;
    any_range(&range.x);
    any_range(&range.y);
    any_range(&range.rising);
    any_range(&range.falling);
    FOR_PARTS(light, 0, GLINT_LIGHTS_MAX - 1) {
        glint_region_add_lobe(&shading, &of, (uint32_t)light, &range, &region);
    }
}

static void any_loop(const glint_spans *spans, const glint_quadratic channels[3], int is_curved) {
    (void)spans;
    (void)channels;
    (void)is_curved;
}

/* Any region, of any lights. @options -eva-slevel 300 */
PROOF(glint_terms_name) {
    glint_draw draw;
    glint_terms to;
    glint_format format;
    static const int16_t colours[1][3];
    static const uint16_t curve[3][GLINT_GAMMA_ENTRIES];
    any_material();
    any_region();
    format.draw_channels = ANY(0, 1) ? any_loop : 0;
    frame.config.format = &format;
    frame.config.gamma = ANY(0, 1) ? curve : 0;
    draw.shading = &shading;
    draw.extra = ANY(0, 1) ? colours : 0;
    terms.channels = ANY(0, 1) ? 1 : 3;
    glint_terms_name(&frame, &draw, &region, ANY(0, 2), &to);
}
