/* SPDX-License-Identifier: MIT */
#include "random_layers.h"

#include "glint_extras.h"

#include <stdlib.h>

static glint_q16 cut_off(int64_t number) {
    return (glint_q16)(number > INT32_MAX ? INT32_MAX : number);
}

/* From the eye to an object, along the axis where that is longest. */
static int64_t find_distance(const glint_scene *scene, const glint_object *object) {
    int64_t most = 1;
    for (int row = 0; row < 3; row++) {
        const int64_t apart = llabs((int64_t)object->pose.m[row][3] - scene->camera.pose.m[row][3]);
        most = apart > most ? apart : most;
    }
    return most;
}

static void make_fog(const glint_scene *scene, glint_fog *fog, source *random) {
    static const glint_q16 extremes[4][2] = {{0, 1}, {0, INT32_MAX}, {INT32_MAX - 1, INT32_MAX}, {65536, 65537}};
    const int64_t distance = scene->object_count ? find_distance(scene, &scene->objects[0]) : GLINT_ONE;
    *fog = (glint_fog){.type = one_in(random, 2) ? &glint_fog_squared : &glint_fog_linear};
    fog->colour.r = (glint_q16)below(random, GLINT_ONE + 1);
    fog->colour.g = (glint_q16)below(random, one_in(random, 8) ? GLINT_COLOUR_MAX : GLINT_ONE + 1);
    fog->colour.b = (glint_q16)below(random, GLINT_ONE + 1);
    fog->to_background = (uint8_t)below(random, 2);
    const uint32_t start = below(random, 257), length = below(random, 513), extreme = below(random, 4);
    fog->start = cut_off(distance * start / 256);
    fog->end = cut_off(fog->start + 1 + distance * length / 256);
    if (fog->end <= fog->start || one_in(random, 8)) {
        fog->start = extremes[extreme][0];
        fog->end = extremes[extreme][1];
    }
}

void random_layers_add(glint_scene *scene, glint_object *objects, glint_material *materials, glint_fog *fog,
                       source *random) {
    for (uint32_t i = 0; i < scene->object_count; i++) {
        if (one_in(random, 2))
            continue;
        const uint32_t ends = below(random, 8), opacity = below(random, GLINT_ONE + 1);
        materials[i].blend = (glint_blend)(1 + below(random, 3));
        materials[i].opacity = ends == 0 ? 0 : ends == 1 ? GLINT_ONE : (glint_q16)opacity;
        if (one_in(random, 4))
            objects[i].order = (int16_t)(below(random, 3) - 1);
    }
    if (one_in(random, 2)) {
        make_fog(scene, fog, random);
        scene->fog = fog;
    }
}
