/* SPDX-License-Identifier: MIT */
/* Matt surfaces (Lambert, 1760): ambient and diffuse light only. */
#include "lamps.h"
#include "model.h"

const glint_model glint_model_lambert = {.is_lit = 1, .reflect = glint_reflect_matt, .lobe = GLINT_LOBE_NONE};
