/* SPDX-License-Identifier: MIT */
/* Shading: multiplies the colours of a material with those of the lights, and finds which lights are visible on it. */
#include "shading.h"

#include "../math/product.h"
#include "../scene/arena.h"

/* Multiplies two colours, with `bits` fractional bits and rounded to nearest. @return the largest channel, or -1 if one
 * exceeds GLINT_COLOUR_MAX */
static int32_t weigh_colour(const glint_colour *a, const glint_colour *b, int bits, uint32_t weight[3]) {
    const glint_q16 left[3] = {a->r, a->g, a->b}, right[3] = {b->r, b->g, b->b};
    int32_t largest = 0;
    for (int c = 0; c < 3; c++) {
        int64_t product = glint_product(left[c], right[c]);
        if (product > (int64_t)GLINT_COLOUR_MAX << 16)
            return -1;
        const int32_t here = (int32_t)glint_shift_round64(product, 32 - bits);
        weight[c] = (uint32_t)here;
        largest = here > largest ? here : largest;
    }
    return largest;
}

/* Sets a number that tables are made from, and notes whether it changes. */
static inline void renew(glint_shading *shading, uint32_t *number, uint32_t value) {
    shading->changed |= GLINT_SMALL ? 0 : *number ^ value;
    *number = value;
}

static void renew_colour(glint_shading *shading, uint32_t number[3], const uint32_t value[3]) {
    for (int c = 0; c < 3; c++)
        renew(shading, &number[c], value[c]);
}

/* Sets the weights of all lights, and which of them are visible. @return the largest specular weight, or -1 if a weight
 * exceeds GLINT_COLOUR_MAX */
static int32_t weigh_lights(const glint_scene *scene, glint_shading *shading) {
    const glint_material *material = shading->material;
    uint32_t lights = 0, has_specular = 0, weight[2][3] = {{0}};
    int32_t largest = 0;
    for (uint32_t i = 0; i < scene->light_count; i++) {
        const glint_light *light = &scene->lights[i];
        const int32_t diffuse = weigh_colour(&material->diffuse, &light->diffuse, 12, weight[0]);
        const int32_t specular = weigh_colour(&material->specular, &light->specular, 12, weight[1]);
        if ((diffuse | specular) < 0)
            return -1;
        renew_colour(shading, shading->weights[i].diffuse, weight[0]);
        renew_colour(shading, shading->weights[i].specular, weight[1]);
        has_specular |= (uint32_t)(specular > 0) << i;
        lights |= (uint32_t)((diffuse | specular) > 0) << i;
        largest = glint_most(specular, largest);
    }
    renew(shading, &shading->lights, material->model->is_lit ? lights : 0);
    renew(shading, &shading->has_specular, material->model->prepare ? has_specular : 0);
    return largest;
}

glint_status glint_prepare_shading(const glint_frame *frame, glint_shading *shading, const glint_material *material) {
    uint32_t ambient[3] = {0};
    shading->changed = GLINT_SMALL || shading->material != material || shading->shininess != material->shininess;
    shading->material = material;
    shading->shininess = material->shininess;
    if (weigh_colour(&material->ambient, &frame->scene->ambient, 23, ambient) < 0)
        return GLINT_ERROR_COLOUR;
    renew_colour(shading, shading->ambient, ambient);
    const int32_t largest = weigh_lights(frame->scene, shading);
    if (largest < 0)
        return GLINT_ERROR_COLOUR;
    if (!GLINT_SMALL && frame->config.keeps_arena && !shading->changed)
        shading->changed = glint_sum(&shading->power, sizeof shading->power) != shading->power_sum;
    if (material->model->prepare)
        material->model->prepare(shading, (uint32_t)largest);
    if (!GLINT_SMALL && frame->config.keeps_arena && shading->changed)
        shading->power_sum = glint_sum(&shading->power, sizeof shading->power);
    return GLINT_OK;
}
