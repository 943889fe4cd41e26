/* SPDX-License-Identifier: MIT */
/** @file model.h What the lighting models share: the loop over fragments, and the specular power. */
#ifndef GLINT_MODEL_H
#define GLINT_MODEL_H

#include "shade.h"

/** Specular power, Q15, of a fragment: N, L and V are unit; source is null where L is the fragment's own. */
typedef uint32_t (*glint_specular)(const glint_power_table *table, const glint_prepared_light *source,
                                   const int16_t normal[3], const int16_t light[3], const int16_t view[3]);

/** May cos^2, of a cosine of two unit vectors, lie in the table's window? Rounded to the safe side. */
static inline int glint_in_window(const glint_power_table *table, int32_t cosine) {
    int32_t bound = glint_shift_right(cosine, 15) + 1;
    return glint_shift_right(bound * bound, 15) >= table->cosine_square_floor;
}

/** 0^p, Q15: 0^0 is 1. */
static inline uint32_t glint_power_of_zero(const glint_power_table *table) {
    return table->exponent ? 0 : 1u << 15;
}

/** cos^p, Q15, for sin^2 in Q30 from the table; p is 2 or more. */
static inline uint32_t glint_power_at(const glint_power_table *table, uint32_t u) {
    if (u >= table->window)
        return 0;
    const uint16_t *node = &table->value[u >> table->index_shift];
    int32_t fraction =
        (int32_t)((u >> (table->index_shift - GLINT_POWER_FRACTION_BITS)) & ((1u << GLINT_POWER_FRACTION_BITS) - 1));
    return (uint32_t)(node[0] + glint_shift_right((node[1] - node[0]) * fraction, GLINT_POWER_FRACTION_BITS));
}

/** cos^p in Q15 between the unit vectors a and b, from their cross product; cosine is a . b, above 0. */
uint32_t glint_specular_power(const glint_power_table *table, const int16_t a[3], const int16_t b[3], int32_t cosine);

static inline void glint_add_light(uint32_t colour[3], uint32_t amount, const uint32_t weight[3]) {
    for (int c = 0; c < 3; c++)
        colour[c] += amount * weight[c] >> 4;
}

/** The diffuse part of one light on a surface with a colour of its own. */
static inline void glint_add_surface(uint32_t colour[3], uint32_t amount, const int16_t surface[3],
                                     const uint32_t weight[3]) {
    for (int c = 0; c < 3; c++)
        colour[c] += (amount * ((uint32_t)surface[c] + 1) >> 15) * weight[c] >> 4;
}

/* A component of R. 2 (N.L) N may pass 2^31, as rounding makes unit vectors longer; R itself is below. */
static inline int32_t glint_mirror_one(int32_t twice, int32_t normal, int32_t light) {
    return glint_shift_right(glint_add_wrap(glint_multiply_wrap(twice, normal), -light * (1 << 15)), 15);
}

/* 2 N.L / N.N, Q15; N.L as glint_dot has it, N 32752 to 32768 long, or 0. */
static inline int32_t glint_twice_over_square(int32_t cosine, const int16_t n[3]) {
    const int32_t lacking = (1 << 30) - (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    return glint_shift_right(cosine + glint_shift_right(cosine, 15) * glint_shift_right(lacking + (1 << 14), 15), 14);
}

/**
 * R = 2 (N.L) N - L, unit; N.L as glint_dot has it. N.N counts as it is: normals of vertices are of lengths that would
 * turn R by up to 0.8 / 2^10, and at each vertex by another part of that.
 */
static inline void glint_mirror(int32_t cosine, const int16_t normal[3], const int16_t light[3], int16_t mirrored[3]) {
    const int32_t twice = glint_twice_over_square(cosine, normal);
    glint_unit(glint_mirror_one(twice, normal[0], light[0]), glint_mirror_one(twice, normal[1], light[1]),
               glint_mirror_one(twice, normal[2], light[2]), mirrored);
}

/** Adds one light to all fragments; `specular` is a constant where this is inlined, null for matt models. */
static inline void glint_light_fragments(const glint_shading *shading, uint32_t index, const glint_view *view,
                                         glint_fragments *fragments, int has_surface, glint_specular specular) {
    const glint_prepared_light *source = &view->lights[index];
    const int has_position = source->type->illuminate != 0;
    const int fixed_half_vector = !has_position && !view->local_viewer;
    const uint32_t has_specular = specular ? shading->has_specular >> index & 1 : 0;
    const uint32_t ungated = shading->material->flags & GLINT_MATERIAL_UNGATED;
    fragments->is_gated = !ungated;
    if (has_position)
        source->type->illuminate(source, fragments);
    for (uint32_t i = 0; i < fragments->count; i++) {
        const int16_t *normal = fragments->normal[i];
        if (has_position && !fragments->strength[i])
            continue;
        const int16_t *light = has_position ? fragments->light[i] : source->direction;
        uint32_t strength = has_position ? fragments->strength[i] : 1u << 15;
        int32_t cosine = glint_dot(normal, light);
        if (cosine > 0) {
            /* UNIT^2 is 2^30 less a part in 2^12 */
            uint32_t diffuse = (uint32_t)glint_shift_right(cosine + glint_shift_right(cosine, 12), 15);
            diffuse = has_position ? diffuse * strength >> 15 : diffuse;
            if (has_surface)
                glint_add_surface(fragments->colour[i], diffuse, fragments->surface[i],
                                  shading->weights[index].diffuse);
            else
                glint_add_light(fragments->colour[i], diffuse, shading->weights[index].diffuse);
        } else if (!ungated) {
            continue;
        }
        if (!has_specular)
            continue;
        uint32_t power = specular(&shading->power, fixed_half_vector ? source : 0, normal, light, fragments->view[i]);
        if (power)
            glint_add_light(fragments->colour[i], has_position ? power * strength >> 15 : power,
                            shading->weights[index].specular);
    }
}

/** The power table of a model with highlights. */
static inline void glint_prepare_specular(glint_shading *shading, uint32_t largest_specular) {
    if (largest_specular && shading->changed)
        glint_power_prepare(&shading->power, shading->shininess, largest_specular, shading->spare);
}

#endif
