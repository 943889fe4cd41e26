/* SPDX-License-Identifier: MIT */
/* Lights: the helpers that set them up. */
#include "view.h"

/* What a lamp is weakened by at its range: 126 = 1 + 125, of which light is half a step of green's 63. */
#define WEAKENED 125

/* Where the quadratic coefficient would be beyond Q16.16: 1/16. */
#define RANGE_LEAST (GLINT_ONE / 16)

/*
 * Sets attenuation so that linear range + quadratic range^2 is WEAKENED. What the quadratic coefficient loses by its 16
 * bits of fraction, all beyond a range of 2862, is the linear one's.
 */
static void set_attenuation(glint_light *light, glint_q16 range) {
    if (range < RANGE_LEAST) {
        light->quadratic = -1; /* GLINT_ERROR_ATTENUATION */
        return;
    }
    const uint64_t square = (uint64_t)range * (uint32_t)range, weakened = (uint64_t)WEAKENED << 48; /* Q32; Q48 */
    light->quadratic = (glint_q16)(weakened / square);
    light->linear = (glint_q16)((weakened % square / (uint32_t)range + (1 << 15)) >> 16);
}

static glint_light begin_light(const glint_light_type *type, glint_colour colour) {
    glint_light light = {0};
    light.type = type;
    light.diffuse = light.specular = colour;
    return light;
}

glint_light glint_sun(glint_vector direction, glint_colour colour) {
    glint_light light = begin_light(&glint_light_directional, colour);
    light.direction = direction;
    return light;
}

glint_light glint_lamp(glint_vector position, glint_colour colour, glint_q16 range) {
    glint_light light = begin_light(&glint_light_point, colour);
    light.position = position;
    set_attenuation(&light, range);
    return light;
}

glint_light glint_spot(glint_vector position, glint_vector at, glint_colour colour, glint_q16 range, glint_q16 angle) {
    glint_light light = begin_light(&glint_light_spot, colour);
    const int64_t way[3] = {(int64_t)at.x - position.x, (int64_t)at.y - position.y, (int64_t)at.z - position.z};
    int32_t direction[3];
    set_attenuation(&light, range);
    glint_reduce(way, direction);
    light.position = position;
    light.direction = (glint_vector){direction[0], direction[1], direction[2]};
    light.inner = angle / 2;
    light.outer = angle;
    return light;
}
