/* SPDX-License-Identifier: MIT */
#include "library_geometry.h"

#include "geometry/geometry.h"
#include "glint_extras.h"

#include <stdlib.h>

/* Of parallel rays. */
static double find_farthest(const glint_view *view, const glint_projection *projection) {
    int64_t farthest = 0, range;
    if (projection)
        projection->get_range(view, &farthest, &range);
    return (double)farthest / (1 << 28);
}

/* view->nearest is the w, in Q28, that 1/w is scaled to: at it, depth is 2^16. */
static double depth_scale(const glint_view *view, const glint_projection *projection) {
    const int64_t unit = (int64_t)1 << 28; /* of parallel rays, depth is linear */
    if (projection)
        return (double)(projection->depth_at(view, unit) - projection->depth_at(view, 2 * unit)) / 32768;
    return (double)view->nearest / (1 << 28) * 65536;
}

static glint_status transform_object(library_geometry *geometry, const glint_frame *frame, uint32_t index) {
    const glint_object *object = &frame->scene->objects[index];
    const glint_mesh *mesh = object->mesh;
    reference_position *positions = calloc(mesh->vertex_count, sizeof *positions);
    glint_transform transform;
    glint_status status = glint_transform_prepare(&transform, frame->view, &frame->config, object);
    geometry->positions[index] = positions;
    glint_transform_place(&transform, frame->view);
    if (positions == NULL || status != GLINT_OK)
        return positions == NULL ? GLINT_ERROR_NULL : status;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        glint_vertex vertex;
        glint_position clip;
        glint_transform_vertices(&transform, mesh, i, 1, &vertex, &clip);
        positions[i] = (reference_position){vertex.x, vertex.y, !(vertex.flags & GLINT_VERTEX_CLIP)};
    }
    return GLINT_OK;
}

static glint_status transform_scene(library_geometry *geometry, const glint_config *config, const glint_scene *scene) {
    glint_frame frame;
    glint_status status = glint_frame_begin(&frame, config, scene);
    if (status != GLINT_OK)
        return status;
    geometry->depth_scale = depth_scale(frame.view, scene->camera.projection);
    geometry->farthest = find_farthest(frame.view, scene->camera.projection);
    geometry->object_count = scene->object_count;
    for (uint32_t i = 0; i < scene->object_count && status == GLINT_OK; i++)
        status = transform_object(geometry, &frame, i);
    return status;
}

glint_status library_geometry_open(library_geometry *geometry, const glint_config *config, const glint_scene *scene) {
    glint_config local = *config;
    glint_need need;
    *geometry = (library_geometry){0};
    if (scene->object_count > LIBRARY_OBJECTS_MAX)
        return GLINT_ERROR_RANGE;
    glint_status status = glint_arena_need(&local, scene, &need);
    if (status != GLINT_OK)
        return status;
    local.arena_size = need.one_pass;
    local.arena = malloc(need.one_pass);
    status = local.arena ? transform_scene(geometry, &local, scene) : GLINT_ERROR_NULL;
    free(local.arena);
    return status;
}

void library_geometry_close(library_geometry *geometry) {
    for (uint32_t i = 0; i < LIBRARY_OBJECTS_MAX; i++)
        free(geometry->positions[i]);
    *geometry = (library_geometry){0};
}
