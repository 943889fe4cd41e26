/* SPDX-License-Identifier: MIT */
/* The specular power of a fragment, from the power table or, for the widest lobes, computed. */
#include "model.h"

/* sin^2 of the angle between two unit vectors, Q30. */
static uint32_t sine_square(const int16_t a[3], const int16_t b[3]) {
    int32_t x = glint_shift_right(a[1] * b[2] - a[2] * b[1] + 0x4000, 15);
    int32_t y = glint_shift_right(a[2] * b[0] - a[0] * b[2] + 0x4000, 15);
    int32_t z = glint_shift_right(a[0] * b[1] - a[1] * b[0] + 0x4000, 15);
    return (uint32_t)(x * x + y * y + z * z);
}

uint32_t glint_specular_power(const glint_power_table *table, const int16_t a[3], const int16_t b[3], int32_t cosine) {
    if (table->direct) {
        uint32_t x = ((uint32_t)cosine << 1) + ((uint32_t)cosine >> 11); /* Q31; UNIT^2 is 2^30 less a part in 2^12 */
        return (glint_power(x > 1u << 31 ? 1u << 31 : x, table->exponent) + (1u << 14)) >> 15;
    }
    return glint_power_at(table, sine_square(a, b));
}
