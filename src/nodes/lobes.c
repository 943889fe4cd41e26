/* SPDX-License-Identifier: MIT */
/* Lobes: highlights at a node, for sums that hold them. */
#include "lobes.h"

#include "../light/model.h"

/* Q15, of a highlight at a node. */
static int32_t shine_of(const glint_shading *shading, const int16_t number[GLINT_NUMBERS]) {
    const glint_light_terms *light = shading->terms;
    const int32_t x = number[GLINT_LOBE_X], y = number[GLINT_LOBE_Y];
    int32_t power;
    if (light->lobe_is_wide)
        power =
            x <= 0 ? 0 : (int32_t)glint_power_of_cosine(light->cosine, (uint32_t)glint_least(2 * x, INT16_MAX) << 16);
    else
        power = (int32_t)glint_power_at(&shading->power, (uint32_t)(x * x + y * y) << 2 >> 2 * light->lobe_shift);
    return glint_shift_right(power * number[GLINT_STRENGTH], 14);
}

void glint_node_shine(const glint_shading *shading, uint32_t summed, glint_node *node) {
    const glint_light_terms *light = shading->terms;
    const unsigned down = 12 + light->sum_bits;
    int32_t red = 1 << down >> 1, green = red, blue = red;
    for (uint32_t i = 0; summed >> i; i++) {
        if (!(summed >> i & 1))
            continue;
        const int32_t amount = shine_of(shading, node->number[i]);
        red += amount * light->specular[i][0];
        green += amount * light->specular[i][1];
        blue += amount * light->specular[i][2];
    }
    node->shine[0] = glint_shift_right(red, down);
    node->shine[1] = glint_shift_right(green, down);
    node->shine[2] = glint_shift_right(blue, down);
}
