/* SPDX-License-Identifier: MIT */
/* Materials: the helper for surfaces of one paint. */
#include "../glint.h"
#include "../math/numeric.h"

glint_material glint_material_paint(const glint_shading_model *model, glint_colour paint, glint_q16 ambient_fraction,
                                    glint_q16 shininess) {
    glint_material material = {model, paint, paint, {GLINT_ONE, GLINT_ONE, GLINT_ONE}, shininess, 0};
    glint_q16 *const ambient[3] = {&material.ambient.r, &material.ambient.g, &material.ambient.b};
    for (int c = 0; c < 3; c++)
        *ambient[c] = (glint_q16)glint_round_shift64((int64_t)*ambient[c] * ambient_fraction, 16);
    return material;
}
