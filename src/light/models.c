/* SPDX-License-Identifier: MIT */
/* Models: how surfaces reflect light. */
#include "corners.h"
#include "lamps.h"

/* Makes the power table of a model with highlights, unless the last frame left the same one. */
static void prepare_specular(glint_shading *shading, uint32_t largest_specular) {
    if (largest_specular && shading->changed)
        glint_power_prepare(&shading->power, shading->shininess, largest_specular);
}

/* Sets a plain colour, for things such as visible lamps: the diffuse colour replaces ambient light. */
static void prepare_unlit(glint_shading *shading, uint32_t largest_specular) {
    const glint_colour *colour = &shading->material->diffuse;
    (void)largest_specular;
    shading->has_specular = 0;
    shading->ambient[0] = (uint32_t)colour->r << 7;
    shading->ambient[1] = (uint32_t)colour->g << 7;
    shading->ambient[2] = (uint32_t)colour->b << 7;
}

const glint_shading_model glint_model_unlit = {.prepare = prepare_unlit, .lobe = GLINT_LOBE_OTHER};

/* Matt surfaces (Lambert, 1760) have ambient and diffuse light alone. */
const glint_shading_model glint_model_lambert = {.is_lit = 1, .reflect = glint_reflect_matt, .lobe = GLINT_LOBE_NONE};

/* Phong lighting (Phong, 1975) has highlights around the mirrored light R = 2 (N.L) N - L. */
const glint_shading_model glint_model_phong = {.prepare = prepare_specular,
                                               .is_lit = 1,
                                               .reflect = glint_reflect_mirror,
                                               .lobe = GLINT_LOBE_MIRROR,
                                               .highlight = glint_highlight_of_mirror};

/* Blinn-Phong lighting (Blinn, 1977) has highlights around the half vector H = L + V. */
const glint_shading_model glint_model_blinn_phong = {.prepare = prepare_specular,
                                                     .is_lit = 1,
                                                     .reflect = glint_reflect_half,
                                                     .lobe = GLINT_LOBE_HALF_VECTOR,
                                                     .highlight = glint_highlight_of_half_vector};
