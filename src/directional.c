/* SPDX-License-Identifier: MIT */
/* Directional lights: the same direction everywhere. */
#include "frame.h"

static glint_status prepare(const glint_light *light, glint_prepared_light *prepared, const glint_view *view) {
    if (!glint_direction_to_camera(view, light->vector, prepared->direction))
        return GLINT_ERROR_DIRECTION;
    /* H = L + V, V = (0, 0, 1) */
    glint_unit(prepared->direction[0], prepared->direction[1], prepared->direction[2] + GLINT_UNIT,
               prepared->half_vector);
    return GLINT_OK;
}

const glint_light_type glint_light_directional = {prepare, 0, 0};
