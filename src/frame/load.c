/* SPDX-License-Identifier: MIT */
/* Loads the vertices of a frame's objects, where the arena holds them all; else parts.c loads parts of them. */
#include "../blend/blend.h"
#include "../light/evaluation.h"
#include "../light/wear.h"
#include "../pixel/format.h"
#include "frame.h"

/* Compilers call this even in freestanding code; here the library does. */
void *memset(void *bytes, int value, size_t size);

/* Returns the evaluation that lights an object. */
static const glint_evaluation *evaluation_of(const glint_frame *frame, const glint_object *object) {
    static const glint_evaluation of_one_colour = {.lit_at = GLINT_LIT_AT_FRAGMENTS};
    const glint_suns_stage *suns = glint_find_suns(frame->scene);
    if (suns && suns->serves(frame, glint_shading_of(frame, object->material), object))
        return suns->evaluation;
    return object->evaluation ? object->evaluation : &of_one_colour;
}

/* Does a draw keep more than its vertices? */
static int keeps_extra(const glint_evaluation *evaluation, const glint_object *object) {
    return glint_has_colours(object->mesh) ||
           (evaluation->lit_at == GLINT_LIT_AT_VERTICES && (object->mesh->flags & GLINT_MESH_DOUBLE_SIDED) != 0);
}

/* Returns the bytes that a vertex keeps of lights. */
static size_t terms_size(const glint_frame *frame, const glint_object *object, const glint_evaluation *evaluation) {
    return evaluation->vertex_size ? evaluation->vertex_size(glint_shading_of(frame, object->material)) : 0;
}

size_t glint_draw_size(const glint_frame *frame, const glint_object *object, int clips, size_t vertices,
                       size_t triangles, int has_list) {
    const glint_evaluation *evaluation = evaluation_of(frame, object);
    size_t size = GLINT_ALIGNED(sizeof(glint_draw)) + GLINT_ALIGNED(vertices * sizeof(glint_vertex));
    if (clips)
        size += GLINT_ALIGNED(vertices * sizeof(glint_position));
    if (keeps_extra(evaluation, object))
        size += GLINT_ALIGNED(vertices * 3 * sizeof(int16_t));
    size += GLINT_ALIGNED(vertices * terms_size(frame, object, evaluation));
    if (evaluation->lit_at == GLINT_LIT_AT_FACETS)
        size += GLINT_ALIGNED(triangles * 3 * sizeof(int16_t));
    if (!has_list && glint_cull_of(object->mesh))
        size += GLINT_ALIGNED(object->mesh->clusters->count);
    if (has_list || !object->mesh->triangles)
        size += GLINT_ALIGNED(triangles * 3 * sizeof(uint16_t));
    return size;
}

/* Finds lights that do not reach an object. */
static uint32_t find_unreached(const glint_frame *frame, const glint_object *object, uint32_t lights) {
    uint32_t unreached = 0;
    for (uint32_t i = 0; lights >> i; i++) {
        const glint_light *const light = &frame->scene->lights[i];
        if (lights >> i & 1 && light->type->misses &&
            light->type->misses(light, &frame->view->lights[i], frame->view, object))
            unreached |= 1u << i;
    }
    return unreached;
}

/* Does an object have one colour, as nothing lights it and its mesh has no colours? */
static int is_of_one_colour(const glint_object *object, const glint_draw *draw) {
    return !glint_has_colours(object->mesh) &&
           (!object->material->model->is_lit || !(draw->shading->lights & ~draw->unreached));
}

/* Sets the one colour of an object. It is the last object's where both have one material. */
static void set_flat(const glint_frame *frame, glint_draw *draw, const glint_draw *last) {
    int32_t colour[3];
    if (last && last->shading == draw->shading && !last->light) {
        draw->flat = last->flat;
        draw->packed = last->packed;
        return;
    }
    glint_channels_of(draw->shading->ambient, colour);
    draw->flat = glint_flat_lanes(&frame->config, colour);
    draw->packed = glint_pack(frame->config.format, draw->flat);
}

glint_draw *glint_add_draw(glint_frame *frame, glint_draw *last, const glint_transform *transform, uint32_t vertices,
                           uint32_t triangles, size_t list) {
    const glint_object *object = glint_object_at(frame, frame->object);
    const glint_evaluation *evaluation = evaluation_of(frame, object);
    glint_draw *draw = glint_take(&frame->memory, sizeof *draw);
    memset(draw, 0, offsetof(glint_draw, triangles));
    frame->memory.low += list;
    draw->vertices = glint_take(&frame->memory, vertices * sizeof *draw->vertices);
    if (transform->clips)
        draw->positions = glint_take(&frame->memory, vertices * sizeof *draw->positions);
    if (keeps_extra(evaluation, object))
        draw->extra = glint_take(&frame->memory, vertices * sizeof *draw->extra);
    if (evaluation->lit_at == GLINT_LIT_AT_FACETS)
        draw->facets = glint_take(&frame->memory, triangles * sizeof *draw->facets);
    draw->terms = glint_take(&frame->memory, vertices * terms_size(frame, object, evaluation));
    draw->evaluation = evaluation;
    draw->light = evaluation->light;
    draw->double_sided = (object->mesh->flags & GLINT_MESH_DOUBLE_SIDED) != 0;
    draw->shading = glint_shading_of(frame, object->material);
    draw->unreached = find_unreached(frame, object, draw->shading->lights);
    if (is_of_one_colour(object, draw)) {
        draw->light = 0;
        set_flat(frame, draw, last);
    }
    draw->texture = object->material->texture;
    draw->draw_triangle = frame->config.layers ? frame->config.layers->draw : glint_drawer_of(frame, draw);
    draw->fragments = draw->light && evaluation->is_costly ? GLINT_ARE_COSTLY : 0;
    if (frame->has_long_slopes && draw->light && !draw->texture && evaluation->lit_at == GLINT_LIT_AT_FRAGMENTS)
        draw->fragments |= GLINT_HAVE_LONG_SLOPES;
    draw->object = frame->object;
    draw->first_triangle = frame->triangle;
    draw->first = last ? (uint16_t)(last->first + last->count) : 0;
    draw->transform = *transform;
    if (draw->light)
        glint_transform_begin_normals(&draw->transform, frame->view, &object->pose);
    draw->cull = glint_cull_of(object->mesh);
    draw->normals = object->mesh->normals;
    if (!draw->normals && draw->light && evaluation->lit_at == GLINT_LIT_AT_FRAGMENTS)
        draw->light = object->mesh->layout->normals.type->stage->light;
    draw->mirrored = transform->mirrored;
    draw->is_wide = glint_transform_is_wide(transform);
    frame->has_costly = !GLINT_SMALL && ((draw->fragments & GLINT_ARE_COSTLY) || (last && frame->has_costly));
    if (last)
        last->next = draw;
    else
        frame->draws = draw;
    return draw;
}

/* Loads the colours of a mesh's vertices from `index` on, where it has any, 1 = GLINT_COLOUR_ONE. The first of two
 * arrays counts. */
static GLINT_NOINLINE void load_colours(const glint_mesh *mesh, uint32_t index, uint32_t count, int16_t (*to)[3]) {
    const uint8_t(*const level)[3] = mesh->colours;
    const uint16_t *const packed = mesh->colours565;
    if (!level && !packed) {
        if (glint_has_colours(mesh))
            glint_fetch(&mesh->layout->colours, index, count, to);
        return;
    }
    for (const uint32_t end = index + count; index < end; index++, to++)
        for (int c = 0; c < 3; c++)
            (*to)[c] = level ? glint_channel_from8(level[index][c]) : glint_channel_from565(packed[index], c);
}

void glint_load_vertices(glint_frame *frame, glint_draw *draw, const glint_mesh *mesh, uint32_t index, uint32_t slot,
                         uint32_t count) {
    frame->stats.vertices += count;
    if (draw->positions) {
        glint_transform_vertices(&draw->transform, mesh, index, count, &draw->vertices[slot], &draw->positions[slot]);
        if (draw->transform.clips & GLINT_PARALLEL)
            frame->scene->camera.projection->finish(frame->view, &draw->transform, &draw->vertices[slot], count);
    } else {
        glint_transform_vertices(&draw->transform, mesh, index, count, &draw->vertices[slot], 0);
    }
    if (draw->extra)
        load_colours(mesh, index, count, &draw->extra[slot]);
}

/* Loads all of an object. @return 0 when the arena is too full */
static int load_whole(glint_frame *frame, glint_draw *last, const glint_transform *transform) {
    const glint_object *object = glint_object_at(frame, frame->object);
    const glint_mesh *mesh = object->mesh;
    const uint32_t numbered = last ? (uint32_t)last->first + last->count : 0, count = mesh->triangle_count;
    const size_t size =
        glint_draw_size(frame, object, transform->clips, mesh->vertex_count, count, 0) + GLINT_BIN_RESERVE;
    if (size > frame->memory.high - GLINT_ALIGNED(frame->memory.low) || numbered + count > GLINT_TRIANGLES_MAX)
        return 0;
    glint_draw *draw = glint_add_draw(frame, last, transform, mesh->vertex_count, count, 0);
    draw->vertex_count = mesh->vertex_count;
    draw->count = (uint16_t)count;
    draw->end = count;
    draw->triangles = mesh->triangles ? mesh->triangles : mesh->layout->triangles.type->stage->list(frame, mesh);
    if (draw->cull)
        draw->cull->load(frame, draw, mesh);
    else
        glint_load_vertices(frame, draw, mesh, 0, 0, mesh->vertex_count);
    return 1;
}

/* Loading leaves room for the last transform, and binning has not begun. */
typedef char glint_last_transform_stays[sizeof(glint_transform) <= GLINT_BIN_RESERVE ? 1 : -1];

/* Finds the present object's transform. */
static void find_transform(const glint_frame *frame, glint_transform *transform) {
    const uint32_t behind = frame->scene->object_count - 1 - frame->object;
    const uint8_t *const taken = frame->memory.base + frame->memory.low;
    if (!frame->order && (!behind || (!GLINT_SMALL && behind < frame->waiting &&
                                      (const uint8_t *)(glint_last_transform(frame) - behind) >= taken))) {
        *transform = *(glint_last_transform(frame) - behind);
    } else {
        glint_transform_prepare(transform, frame->view, &frame->config, glint_object_at(frame, frame->object));
    }
    if (transform->visible)
        glint_transform_place(transform, frame->view);
}

/* Loads all objects. This is out of line, so that no transform is on the stack while parts are loaded. @return 0 when
 * the arena is too small for them */
static GLINT_NOINLINE int load_all(glint_frame *frame) {
    glint_draw *last = 0;
    for (; frame->object < frame->scene->object_count; frame->object++) {
        glint_transform transform;
        find_transform(frame, &transform);
        if (!transform.visible) {
            frame->stats.hidden++;
            continue;
        }
        if (!load_whole(frame, last, &transform))
            return 0;
        last = last ? last->next : frame->draws;
    }
    return 1;
}

glint_status glint_load(glint_frame *frame) {
    if (!frame->vertices_end) {
        frame->resident = (uint8_t)load_all(frame);
        frame->object = 0;
        frame->vertices_end = frame->memory.low;
        if (frame->resident) {
            frame->covers_end = 1;
            frame->loaded_end = frame->tile_count;
            return GLINT_OK;
        }
    }
    return glint_load_parts(frame);
}
