/* SPDX-License-Identifier: MIT */
#include "variants.h"

#include <stdlib.h>
#include <string.h>

/* ---- Exactly the same ---- */

/* Makes two objects of one, which have its first triangles and the others. */
static int split_mesh(variant *v, uint32_t choice) {
    const uint32_t count = v->scene.object_count++, which = count ? choice % count : 0;
    if (!count || v->objects[which].mesh->triangle_count < 2 || v->objects[which].mesh->clusters ||
        v->objects[which].material->blend != GLINT_BLEND_NONE) /* it is one layer, and not two */
        return 0;
    memmove(&v->objects[which + 1], &v->objects[which], (count - which) * sizeof v->objects[0]);
    memmove(&v->object_of[which + 1], &v->object_of[which], (count - which) * sizeof v->object_of[0]);
    glint_mesh *const parts = v->meshes;
    parts[0] = parts[1] = *v->objects[which].mesh;
    const uint32_t first = 1 + choice / 8 % (parts[0].triangle_count - 1);
    parts[0].triangle_count = first;
    parts[1].triangle_count -= first;
    parts[1].triangles += first;
    v->triangle_of[which + 1] = first;
    v->objects[which].mesh = &parts[0];
    v->objects[which + 1].mesh = &parts[1];
    return 1;
}

/* Moves a number by another. @return 0 where it does not stay within half of its range */
static int move_number(glint_q16 *number, int32_t by) {
    const int64_t moved = (int64_t)*number + by;
    *number = (glint_q16)moved;
    return moved > INT32_MIN / 2 && moved < INT32_MAX / 2;
}

static int move_vector(glint_vector *vector, const int32_t by[3]) {
    return move_number(&vector->x, by[0]) & move_number(&vector->y, by[1]) & move_number(&vector->z, by[2]);
}

/* Moves the camera, objects and lights by up to 4096 units an axis: all that is drawn lies where it lay. */
static int move_all(variant *v, uint32_t choice) {
    const int32_t by[3] = {(int32_t)(choice * 2654435761u) >> 3, (int32_t)(choice * 40503u) >> 4,
                           -((int32_t)(choice * 2246822519u) >> 5)};
    int fits = 1;
    for (int axis = 0; axis < 3; axis++) {
        fits &= move_number(&v->scene.camera.pose.m[axis][3], by[axis]);
        for (uint32_t i = 0; i < v->scene.object_count; i++)
            fits &= move_number(&v->objects[i].pose.m[axis][3], by[axis]);
    }
    for (uint32_t i = 0; i < v->scene.light_count; i++)
        if (v->lights[i].type != &glint_light_directional)
            fits &= move_vector(&v->lights[i].position, by);
    return fits;
}

/* ---- The same but for equal depths ---- */

/* The objects from the last to the first. */
static int turn_order(variant *v, uint32_t choice) {
    const uint32_t count = v->scene.object_count;
    (void)choice;
    for (uint32_t i = 0; i < count / 2; i++) {
        const glint_object object = v->objects[i];
        v->objects[i] = v->objects[count - 1 - i];
        v->objects[count - 1 - i] = object;
    }
    for (uint32_t i = 0; i < count; i++)
        v->object_of[i] = count - 1 - i;
    return count > 1;
}

/* ---- The same but for rounding ---- */

static void halve(glint_colour *one, glint_colour *other) {
    *other = (glint_colour){one->r / 2, one->g / 2, one->b / 2};
    *one = (glint_colour){one->r - other->r, one->g - other->g, one->b - other->b};
}

/* Makes two lights of half the strength of one. */
static int split_light(variant *v, uint32_t choice) {
    const uint32_t count = v->scene.light_count;
    if (count == 0 || count == GLINT_LIGHTS_MAX)
        return 0;
    glint_light *const one = &v->lights[choice % count], *const other = &v->lights[count];
    *other = *one;
    halve(&one->diffuse, &other->diffuse);
    halve(&one->specular, &other->specular);
    v->scene.light_count++;
    return 1;
}

static glint_q16 negated(glint_q16 number) {
    return number == INT32_MIN ? INT32_MAX : -number;
}

static void turn_pose(glint_pose *pose) {
    for (int column = 0; column < 4; column++) {
        const glint_q16 x = pose->m[0][column];
        pose->m[0][column] = pose->m[2][column];
        pose->m[2][column] = negated(x);
    }
}

static void turn_vector(glint_vector *vector) {
    *vector = (glint_vector){vector->z, vector->y, negated(vector->x)};
}

/* Turns the world about y by a right angle, so that x becomes -z. */
static int turn_all(variant *v, uint32_t choice) {
    (void)choice;
    turn_pose(&v->scene.camera.pose);
    for (uint32_t i = 0; i < v->scene.object_count; i++)
        turn_pose(&v->objects[i].pose);
    for (uint32_t i = 0; i < v->scene.light_count; i++) {
        turn_vector(&v->lights[i].position);
        turn_vector(&v->lights[i].direction);
    }
    return 1;
}

/* Mirrors the world at x = 0, and the camera's x axis besides, so that its axes stay right-handed. */
static int mirror_all(variant *v, uint32_t choice) {
    glint_pose *const camera = &v->scene.camera.pose;
    (void)choice;
    v->is_mirrored = 1;
    for (int column = 1; column < 4; column++)
        camera->m[0][column] = negated(camera->m[0][column]);
    for (int row = 1; row < 3; row++)
        camera->m[row][0] = negated(camera->m[row][0]);
    for (uint32_t i = 0; i < v->scene.object_count; i++)
        for (int column = 0; column < 4; column++)
            v->objects[i].pose.m[0][column] = negated(v->objects[i].pose.m[0][column]);
    for (uint32_t i = 0; i < v->scene.light_count; i++) {
        v->lights[i].position.x = negated(v->lights[i].position.x);
        v->lights[i].direction.x = negated(v->lights[i].direction.x);
    }
    return 1;
}

const variant_kind variant_kinds[] = {
    {"a mesh split in two", FREEDOM_NONE, split_mesh},
    {"moved", FREEDOM_NONE, move_all},
    {"objects in another order", FREEDOM_TIES, turn_order},
    {"a light split in two", FREEDOM_LIGHT, split_light},
    {"turned", FREEDOM_ROUNDING, turn_all},
    {"mirrored", FREEDOM_ROUNDING, mirror_all},
};
const unsigned variant_kind_count = sizeof variant_kinds / sizeof variant_kinds[0];

int variant_make(variant *to, const variant_kind *kind, const glint_scene *scene, uint32_t choice) {
    if (scene->object_count >= VARIANT_OBJECTS_MAX)
        abort();
    memset(to, 0, sizeof *to);
    to->scene = *scene;
    to->scene.objects = to->objects;
    to->scene.lights = to->lights;
    memcpy(to->objects, scene->objects, scene->object_count * sizeof *to->objects);
    memcpy(to->lights, scene->lights, scene->light_count * sizeof *to->lights);
    for (uint32_t i = 0; i < scene->object_count; i++)
        to->object_of[i] = i;
    return kind->change(to, choice);
}
