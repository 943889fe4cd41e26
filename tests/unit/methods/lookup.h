/* SPDX-License-Identifier: MIT */
/** @file lookup.h Reading tables, as several methods do. */
#ifndef GLINT_METHODS_LOOKUP_H
#define GLINT_METHODS_LOOKUP_H

#include "math/numeric.h"

/** Between a node and the next, at a fraction of so many bits. */
static inline int32_t lookup_between(const uint16_t *node, int32_t fraction, unsigned bits) {
    return node[0] + glint_shift_right((node[1] - node[0]) * fraction, bits);
}

#endif
