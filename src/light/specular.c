/* SPDX-License-Identifier: MIT */
/* The specular power at a corner, from the power table or, for the widest lobes, from its octaves. */
#include "model.h"

/* x^p, Q15, for p < 2, x Q31 from 1 to 2^31; off by at most 3 steps. */
static uint32_t power_by_octaves(const glint_power_table *table, uint32_t x) {
    const unsigned zeros = glint_leading_zeros(x);
    if (!zeros)
        return 1u << 15;
    const uint32_t mantissa = (x << zeros) & 0x7fffffff; /* above 1/2 */
    const uint16_t *node = &table->value[mantissa >> 25];
    const uint32_t rise = (uint32_t)(node[1] - node[0]) * (mantissa >> 13 & 0xfff);
    return (node[0] + (rise >> 12)) * table->value[GLINT_POWER_OCTAVE + zeros] >> 15;
}

/* 2 UNIT^2: the square of a right angle's chord. */
#define CHORD_OF_RIGHT_ANGLE (2u * GLINT_UNIT * GLINT_UNIT)

uint32_t glint_power_of_chord(const glint_power_table *table, uint32_t chord) {
    if (chord >= CHORD_OF_RIGHT_ANGLE)
        return glint_power_of_zero(table);
    const uint32_t lacking = chord >> 12; /* UNIT^2 is 2^30 less a part in 2^12 */
    if (table->direct)                    /* cos = 1 - chord / 2 */
        return power_by_octaves(table, (1u << 31) - chord - lacking);
    const uint32_t half = chord >> 16; /* sin^2 = chord - (chord / 2)^2, as much short of 1 as the table expects */
    return glint_power_at(table, chord - half * half - lacking);
}
