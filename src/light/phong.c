/* SPDX-License-Identifier: MIT */
/* Phong lighting (Phong, 1975): highlights by the mirrored light R = 2 (N.L) N - L. */
#include "model.h"

static uint32_t specular_of_mirror(const glint_power_table *table, const glint_prepared_light *source,
                                   const int16_t normal[3], const int16_t light[3], const int16_t view[3]) {
    (void)source;
    int16_t mirrored[3];
    glint_mirror(glint_dot(normal, light), normal, light, mirrored);
    int32_t along = glint_dot(mirrored, view);
    if (along <= 0)
        return glint_power_of_zero(table);
    if (!glint_in_window(table, along))
        return 0;
    return glint_specular_power(table, mirrored, view, along);
}

static void light_phong(const glint_shading *shading, uint32_t index, const glint_view *view,
                        glint_fragments *fragments, int has_surface) {
    glint_light_fragments(shading, index, view, fragments, has_surface, specular_of_mirror);
}

const glint_model glint_model_phong = {glint_prepare_specular, light_phong, GLINT_LOBE_MIRROR};
