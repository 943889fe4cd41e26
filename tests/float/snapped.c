/* SPDX-License-Identifier: MIT */
#include "snapped.h"

#include "draw.h"
#include "workloads.h"

#include <math.h>
#include <stdlib.h>

static reference_position position_of(const float_vertex *vertex) {
    const double column = 0.5 - 1.0 / 4096; /* what a vertex's x is shifted by */

    return (reference_position){(int32_t)lrint(16 * (vertex->x - column)), (int32_t)lrint(16 * (double)vertex->y),
                                vertex->inverse_w > 0};
}

/* @return an array of the object's positions, the caller's to free; null when none of it can be seen */
static reference_position *snap(const float_frame *frame, const glint_object *object) {
    static float_draw draw;
    const uint32_t count = object->mesh->vertex_count;
    reference_position *positions = malloc(count * sizeof *positions);

    draw = (float_draw){.frame = frame, .object = object, .side = 1};
    float_prepare_object(&draw);
    const float_whereabouts where = float_locate(&draw);
    if (where == FLOAT_OUTSIDE || !positions) {
        free(positions);
        return NULL;
    }
    float_transform(&draw, where);
    for (uint32_t i = 0; i < count; i++)
        positions[i] = position_of(&frame->memory->vertices[i]);
    return positions;
}

void float_draw_reference(const float_screen *screen, float_memory *memory, const glint_scene *scene,
                          reference_pixel *exact) {
    const reference_image image = {(int)screen->width, (int)screen->height, exact};
    static reference_position *positions[BOXES_MAX];
    float_frame frame = {.screen = screen, .memory = memory, .scene = scene};

    if (scene->object_count > BOXES_MAX)
        abort();
    float_prepare_frame(&frame);
    for (uint32_t i = 0; i < scene->object_count; i++)
        positions[i] = snap(&frame, &scene->objects[i]);
    reference_render(&image, scene, (const reference_position *const *)positions);
    for (uint32_t i = 0; i < scene->object_count; i++)
        free(positions[i]);
}
