/* SPDX-License-Identifier: MIT */
/** @file model.h What lighting models share: the specular power. */
#ifndef GLINT_MODEL_H
#define GLINT_MODEL_H

#include "../math/numeric.h"
#include "shading.h"

/** 0^p, Q15: 0^0 is 1. */
static inline uint32_t glint_power_of_zero(const glint_power_table *table) {
    return table->exponent ? 0 : 1u << 15;
}

/** cos^p, Q15, for sin^2 in Q30 from the table; p is 2 or more. */
static inline uint32_t glint_power_at(const glint_power_table *table, uint32_t u) {
    if (u >= table->window)
        return 0;
    const uint16_t *node = &table->value[u >> table->index_shift];
    int32_t fraction =
        (int32_t)((u >> (table->index_shift - GLINT_POWER_FRACTION_BITS)) & ((1u << GLINT_POWER_FRACTION_BITS) - 1));
    return (uint32_t)(node[0] + glint_shift_right((node[1] - node[0]) * fraction, GLINT_POWER_FRACTION_BITS));
}

/**
 * cos^p, Q15, of the angle between two vectors as long as GLINT_UNIT, up to 2^-12 of that more or less, from the square
 * of what lies between their ends; below 2^32.
 */
uint32_t glint_power_of_chord(const glint_power_table *table, uint32_t chord);

/** The power table of a model with highlights. */
static inline void glint_prepare_specular(glint_shading *shading, uint32_t largest_specular) {
    if (largest_specular && shading->changed)
        glint_power_prepare(&shading->power, shading->shininess, largest_specular);
}

#endif
