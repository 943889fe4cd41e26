/* SPDX-License-Identifier: MIT */
/* Blinn-Phong lighting (Blinn, 1977): highlights by the half vector H = L + V. */
#include "corners.h"
#include "lamps.h"
#include "model.h"

/* Where all of L + V is less, the light being straight behind, rounding alone gives it its direction. */
#define LEAST_SUM 8

/* The window is tested before H is made unit: (N.H)^2 against |H|^2 times its floor, rounded to the safe side. */
static uint32_t highlight_of_half_vector(const glint_power_table *table, const int32_t normal[3],
                                         const int32_t light[3], const int32_t view[3]) {
    int32_t x = light[0] + view[0], y = light[1] + view[1], z = light[2] + view[2];
    const int32_t along = normal[0] * x + normal[1] * y + normal[2] * z; /* |H| is at most 2 UNIT: below 2^31 */
    const uint32_t square = (uint32_t)x * (uint32_t)x + (uint32_t)y * (uint32_t)y + (uint32_t)z * (uint32_t)z;
    if (along <= 0 || square < LEAST_SUM * LEAST_SUM)
        return glint_power_of_zero(table);
    const int32_t bound = glint_shift_right(along, 16) + 1;
    if (bound * bound < table->cosine_square_floor * (int32_t)(square >> 17))
        return 0;
    if (square >= 1u << 30) { /* light and eye lie within 120 degrees */
        const int32_t root = glint_inverse_root(square >> 2);
        x = glint_shift_right(glint_shift_right(x, 1) * root + 0x4000, 15);
        y = glint_shift_right(glint_shift_right(y, 1) * root + 0x4000, 15);
        z = glint_shift_right(glint_shift_right(z, 1) * root + 0x4000, 15);
    } else {
        int32_t h[3] = {x, y, z}, exponent;
        glint_corner_unit(h, &exponent);
        x = h[0];
        y = h[1];
        z = h[2];
    }
    x -= normal[0];
    y -= normal[1];
    z -= normal[2];
    return glint_power_of_chord(table, (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z));
}

const glint_model glint_model_blinn_phong = {.prepare = glint_prepare_specular,
                                             .is_lit = 1,
                                             .reflect = glint_reflect_half,
                                             .lobe = GLINT_LOBE_HALF_VECTOR,
                                             .highlight = highlight_of_half_vector};
