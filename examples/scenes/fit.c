/* SPDX-License-Identifier: MIT */
/* Scenes on displays of other proportions than they are composed for. */
#include "scenes.h"

/* Half the largest field of view of a camera. */
#define HALF_MAX GLINT_Q16(85)

/*
 * The largest angle in Q16.16 degrees whose tangent is at most across / down times that of `half`, and at most
 * HALF_MAX; by bisection. across and down are products of two sizes, below 2^32: no product here reaches 2^49.
 */
static glint_q16 widen(glint_q16 half, uint32_t across, uint32_t down) {
    const int64_t sine = (int64_t)glint_sin(half) * across / down, cosine = glint_cos(half);
    glint_q16 least = half, most = HALF_MAX;

    while (least < most) {
        const glint_q16 middle = least + (most - least + 1) / 2;
        if (glint_sin(middle) * cosine <= sine * glint_cos(middle)) {
            least = middle;
        } else {
            most = middle - 1;
        }
    }
    return least;
}

void example_fit(example_stage *stage, const example_scene *scene, uint16_t width, uint16_t height) {
    const uint32_t across = (uint32_t)scene->width * height, down = (uint32_t)scene->height * width;

    if (across > down) {
        glint_camera *camera = &stage->scene.camera;
        camera->field_of_view = 2 * widen(camera->field_of_view / 2, across, down);
    }
}
