/* SPDX-License-Identifier: MIT */
/* The specular power: its table, and a fragment's look-up. */
#include "proof.h"

#include "../../src/light/power.c"
#include "../../src/light/specular.c"
#include "lit.h"

/* Stands on the power's error of 20 steps at p = 1 (`make domains`): 2^-18 short of 1 it is below 1. */
/*@ requires u <= 0x40000000;
    requires exponent >= 0x20000;
    assigns \result \from u, exponent;
    ensures 0 <= \result <= 0x40000000;
    admit ensures u >= 0x1000 ==> \result <= 0x3fffffff; */
static int32_t power_of_sine(uint32_t u, int32_t exponent);

/*@ requires exponent >= 0x20000;
    requires weight <= 0x10000;
    requires spare <= 0x10000;
    assigns \result \from exponent, weight, spare;
    ensures \result <= 0x40000000; */
static uint32_t find_window_end(int32_t exponent, uint32_t weight, uint32_t spare);

/*@ requires cut <= 0x40000000;
    assigns \result \from cut;
    ensures \result == 0x80000 || \result == 0x100000 || \result == 0x200000 || \result == 0x400000 ||
            \result == 0x800000 || \result == 0x1000000 || \result == 0x2000000 || \result == 0x4000000 ||
            \result == 0x8000000 || \result == 0x10000000 || \result == 0x20000000 || \result == 0x40000000; */
static uint32_t find_window(uint32_t cut);

/* Stands on |a x b| <= |a| |b| of unit vectors: at most 2^15 before rounding and squaring; UBSan in the image tests. */
/*@ requires \valid_read(a + (0 .. 2)) && \valid_read(b + (0 .. 2));
    assigns \result \from a[0 .. 2], b[0 .. 2]; */
static uint32_t sine_square(const int16_t a[3], const int16_t b[3]);

/* u from 0 to 2^30, p from 2 up. @contract glint_power */
PROOF(power_of_sine) {
    power_of_sine(ANY_UNSIGNED(0, 1u << 30), ANY(2 * GLINT_ONE, INT32_MAX));
}

/* p from 2 up, weights from 0 to 16, what need not show up to 16. @contract glint_exp2 */
PROOF(find_window_end) {
    find_window_end(ANY(2 * GLINT_ONE, INT32_MAX), ANY_UNSIGNED(0, 16u << 12), ANY_UNSIGNED(0, 16u << 12));
}

/* Any cut. */
PROOF(find_window) {
    find_window(ANY_UNSIGNED(0, 1u << 30));
}

/*
 * p from 0 up, weights from 0 to 16, what need not show alike. @contract find_window_end find_window power_of_sine
 * @unreached 2 leading zeros of 0 and of 1: no window is so small
 */
PROOF(glint_power_prepare) {
    glint_power_table table;
    glint_power_prepare(&table, ANY(0, 2 * GLINT_ONE - 1), ANY_UNSIGNED(0, 16u << 12), ANY_UNSIGNED(0, 16u << 12));
    glint_power_prepare(&table, ANY(2 * GLINT_ONE, INT32_MAX), ANY_UNSIGNED(0, 16u << 12), ANY_UNSIGNED(0, 16u << 12));
}

/* Vectors of components up to 32767, a cosine above 0, every window, any table. @contract glint_power sine_square */
PROOF(glint_specular_power) {
    const int16_t a[3] = {ANY_COMPONENT, ANY_COMPONENT, ANY_COMPONENT};
    const int16_t b[3] = {ANY_COMPONENT, ANY_COMPONENT, ANY_COMPONENT};
    glint_power_table table;
    table.direct = 1;
    table.exponent = ANY(0, 2 * GLINT_ONE - 1);
    glint_specular_power(&table, a, b, ANY(1, COSINE_MOST));
    table.direct = 0;
    table.exponent = ANY(2 * GLINT_ONE, INT32_MAX);
    for (int i = 0; i <= GLINT_POWER_INTERVALS; i++)
        table.value[i] = (uint16_t)ANY(0, 1 << 15);
    FOR_PARTS(shift, GLINT_POWER_FRACTION_BITS, 30 - GLINT_POWER_TABLE_BITS) {
        table.index_shift = (uint32_t)shift;
        table.window = 1u << (shift + GLINT_POWER_TABLE_BITS);
        glint_specular_power(&table, a, b, ANY(1, COSINE_MOST));
    }
}

/* A cosine from -1 to 1, any floor from 0 to 1. */
PROOF(glint_in_window) {
    glint_power_table table;
    table.cosine_square_floor = ANY(0, 1 << 15);
    glint_in_window(&table, ANY(-COSINE_MOST, COSINE_MOST));
}

/* An amount from 0 to 32775, what N.L of 1 is rounded up to, and a weight up to 16, to a colour that leaves room for
 * them. @unsigned */
PROOF(glint_add_light) {
    const uint32_t most = LIGHT_MOST;
    uint32_t colour[3] = {ANY_UNSIGNED(0, UINT_MAX - most), ANY_UNSIGNED(0, UINT_MAX - most),
                          ANY_UNSIGNED(0, UINT_MAX - most)};
    const uint32_t weight[3] = {ANY_UNSIGNED(0, 16u << 12), ANY_UNSIGNED(0, 16u << 12), ANY_UNSIGNED(0, 16u << 12)};
    glint_add_light(colour, ANY_UNSIGNED(0, 32775), weight);
}

/* The same on a surface of any colour. @unsigned */
PROOF(glint_add_surface) {
    const uint32_t most = LIGHT_MOST;
    uint32_t colour[3] = {ANY_UNSIGNED(0, UINT_MAX - most), ANY_UNSIGNED(0, UINT_MAX - most),
                          ANY_UNSIGNED(0, UINT_MAX - most)};
    const uint32_t weight[3] = {ANY_UNSIGNED(0, 16u << 12), ANY_UNSIGNED(0, 16u << 12), ANY_UNSIGNED(0, 16u << 12)};
    const int16_t surface[3] = {(int16_t)ANY(0, 32767), (int16_t)ANY(0, 32767), (int16_t)ANY(0, 32767)};
    glint_add_surface(colour, ANY_UNSIGNED(0, 32775), surface, weight);
}
