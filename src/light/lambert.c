/* SPDX-License-Identifier: MIT */
/* Matt surfaces (Lambert, 1760): ambient and diffuse light only. */
#include "model.h"

static void light_lambert(const glint_shading *shading, uint32_t index, const glint_view *view,
                          glint_fragments *fragments, int has_surface) {
    glint_light_fragments(shading, index, view, fragments, has_surface, 0);
}

const glint_model glint_model_lambert = {0, light_lambert, GLINT_LOBE_NONE};
