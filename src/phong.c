/* SPDX-License-Identifier: MIT */
/* Phong lighting (Phong, 1975): highlights by the mirrored light R = 2 (N.L) N - L. */
#include "light.h"

/* A component of R. 2 (N.L) N may pass 2^31, as rounding makes unit vectors longer; R itself is below. */
static inline int32_t mirror(int32_t twice, int32_t normal, int32_t light) {
    return glint_shift_right(glint_add_wrap(glint_multiply_wrap(twice, normal), -light * (1 << 15)), 15);
}

static uint32_t specular(const glint_power_table *table, const glint_prepared_light *source, const int16_t normal[3],
                         const int16_t light[3], const int16_t view[3]) {
    (void)source;
    int32_t cosine = glint_dot(normal, light);
    int32_t twice = glint_shift_right(cosine + glint_shift_right(cosine, 12), 14); /* 2 N.L, Q15 */
    int16_t mirrored[3];
    glint_unit(mirror(twice, normal[0], light[0]), mirror(twice, normal[1], light[1]),
               mirror(twice, normal[2], light[2]), mirrored);
    int32_t along = glint_dot(mirrored, view);
    if (along <= 0)
        return glint_power_of_zero(table);
    if (!glint_in_window(table, along))
        return 0;
    return glint_specular_power(table, mirrored, view, along);
}

static void light(const glint_shading *shading, uint32_t index, const glint_view *view, glint_fragments *fragments,
                  int has_surface) {
    glint_light_fragments(shading, index, view, fragments, has_surface, specular);
}

const glint_model glint_model_phong = {glint_prepare_specular, light, GLINT_LOBE_OTHER};
