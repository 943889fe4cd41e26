/* SPDX-License-Identifier: MIT */
/** @file lookup.h Reading tables, as several methods do. */
#ifndef GLINT_METHODS_LOOKUP_H
#define GLINT_METHODS_LOOKUP_H

#include "light/shading.h"
#include "math/numeric.h"

/** Between a node and the next, at a fraction of so many bits. */
static inline int32_t lookup_between(const uint16_t *node, int32_t fraction, unsigned bits) {
    return node[0] + glint_shift_right((node[1] - node[0]) * fraction, bits);
}

/** The library's power table at sin^2, Q30: Q15. */
static inline int32_t lookup_power(const glint_power_table *table, uint32_t u) {
    if (u >= table->window) {
        return 0;
    }
    const uint32_t fraction = u >> (table->index_shift - GLINT_POWER_FRACTION_BITS);
    return lookup_between(&table->value[u >> table->index_shift],
                          (int32_t)(fraction & ((1u << GLINT_POWER_FRACTION_BITS) - 1)), GLINT_POWER_FRACTION_BITS);
}

#endif
