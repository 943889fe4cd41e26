/* SPDX-License-Identifier: MIT */
/* Spots: point lights within a cone, with a smooth step from its inner to its outer angle. */
#include "point.h"

/* Cosine of an angle in degrees, times UNIT^2. */
static int32_t cosine_of(glint_q16 degrees) {
    int64_t cosine = glint_sine(glint_phase(degrees) + 0x40000000u);
    return (int32_t)glint_round_shift64(cosine * (GLINT_UNIT * GLINT_UNIT), 30);
}

static glint_status prepare_spot(const glint_light *light, glint_prepared_light *prepared, const glint_view *view) {
    if (light->inner < 0 || light->inner > light->outer || light->outer > 180 * GLINT_ONE)
        return GLINT_ERROR_CONE;
    if (glint_point_attenuation(light, prepared) != GLINT_OK)
        return GLINT_ERROR_ATTENUATION;
    prepared->spot.cosine_inner = cosine_of(light->inner);
    prepared->spot.cosine_outer = cosine_of(light->outer);
    int32_t width = glint_shift_right(prepared->spot.cosine_inner - prepared->spot.cosine_outer, 15);
    prepared->spot.slope = width > 0 ? (1 << 30) / width : 0;
    if (!glint_direction_to_camera(view, light->axis, prepared->direction))
        return GLINT_ERROR_DIRECTION;
    for (int i = 0; i < 3; i++)
        prepared->direction[i] = (int16_t)-prepared->direction[i];
    return GLINT_OK;
}

/* t^2 (3 - 2 t), Q15, for t = past slope / 2^30: past from 0 up, the product at most 2^30. */
static uint32_t smooth_step(int32_t past, int32_t slope) {
    uint32_t t = (uint32_t)glint_shift_right(past * slope, 15);
    return (t * t >> 15) * ((3u << 15) - 2 * t) >> 15;
}

static void illuminate_spot(const glint_prepared_light *light, glint_fragments *fragments) {
    glint_point_illuminate(light, fragments);
    for (uint32_t i = 0; i < fragments->count; i++) {
        if (!fragments->strength[i])
            continue;
        int32_t cosine = glint_dot(fragments->light[i], light->direction);
        if (cosine >= light->spot.cosine_inner)
            continue;
        /* past is at most inner - outer, of which slope is the inverse */
        const int32_t past = glint_shift_right(cosine - light->spot.cosine_outer, 15);
        const uint32_t step = past > 0 ? smooth_step(past, light->spot.slope) : 0;
        fragments->strength[i] = (uint16_t)(fragments->strength[i] * step >> 15);
    }
}

const glint_light_type glint_light_spot = {prepare_spot, illuminate_spot, glint_point_place, 1};
