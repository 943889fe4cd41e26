/* SPDX-License-Identifier: MIT */
/* Light at nodes. */
#include "proof.h"

#include "../../src/math/tables.c"
#include "../../src/nodes/nodes.c"
#include "lit.h"

/*
 * Not proven: glint_nodes_light: it walks nodes and lights, and calls what is proven. Suite `nodes` under ASan and
 * UBSan, and fuzzing.
 */

/*@ requires \valid_read(light) && \valid(fragments);
    requires fragments->count == 1;
    assigns fragments->light[0][0 .. 2], fragments->strength[0], fragments->length[0], fragments->exponent[0]
        \from indirect: *light, indirect: *fragments;
    ensures \initialized(&fragments->light[0][0 .. 2]) && \initialized(&fragments->strength[0]);
    ensures \initialized(&fragments->length[0]);
    ensures fragments->length[0] == 0 || \initialized(&fragments->exponent[0]);
    ensures \subset(fragments->light[0][0 .. 2], (-32767 .. 32767));
    ensures fragments->strength[0] <= 0x8000; */
void glint_point_illuminate(const glint_prepared_light *light, glint_fragments *fragments);

/*@ requires \valid_read(fragments) && i == 0;
    assigns \result \from indirect: *fragments, i;
    ensures 1 <= \result <= 0xffff; */
uint32_t glint_point_closeness(const glint_fragments *fragments, uint32_t i);

/*@ requires 0 <= z <= 32767;
    assigns \result \from z;
    ensures 0x3fff <= \result <= 0x8003; */
static inline int32_t glint_inverse_of_one_and(int32_t z);

static glint_view view;
static glint_frame frame;
static glint_material material;
static glint_model model;
static glint_shading shading;
static glint_light_terms terms;
static glint_fragments at;
static glint_node node;

/* Any point of the guard band. */
PROOF(glint_find_ray) {
    int32_t ray[3];
    frame.view = &view;
    any_view(&view);
    frame.config.width = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    frame.config.height = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    glint_find_ray(&frame, ANY(2 * INT16_MIN, 2 * INT16_MAX), ANY(2 * INT16_MIN, 2 * INT16_MAX), ray);
}

/* Any light and view vector that is not behind. @contract glint_dot glint_unit */
PROOF(find_half) {
    int16_t light[3], view_vector[3], axis[3];
    uint32_t half = ANY_UNSIGNED(0, INT16_MAX);
    any_unit(light);
    any_unit(view_vector);
    view_vector[2] = (int16_t)ANY(0, 32767);
    find_half(light, view_vector, &half, axis);
}

/* z from 0 to 1, by the intervals of the table. */
PROOF(glint_inverse_of_one_and) {
    FOR_PARTS(i, 0, 63) {
        glint_inverse_of_one_and(ANY((int)i << 9, ((int)i << 9) + 511));
    }
}

/* A half vector towards the eye. */
static void any_half_vector(int16_t h[3]) {
    any_unit(h);
    h[2] = (int16_t)ANY(0, GLINT_UNIT);
}

/*
 * Any normal, any half vector that is not behind, any shift.
 * @contract glint_dot glint_inverse_of_one_and
 * @alarms 12 a deviation is a part of a unit vector, at most 1, and N.H + nz <= sqrt(2 + 2 hz): the image tests under
 * UBSan, and suite `nodes`
 */
PROOF(find_lobe_deviation) {
    int16_t n[3], h[3];
    any_unit(n);
    any_half_vector(h);
    FOR_PARTS(shift, 0, 12) {
        find_lobe_deviation(n, h, (unsigned)shift, node.number[0]);
    }
}

/* Any product of two unit vectors. */
PROOF(signed_cosine) {
    signed_cosine(ANY(-COSINE_MOST, COSINE_MOST));
}

/* Any cone, any direction. */
static void any_source(glint_prepared_light *source) {
    any_unit(source->direction);
    any_unit(source->half_vector);
    source->spot.cosine_inner = ANY(-CONE_MOST, CONE_MOST);
    source->spot.cosine_outer = ANY(-CONE_MOST, CONE_MOST);
    source->spot.slope = ANY(0, 1 << 30);
    source->spot.shift = ANY_UNSIGNED(0, 15);
}

/* Any cone, any direction, of any light. @contract glint_cone_cosine */
PROOF(find_cone) {
    glint_prepared_light source;
    int16_t light[3];
    int is_lit = ANY(0, 1);
    any_source(&source);
    any_unit(light);
    node.outside = (uint16_t)ANY(0, UINT16_MAX);
    FOR_PARTS(i, 0, GLINT_LIGHTS_MAX - 1) {
        find_cone(&source, (uint32_t)i, light, &node, &is_lit);
    }
}

/* Stands on what it returns where H points away. Suite `nodes`. */
/*@ requires \valid_read(light + (0 .. 2)) && \valid_read(view + (0 .. 2));
    requires \valid(half) && \valid(axis + (0 .. 2));
    requires view[2] >= 0;
    assigns \result, axis[0 .. 2], *half \from light[0 .. 2], view[0 .. 2], *half;
    ensures \result == 0 || \result == 1;
    ensures *half <= 32767;
    admit ensures \subset(axis[0 .. 2], (-32767 .. 32767));
    admit ensures \result == 0 || axis[2] >= 0; */
static int find_half(const int16_t *light, const int16_t *view, uint32_t *half, int16_t *axis);

/* A material of any lobes, and any node of one light. */
static void any_material(void) {
    any_shading(&shading, &material);
    any_view(&view);
    frame.view = &view;
    material.model = &model;
    shading.terms = &terms;
    terms.lobe_is_wide = (uint8_t)ANY(0, 1);
    terms.lobe_shift = ANY_UNSIGNED(0, 12);
    any_fragments(&at, 0);
    at.count = 1;
    for (int i = 0; i < GLINT_LIGHTS_MAX; i++)
        terms.diffuse_levels[i] = ANY_UNSIGNED(0, 16u << 16);
}

/*
 * One light at a point, of each kind: directional, point, spot; with any highlight.
 * @contract glint_dot glint_point_illuminate glint_point_closeness light_lobe
 * @narrowing a nearness has 16 bits and no sign
 */
PROOF(light_nodes) {
    static const glint_light_type types[3] = {
        {0}, {.illuminate = any_illuminate}, {.illuminate = any_illuminate, .has_cone = 1}};
    glint_node *const nodes[1] = {&node};
    any_material();
    model.lobe = (uint8_t)ANY(GLINT_LOBE_NONE, GLINT_LOBE_MIRROR);
    FOR_PARTS(i, 0, GLINT_LIGHTS_MAX - 1) {
        FOR_PARTS(type, 0, 2) {
            any_source(&view.lights[i]);
            view.lights[i].type = &types[type];
            node.outside = (uint16_t)ANY(0, UINT16_MAX);
            node.levels = ANY_UNSIGNED(0, 8u << 13);
            light_nodes(&frame, &shading, (uint32_t)i, &at, ANY_UNSIGNED(0, 0xff), ANY(0, 1), nodes);
        }
    }
}

/*@ requires \valid_read(shading) && \valid_read(source) && \valid_read(at) && i < 8 && n == 0;
    requires \valid_read(light + (0 .. 2)) && \valid(node);
    assigns \result, node->number[i][GLINT_LOBE_X .. GLINT_LOBE_Y], node->unfit, node->far
        \from indirect: *shading, indirect: *source, is_fixed, indirect: *at, n, light[0 .. 2], dot, node->unfit,
        node->far;
    ensures \result <= 32767; */
static uint32_t light_lobe(const glint_shading *shading, uint32_t i, const glint_prepared_light *source, int is_fixed,
                           const glint_fragments *at, uint32_t n, const int16_t *light, int32_t dot, glint_node *node);

/*@ requires \valid_read(n + (0 .. 2)) && \valid_read(h + (0 .. 2)) && \valid(number + (0 .. 4));
    requires 0 <= h[2] <= 32767 && shift <= 12;
    assigns \result, number[3 .. 4] \from n[0 .. 2], h[0 .. 2], shift;
    ensures \result == 0 || \result == 1;
    ensures \subset(number[3 .. 4], (-0x3fff .. 0x3fff)); */
static int find_lobe_deviation(const int16_t *n, const int16_t *h, unsigned shift, int16_t *number);

/*
 * Any light's highlight, of the half vector or of mirrored light, wide or narrow.
 * @contract glint_dot find_half find_lobe_deviation glint_twice_over_square
 * @alarms 1 an axis that points away is none; suite `nodes` under UBSan
 * @narrowing a mirrored vector is found modulo 2^32, and is below 1
 */
PROOF(light_lobe) {
    glint_prepared_light source;
    int16_t light[3];
    any_source(&source);
    any_unit(light);
    FOR_PARTS(lobe, GLINT_LOBE_NONE, GLINT_LOBE_MIRROR) {
        any_material();
        model.lobe = (uint8_t)lobe;
        at.view[0][2] = (int16_t)ANY(0, 32767);
        FOR_PARTS(i, 0, GLINT_LIGHTS_MAX - 1) {
            light_lobe(&shading, (uint32_t)i, &source, ANY(0, 1), &at, 0, light, ANY(-COSINE_MOST, COSINE_MOST), &node);
        }
    }
}

/* Numbers of up to 1, each light alone, of a weight below 15; of one chroma: eight lights of any share. */
PROOF(glint_node_sum) {
    for (int i = 0; i < GLINT_LIGHTS_MAX; i++) {
        node.number[i][GLINT_SIDE] = (int16_t)ANY(-16388, 16388);
        terms.share[i] = ANY(0, 1 << 15);
        for (int c = 0; c < 3; c++)
            terms.diffuse[i][c] = (uint16_t)ANY(0, 15 << 12);
    }
    FOR_PARTS(bits, 0, 4) {
        terms.sum_bits = (unsigned)bits;
        terms.channels = 1;
        glint_node_sum(&terms, 0xff, &node);
        terms.channels = 3;
        FOR_PARTS(i, 0, GLINT_LIGHTS_MAX - 1) {
            glint_node_sum(&terms, 1u << i, &node);
        }
    }
}

/* Any lights. */
PROOF(glint_node_leave) {
    FOR_PARTS(away, 0, 0xff) {
        glint_node_leave(&node, (uint32_t)away);
    }
}
