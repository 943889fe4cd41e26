/* SPDX-License-Identifier: MIT */
/* Blinn-Phong lighting (Blinn, 1977): highlights by the half vector H = L + V. */
#include "model.h"

/* Where all of L + V is less, the light being straight behind, rounding alone gives it its direction. */
#define LEAST_SUM 8

static inline int is_rounding(int32_t x, int32_t y, int32_t z) {
    return (glint_magnitude_bits(x) | glint_magnitude_bits(y) | glint_magnitude_bits(z)) < LEAST_SUM;
}

static uint32_t specular_of_half_vector(const glint_power_table *table, const glint_prepared_light *source,
                                        const int16_t normal[3], const int16_t light[3], const int16_t view[3]) {
    if (source) { /* the infinite viewer has one half vector */
        int32_t cosine = glint_dot(normal, source->half_vector);
        if (cosine <= 0)
            return glint_power_of_zero(table);
        if (!glint_in_window(table, cosine))
            return 0;
        return glint_specular_power(table, normal, source->half_vector, cosine);
    }
    int32_t x = light[0] + view[0];
    int32_t y = light[1] + view[1];
    int32_t z = light[2] + view[2];
    int32_t along = normal[0] * x + normal[1] * y + normal[2] * z; /* |L + V| is at most 2 UNIT: below 2^31 */
    if (along <= 0)
        return glint_power_of_zero(table);
    if (along < 2 * LEAST_SUM * GLINT_UNIT && is_rounding(x, y, z))
        return glint_power_of_zero(table);
    /* |H|^2 = 2 (1 + L.V), unit vectors being off by 2.3: compare cos^2 |H|^2 / 4 with its floor, rounded to the safe
     * side.
     */
    int32_t half_square = glint_shift_right(GLINT_UNIT * GLINT_UNIT + glint_dot(light, view), 16) - 3;
    int32_t bound = glint_shift_right(along, 16) + 1;
    if (bound * bound < table->cosine_square_floor * half_square)
        return 0;
    int16_t half_vector[3]; /* made unit only where a highlight is possible */
    glint_unit(x, y, z, half_vector);
    int32_t cosine = glint_dot(normal, half_vector);
    return cosine > 0 ? glint_specular_power(table, normal, half_vector, cosine) : glint_power_of_zero(table);
}

static void light_blinn_phong(const glint_shading *shading, uint32_t index, const glint_view *view,
                              glint_fragments *fragments, int has_surface) {
    glint_light_fragments(shading, index, view, fragments, has_surface, specular_of_half_vector);
}

const glint_model glint_model_blinn_phong = {glint_prepare_specular, light_blinn_phong, GLINT_LOBE_HALF_VECTOR};
