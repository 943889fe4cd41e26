/* SPDX-License-Identifier: MIT */
/*
 * Makes tables of the specular power cos^p over u = sin^2: (1 - u)^(p/2), linear between nodes, and only as wide as the
 * highlight is visible. At the centre of a highlight sin^2 is precise, while all cosines there are nearly 1.
 */
#include "../math/numeric.h"
#include "shading.h"

/* Returns (1 - u)^(p/2), Q30. u comes from products of vectors as long as GLINT_UNIT, whose fourth power is one part in
 * 2^11 below 2^60: so u, Q30, is too small by that part. */
static int32_t power_of_sine(uint32_t u, int32_t exponent) {
    uint32_t square = u + (u >> 11);
    if (square >= 1u << 30)
        return 0;
    return (int32_t)glint_power((1u << 31) - 2 * square, exponent >> 1);
}

/* Returns the u, Q30, where (1 - u)^(p/2) times the weight falls below 1/16 of a step of 8 bits; weights above 16 count
 * as 16. */
static uint32_t find_window_end(int32_t exponent, uint32_t weight) {
    unsigned bits = 12; /* 2^-12 is 1/16 of 1/255 */
    while (bits < 16 && weight > 1u << bits)
        bits++;
    int64_t y = ((int64_t)(2 * bits) << 42) / exponent; /* 2 bits / p, Q26 */
    return (1u << 30) - glint_exp2((int32_t)-y);
}

/* Makes the table of x^p for p < 2: GLINT_POWER_OCTAVE intervals from 1/2 to 1, and behind them the powers of 2^-i. */
static void prepare_octaves(glint_power_table *table) {
    const int32_t p = table->exponent;
    for (uint32_t i = 0; i <= GLINT_POWER_OCTAVE; i++)
        table->value[i] =
            (uint16_t)((glint_power((1u << 30) + i * ((1u << 30) / GLINT_POWER_OCTAVE), p) + (1 << 14)) >> 15);
    for (uint32_t i = 0; i < 32; i++)
        table->value[GLINT_POWER_OCTAVE + 1 + i] = (uint16_t)((glint_power((1u << 31) >> i, p) + (1 << 14)) >> 15);
}

void glint_power_prepare(glint_power_table *table, int32_t exponent, uint32_t weight) {
    table->exponent = exponent;
    table->direct = exponent < 2 * GLINT_ONE;
    const uint32_t cut = table->direct ? 1u << 30 : find_window_end(exponent, weight);
    /* The window is the least power of two from the cut up. As p is below 2^15, that is 2^20 or more, which has all
     * bits of a table's index and of positions in intervals. */
    const unsigned bits = 32 - glint_leading_zeros(cut - 1);
    table->window = 1u << bits;
    uint32_t inside = (1u << 30) - table->window;
    table->cosine_square_floor = (int32_t)((inside - (inside >> 11)) >> 15);
    if (table->direct) {
        prepare_octaves(table);
        return;
    }
    table->index_shift = bits - GLINT_POWER_TABLE_BITS;
    int32_t f[3]; /* values at three nodes in a row: around node i, if it has two neighbours */
    for (uint32_t i = 0; i < 3; i++)
        f[i] = power_of_sine(i << table->index_shift, exponent);
    for (uint32_t i = 0; i <= GLINT_POWER_INTERVALS; i++) {
        if (i > 1 && i < GLINT_POWER_INTERVALS) {
            f[0] = f[1], f[1] = f[2];
            f[2] = power_of_sine((i + 1) << table->index_shift, exponent);
        }
        /* A chord lies above a convex curve: lowering nodes by 1/16 of the second difference halves the error. */
        int32_t node = i == 0 ? f[0] : i == GLINT_POWER_INTERVALS ? f[2] : f[1];
        int32_t value = glint_shift_right(node - (f[0] - 2 * f[1] + f[2]) / 16 + (1 << 14), 15);
        table->value[i] = (uint16_t)(value < 0 ? 0 : value);
    }
}
