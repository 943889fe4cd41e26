/* SPDX-License-Identifier: MIT */
/* Tables of powers of a cosine over its square. */
#include "draw.h"
#include "number.h"

#define HALF_BITS 17 /* of the exponent's half, which is the shininess as it stands */

/* base^(exponent / 2^17): whole powers by squares, the rest by roots. */
static float power(float base, uint32_t exponent) {
    float result = 1, square = base, root = base;

    for (uint32_t whole = exponent >> HALF_BITS; whole; whole >>= 1) {
        result = whole & 1 ? result * square : result;
        square *= square;
    }
    for (uint32_t fraction = exponent << (32 - HALF_BITS); fraction; fraction <<= 1) {
        root = float_root(root);
        result = fraction & 0x80000000u ? result * root : result;
    }
    return result;
}

/* An entry between two positions: a line through both nodes. */
static void put(float_power *entry, float at, float step, float here, float next) {
    entry->slope = (next - here) / step;
    entry->value = here - entry->slope * at;
}

/* Intervals of equal width, from where the power passes the cut. */
static void prepare_even(float_powers *powers, uint32_t exponent) {
    /* where the power is the cut: the exponent is 1 over the half */
    const float least = power(powers->cut, (uint32_t)(17179869184.0f / (float)exponent));
    const float width = (1 - least) / FLOAT_POWERS;
    float here = power(least, exponent);

    powers->scale = 1 / width;
    powers->offset = -least / width;
    for (uint32_t i = 0; i < FLOAT_POWERS + 2; i++) {
        const float next = i < FLOAT_POWERS ? power(least + width * (float)(i + 1), exponent) : here;
        put(&powers->table[i], (float)i, 1, here, next);
        here = next;
    }
}

/* Below an exponent of 2 the power is steep at 0: intervals are eighths of their octave, from 2^-16 on. */
static float low_node(uint32_t i) {
    float node;
    const uint32_t bits = FLOAT_LOW_FIRST + (i << FLOAT_LOW_SHIFT);

    __builtin_memcpy(&node, &bits, sizeof node);
    return node;
}

static void prepare_low(float_powers *powers, uint32_t exponent) {
    powers->table[0] = (float_power){power(low_node(0), exponent), 0}; /* and all below */
    for (uint32_t i = 0; i <= FLOAT_POWERS; i++) {
        const float at = low_node(i), next = low_node(i + 1);
        put(&powers->table[i + 1], at, next - at, power(at, exponent), power(next, exponent));
    }
}

void float_prepare_powers(float_powers *powers, glint_q16 shininess, float cut) {
    cut = cut < 0.5f ? cut : 0.5f;
    if (powers->shininess == shininess && powers->cut == cut) {
        return;
    }
    powers->shininess = shininess;
    powers->cut = cut;
    powers->at_zero = shininess == 0;
    if (shininess < 2 * GLINT_ONE) {
        prepare_low(powers, (uint32_t)shininess);
    } else {
        prepare_even(powers, (uint32_t)shininess);
    }
}
