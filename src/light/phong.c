/* SPDX-License-Identifier: MIT */
/* Phong lighting (Phong, 1975): highlights by the mirrored light R = 2 (N.L) N - L. */
#include "corners.h"
#include "lamps.h"
#include "model.h"

/*
 * R - V, where R = 2 (N.L / N.N) N - L has the length of L. N.N counts, as R would turn by up to 2^-13 without. Of all
 * lengths, |R - V| is below 2^16.
 */
static uint32_t highlight_of_mirror(const glint_power_table *table, const int32_t normal[3], const int32_t light[3],
                                    const int32_t view[3]) {
    const int32_t lacking = (1 << 30) - glint_corner_dot(normal, normal), cosine = glint_corner_dot(normal, light);
    const int32_t share = cosine + glint_shift_right(cosine, 15) * glint_shift_right(lacking + (1 << 14), 15);
    const int32_t along = glint_shift_right(share + (1 << 14), 15);
    const int32_t x = glint_shift_right(along * normal[0] + (1 << 13), 14) - light[0] - view[0],
                  y = glint_shift_right(along * normal[1] + (1 << 13), 14) - light[1] - view[1],
                  z = glint_shift_right(along * normal[2] + (1 << 13), 14) - light[2] - view[2];
    return glint_power_of_chord(table,
                                (uint32_t)x * (uint32_t)x + (uint32_t)y * (uint32_t)y + (uint32_t)z * (uint32_t)z);
}

const glint_model glint_model_phong = {.prepare = glint_prepare_specular,
                                       .is_lit = 1,
                                       .reflect = glint_reflect_mirror,
                                       .lobe = GLINT_LOBE_MIRROR,
                                       .highlight = highlight_of_mirror};
