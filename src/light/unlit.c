/* SPDX-License-Identifier: MIT */
/* Plain colour, for things such as a drawn light: the diffuse colour takes the place of ambient light. */
#include "shading.h"

static void prepare_unlit(glint_shading *shading, uint32_t largest_specular) {
    const glint_colour *colour = &shading->material->diffuse;
    (void)largest_specular;
    shading->has_specular = 0;
    shading->ambient[0] = (uint32_t)colour->r << 7;
    shading->ambient[1] = (uint32_t)colour->g << 7;
    shading->ambient[2] = (uint32_t)colour->b << 7;
}

const glint_model glint_model_unlit = {.prepare = prepare_unlit, .lobe = GLINT_LOBE_OTHER};
