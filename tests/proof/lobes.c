/* SPDX-License-Identifier: MIT */
/* Highlights at nodes. */
#include "proof.h"

#include "../../src/nodes/lobes.c"

#include "../../src/math/tables.c"

/*@ requires \valid_read(cosine + (0 .. 95));
    requires 1 <= x <= 0x7fffffff;
    assigns \result \from cosine[0 .. 95], x;
    ensures \result <= 0x8000; */
static inline uint32_t glint_power_of_cosine(const uint16_t *cosine, uint32_t x);

/* Stands on a value between two nodes, both of which are at most 2^15: `make domains` takes every cosine. */
/*@ requires \valid_read(table);
    requires \valid_read(&table->value[0 .. 128]);
    assigns \result \from *table, u;
    admit ensures \result <= 0x8000; */
static inline uint32_t glint_power_at(const glint_power_table *table, uint32_t u);

static glint_shading shading;
static glint_light_terms light;
static glint_node node;

/* Any table of powers over every window, any squared sine. */
PROOF(glint_power_at) {
    for (int i = 0; i <= GLINT_POWER_INTERVALS; i++)
        shading.power.value[i] = (uint16_t)ANY(0, 1 << 15);
    FOR_PARTS(shift, GLINT_POWER_FRACTION_BITS, 30 - GLINT_POWER_TABLE_BITS) {
        shading.power.index_shift = (uint32_t)shift;
        shading.power.window = 1u << (shift + GLINT_POWER_TABLE_BITS);
        glint_power_at(&shading.power, ANY_UNSIGNED(0, UINT_MAX));
    }
}

/* A highlight wide or narrow, of any shift; deviations of 14 bits and a sign, strengths of up to 1. */
static void any_lobes(void) {
    shading.terms = &light;
    light.lobe_is_wide = (uint8_t)ANY(0, 1);
    light.lobe_shift = ANY_UNSIGNED(0, 12);
    for (int i = 0; i < GLINT_COSINE_VALUES; i++)
        light.cosine[i] = (uint16_t)ANY(0, 1 << 15);
    for (int i = 0; i < GLINT_LIGHTS_MAX; i++) {
        for (int kind = 0; kind < GLINT_NUMBERS; kind++)
            node.number[i][kind] = (int16_t)ANY(-(1 << 14), 1 << 14);
        node.number[i][GLINT_STRENGTH] = (int16_t)ANY(0, 1 << 14);
    }
}

/* Any numbers. @contract glint_power_of_cosine glint_power_at */
PROOF(shine_of) {
    any_lobes();
    shine_of(&shading, node.number[0]);
}

/*@ requires \valid_read(shading);
    assigns \result \from indirect: *shading, indirect: *number;
    ensures 0 <= \result <= 0x8000; */
static int32_t shine_of(const glint_shading *shading, const int16_t *number);

/* Each light alone, of a weight below 15. @contract shine_of */
PROOF(glint_node_shine) {
    any_lobes();
    for (int i = 0; i < GLINT_LIGHTS_MAX; i++)
        for (int c = 0; c < 3; c++)
            light.specular[i][c] = (uint16_t)ANY(0, 15 << 12);
    FOR_PARTS(bits, 0, 4) {
        light.sum_bits = (unsigned)bits;
        FOR_PARTS(i, 0, GLINT_LIGHTS_MAX - 1) {
            glint_node_shine(&shading, 1u << i, &node);
        }
    }
}
