/* SPDX-License-Identifier: MIT */
/* Directional lights: their light comes from the same direction everywhere. */
#include "../math/numeric.h"
#include "evaluation.h"
#include "lamps.h"

static glint_status prepare_directional(const glint_light *light, glint_prepared_light *prepared,
                                        const glint_view *view) {
    if (!glint_light_to_camera(view, light, 1, prepared->direction))
        return GLINT_ERROR_DIRECTION;
    /* H = L + V, where V = (0, 0, 1). L may be 2.3 steps too long or too short, so that a z of 2 or less may be nothing
     * but rounding. */
    const int32_t z = prepared->direction[2] + GLINT_UNIT;
    glint_unit(prepared->direction[0], prepared->direction[1], z > 2 ? z : 0, prepared->half_vector);
    return GLINT_OK;
}

const glint_light_type glint_light_directional = {
    .prepare = prepare_directional, .arrive = glint_arrive_from_direction, .suns = &glint_suns_of_lights};
