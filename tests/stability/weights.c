/* SPDX-License-Identifier: MIT */
#include "weights.h"

#include "picture.h"

#include <math.h>

double weights_sum(const glint_scene *scene, const glint_material *material) {
    double sum[3] = {0, 0, 0};
    const int shines = material->model == &glint_model_blinn_phong || material->model == &glint_model_phong;
    if (material->model == &glint_model_unlit)
        return 0;
    for (uint32_t i = 0; i < scene->light_count; i++) {
        const glint_light *light = &scene->lights[i];
        const double one = 65536.0 * 65536.0;
        const double part[3] = {
            (double)light->diffuse.r * material->diffuse.r + shines * (double)light->specular.r * material->specular.r,
            (double)light->diffuse.g * material->diffuse.g + shines * (double)light->specular.g * material->specular.g,
            (double)light->diffuse.b * material->diffuse.b + shines * (double)light->specular.b * material->specular.b};
        for (int channel = 0; channel < 3; channel++)
            sum[channel] += part[channel] / one;
    }
    return fmax(sum[0], fmax(sum[1], sum[2]));
}

double weights_slack(double sum, const glint_format *format) {
    const glint_format *kind = picture_undithered(format);
    const double whole = fmax(sum, 1);
    if (kind == &glint_format_rgb565 || kind == &glint_format_rgb565_be)
        return 0.25 * whole;
    if (picture_level_max(format, 0) == 255)
        return 0.5 * whole;
    return 0.25 * whole * picture_level_max(format, 0) / 63;
}

double weights_bound(double sum, const glint_format *format) {
    return 0.5 + weights_slack(sum, format);
}
