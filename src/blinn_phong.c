/* SPDX-License-Identifier: MIT */
/* Blinn-Phong lighting (Blinn, 1977) of fragments with unit normals. */
#include "frame.h"

/* cos^p in Q15 from the unit vectors N and H, N.H above 0. */
static uint32_t specular_power(const glint_power_table *table, const int16_t n[3], const int16_t h[3], int32_t cosine) {
    if (table->direct) {
        uint32_t x = ((uint32_t)cosine << 1) + ((uint32_t)cosine >> 11); /* Q31; UNIT^2 is 2^30 less a part in 2^12 */
        return (glint_power(x > 1u << 31 ? 1u << 31 : x, table->exponent) + (1u << 14)) >> 15;
    }
    int32_t x = glint_shift_right(n[1] * h[2] - n[2] * h[1] + 0x4000, 15);
    int32_t y = glint_shift_right(n[2] * h[0] - n[0] * h[2] + 0x4000, 15);
    int32_t z = glint_shift_right(n[0] * h[1] - n[1] * h[0] + 0x4000, 15);
    uint32_t u = (uint32_t)(x * x + y * y + z * z); /* sin^2, Q30 */
    if (u >= table->window)
        return 0;
    const uint16_t *node = &table->value[u >> table->index_shift];
    int32_t fraction =
        (int32_t)((u >> (table->index_shift - GLINT_POWER_FRACTION_BITS)) & ((1u << GLINT_POWER_FRACTION_BITS) - 1));
    return (uint32_t)(node[0] + glint_shift_right((node[1] - node[0]) * fraction, GLINT_POWER_FRACTION_BITS));
}

/* 0^p, Q15: 0^0 is 1. */
static uint32_t power_of_zero(const glint_power_table *table) {
    return table->exponent ? 0 : 1u << 15;
}

static void add(uint32_t colour[3], uint32_t amount, const uint32_t weight[3]) {
    colour[0] += amount * weight[0] >> 4;
    colour[1] += amount * weight[1] >> 4;
    colour[2] += amount * weight[2] >> 4;
}

/* Specular power of fragment i under the infinite viewer: one half vector. */
static uint32_t specular_infinite(const glint_power_table *table, const glint_prepared_light *light,
                                  const int16_t normal[3]) {
    int32_t cosine = glint_dot(normal, light->half_vector);
    if (cosine <= 0)
        return power_of_zero(table);
    int32_t bound = glint_shift_right(cosine, 15) + 1;
    if (glint_shift_right(bound * bound, 15) < table->cosine_square_floor)
        return 0;
    return specular_power(table, normal, light->half_vector, cosine);
}

/* The same with H = L + V; made unit only where a highlight is possible. */
static uint32_t specular_local(const glint_power_table *table, const glint_prepared_light *light,
                               const int16_t normal[3], const int16_t view[3]) {
    int32_t x = light->direction[0] + view[0];
    int32_t y = light->direction[1] + view[1];
    int32_t z = light->direction[2] + view[2];
    int32_t along = normal[0] * x + normal[1] * y + normal[2] * z; /* |L + V| is at most 2 UNIT: below 2^31 */
    if (along <= 0)
        return power_of_zero(table);
    /* |H|^2 = 2 (1 + L.V): compare cos^2 |H|^2 / 4 with its floor, both rounded to the safe side. */
    int32_t half_square = glint_shift_right(GLINT_UNIT * GLINT_UNIT + glint_dot(light->direction, view), 16);
    int32_t bound = glint_shift_right(along, 16) + 1;
    if (bound * bound < table->cosine_square_floor * half_square)
        return 0;
    int16_t half_vector[3];
    glint_unit(x, y, z, half_vector);
    int32_t cosine = glint_dot(normal, half_vector);
    return cosine > 0 ? specular_power(table, normal, half_vector, cosine) : power_of_zero(table);
}

static void light(const glint_shading *shading, uint32_t index, const glint_view *view, glint_fragments *fragments) {
    const glint_prepared_light *source = &view->lights[index];
    for (uint32_t i = 0; i < fragments->count; i++) {
        const int16_t *normal = fragments->normal[i];
        int32_t cosine = glint_dot(normal, source->direction);
        if (cosine <= 0)
            continue;
        /* UNIT^2 is 2^30 less a part in 2^12 */
        uint32_t diffuse = (uint32_t)glint_shift_right(cosine + glint_shift_right(cosine, 12), 15);
        add(fragments->colour[i], diffuse, shading->weights[index].diffuse);
        if (!shading->has_specular)
            continue;
        uint32_t specular = view->local_viewer ? specular_local(&shading->power, source, normal, fragments->view[i])
                                               : specular_infinite(&shading->power, source, normal);
        if (specular)
            add(fragments->colour[i], specular, shading->weights[index].specular);
    }
}

const glint_model glint_model_blinn_phong = {light};
