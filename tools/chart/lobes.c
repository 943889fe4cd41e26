/* SPDX-License-Identifier: MIT */
/* cos^p over the angle, as the library computes it and as it is: prints exponent, degrees, both from 0 to 1. */
#include "light/model.h"

#include <math.h>
#include <stdio.h>

#define STEPS 360 /* quarters of a degree */

static int16_t rounded(double x) {
    return (int16_t)lround(x * GLINT_UNIT);
}

static double by_library(const glint_power_table *table, double angle) {
    const int16_t axis[3] = {0, 0, GLINT_UNIT}, vector[3] = {rounded(sin(angle)), 0, rounded(cos(angle))};
    const int32_t cosine = glint_dot(axis, vector);
    return cosine > 0 ? (int32_t)glint_specular_power(table, axis, vector, cosine) / 32768.0 : 0;
}

int main(void) {
    puts("p,degrees,library,true");
    for (int32_t p = GLINT_ONE / 4; p <= 256 * GLINT_ONE; p *= 4) {
        glint_power_table table;
        glint_power_prepare(&table, p, 1u << 12, 0);
        for (int i = 0; i <= STEPS; i++) {
            const double angle = i * acos(-1) / (2 * STEPS);
            const double power = i < STEPS ? pow(cos(angle), p / 65536.0) : 0;
            printf("%g,%g,%.5f,%.5f\n", p / 65536.0, i * 90.0 / STEPS, by_library(&table, angle), power);
        }
    }
    return ferror(stdout) || fflush(stdout);
}
