/* SPDX-License-Identifier: MIT */
/*
 * Load: the vertices of a pass. Whole objects as long as the arena holds them; an object too large for the arena
 * goes in runs of triangles, each with an index list of its own.
 */
#include "../light/evaluation.h"
#include "../pixel/format.h"
#include "cull.h"
#include "frame.h"

static const glint_evaluation *evaluation_of(const glint_object *object) {
    return object->evaluation ? object->evaluation : &glint_per_fragment;
}

static int is_fast(const glint_frame *frame, const glint_object *object) {
    const glint_fast *fast = frame->config.format->fast;
    return fast && fast->serves(frame, object);
}

/* What a draw keeps beyond its vertices. */
static int keeps_positions(const glint_object *object, const glint_transform *transform) {
    return transform->clips || evaluation_of(object)->lit_at != GLINT_LIT_AT_FRAGMENTS;
}

static int has_colours(const glint_mesh *mesh) {
    return mesh->colours || mesh->colours565;
}

static int keeps_extra(const glint_object *object) {
    const glint_evaluation *evaluation = evaluation_of(object);
    return has_colours(object->mesh) ||
           (evaluation->lit_at == GLINT_LIT_AT_VERTICES && (object->mesh->flags & GLINT_MESH_DOUBLE_SIDED) != 0);
}

size_t glint_draw_size(const glint_frame *frame, const glint_object *object, const glint_transform *transform,
                       size_t vertices, size_t triangles, int has_list) {
    size_t size = GLINT_ALIGNED(sizeof(glint_draw)) + GLINT_ALIGNED(vertices * sizeof(glint_vertex));
    if (keeps_positions(object, transform))
        size += GLINT_ALIGNED(vertices * sizeof(glint_position));
    if (keeps_extra(object) || is_fast(frame, object))
        size += GLINT_ALIGNED(vertices * 3 * sizeof(int16_t));
    if (evaluation_of(object)->lit_at == GLINT_LIT_AT_FACETS)
        size += GLINT_ALIGNED(triangles * 3 * sizeof(int16_t));
    if (evaluation_of(object)->nodes)
        size += GLINT_ALIGNED(vertices * glint_shading_of(frame, object->material)->node_size);
    size_t more = triangles * 3 * sizeof(uint16_t);
    if (!has_list)
        more = glint_cull_of(object->mesh) ? object->mesh->clusters->count : 0;
    return size + GLINT_ALIGNED(more);
}

/* Does nothing light an object, nor give it colours? */
static int is_of_one_colour(const glint_object *object, const glint_shading *shading) {
    return !has_colours(object->mesh) && (!object->material->model->light || !shading->lights);
}

/* A draw at the end of the list, with room for so many vertices and triangles; the arena has it. */
static glint_draw *add_draw(glint_frame *frame, glint_draw *last, const glint_transform *transform, uint32_t vertices,
                            uint32_t triangles) {
    const glint_object *object = &frame->scene->objects[frame->object];
    const glint_evaluation *evaluation = evaluation_of(object);
    glint_draw *draw = glint_take(&frame->memory, sizeof *draw);
    *draw = (glint_draw){0};
    draw->vertices = glint_take(&frame->memory, vertices * sizeof *draw->vertices);
    if (keeps_positions(object, transform))
        draw->positions = glint_take(&frame->memory, vertices * sizeof *draw->positions);
    if (keeps_extra(object))
        draw->extra = glint_take(&frame->memory, vertices * sizeof *draw->extra);
    if (evaluation->lit_at == GLINT_LIT_AT_FACETS)
        draw->facets = glint_take(&frame->memory, triangles * sizeof *draw->facets);
    draw->evaluation = evaluation;
    draw->light = evaluation->light;
    draw->kernel = evaluation->kernel;
    if (is_fast(frame, object)) {
        draw->terms = glint_take(&frame->memory, vertices * sizeof *draw->terms);
        draw->light = frame->config.format->fast->light;
        draw->kernel = frame->config.format->fast->draw;
    }
    draw->shading = glint_shading_of(frame, object->material);
    if (evaluation->nodes)
        draw->nodes = glint_take(&frame->memory, vertices * draw->shading->node_size);
    if (!GLINT_SMALL && is_of_one_colour(object, draw->shading)) {
        draw->light = 0;
        draw->kernel = glint_draw_unlit;
    }
    draw->object = frame->object;
    draw->first_triangle = frame->triangle;
    draw->first = last ? (uint16_t)(last->first + last->count) : 0;
    draw->transform = *transform;
    draw->cull = glint_cull_of(object->mesh);
    draw->normals = object->mesh->normals;
    draw->mirrored = transform->mirrored;
    draw->double_sided = (object->mesh->flags & GLINT_MESH_DOUBLE_SIDED) != 0;
    draw->triangles = object->mesh->triangles + frame->triangle;
    if (last)
        last->next = draw;
    else
        frame->draws = draw;
    return draw;
}

/* A vertex's own colour, 1 = GLINT_COLOUR_ONE. */
static void load_colour(const glint_mesh *mesh, uint32_t index, int16_t out[3]) {
    const uint32_t packed = mesh->colours565 ? mesh->colours565[index] : 0;
    const uint8_t *level = mesh->colours ? mesh->colours[index] : 0;
    for (int c = 0; c < 3; c++) /* factors: 2^15 over the highest level, Q8 */
        if (level)
            out[c] = (int16_t)(level[c] * 32896u >> 8);
        else
            out[c] = (int16_t)(c == 1 ? (packed >> 5 & 63) * 133152u >> 8 : (packed >> (c ? 0 : 11) & 31) * 1057u);
}

void glint_load_vertices(glint_frame *frame, glint_draw *draw, uint32_t index, uint32_t slot, uint32_t count) {
    const glint_mesh *mesh = frame->scene->objects[draw->object].mesh;
    glint_transform_vertices(&draw->transform, mesh, index, count, &draw->vertices[slot],
                             draw->positions ? &draw->positions[slot] : 0);
    frame->stats.vertices += count;
    if (!draw->extra || !has_colours(mesh))
        return;
    for (uint32_t i = 0; i < count; i++)
        load_colour(mesh, index + i, draw->extra[slot + i]);
}

/* All of an object from the present triangle on. @return 0 when the arena is too full. */
static int load_whole(glint_frame *frame, glint_draw *last, const glint_transform *transform) {
    const glint_object *object = &frame->scene->objects[frame->object];
    const glint_mesh *mesh = object->mesh;
    uint32_t numbered = last ? (uint32_t)last->first + last->count : 0;
    uint32_t count = mesh->triangle_count - frame->triangle;
    size_t size = glint_draw_size(frame, object, transform, mesh->vertex_count, count, 0) + GLINT_BIN_RESERVE;
    if (size > frame->memory.high - GLINT_ALIGNED(frame->memory.low) || numbered + count > GLINT_TRIANGLES_MAX)
        return 0;
    glint_draw *draw = add_draw(frame, last, transform, mesh->vertex_count, count);
    draw->vertex_count = mesh->vertex_count;
    draw->count = (uint16_t)count;
    if (draw->cull)
        draw->cull->load(frame, draw, mesh);
    else
        glint_load_vertices(frame, draw, 0, 0, mesh->vertex_count);
    return 1;
}

/* Twice as many triangles still fit a draw. */
#define RUN_VERTICES_MAX 0x6000

/* Vertices of a run, found by their index in the mesh: open addressing. */
typedef struct slots {
    uint16_t *map, *index; /* slot + 1 or 0; mesh index of a slot */
    uint32_t mask, count, limit;
} slots;

/* The slot of a mesh's vertex; `limit` when it is new and there is no room. */
static uint32_t find_slot(slots *s, uint32_t index, int *is_new) {
    uint32_t place = (index * 40503u) & s->mask;
    for (; s->map[place]; place = (place + 1) & s->mask)
        if (s->index[s->map[place] - 1] == index)
            return s->map[place] - 1u;
    if (s->count == s->limit)
        return s->limit;
    *is_new = 1;
    s->index[s->count] = (uint16_t)index;
    s->map[place] = (uint16_t)(s->count + 1);
    return s->count++;
}

/* Bytes that a run of so many vertices and twice as many triangles takes; map_size: a power of two above them. */
static size_t run_size(const glint_frame *frame, const glint_object *object, const glint_transform *transform,
                       uint32_t vertices, uint32_t *map_size) {
    *map_size = 4;
    while (*map_size <= vertices)
        *map_size *= 2;
    return glint_draw_size(frame, object, transform, vertices, 2 * (size_t)vertices, 1) +
           GLINT_ALIGNED(*map_size * sizeof(uint16_t)) + GLINT_ALIGNED(vertices * sizeof(uint16_t));
}

/* Most vertices of a run that the arena holds. */
static uint32_t run_capacity(const glint_frame *frame, const glint_transform *transform, uint32_t *map_size) {
    const glint_object *object = &frame->scene->objects[frame->object];
    size_t room = frame->memory.high - GLINT_ALIGNED(frame->memory.low);
    if (room < GLINT_BIN_RESERVE)
        return 0;
    room -= GLINT_BIN_RESERVE;
    uint32_t vertices = room / 34 < RUN_VERTICES_MAX ? (uint32_t)(room / 34) : RUN_VERTICES_MAX;
    while (vertices && run_size(frame, object, transform, vertices, map_size) > room)
        vertices -= (vertices + 15) / 16;
    return vertices;
}

/* Adds triangles to a run until its vertices or its list are full. */
static glint_status fill_run(glint_frame *frame, glint_draw *draw, slots *s, uint16_t (*list)[3]) {
    const glint_mesh *mesh = frame->scene->objects[draw->object].mesh;
    const glint_cull *cull = draw->cull;
    glint_walk walk;
    if (cull)
        cull->begin(&walk, mesh, &draw->transform);
    while (draw->count < 2 * s->limit && s->limit - s->count >= 3) {
        const uint32_t number = draw->first_triangle + draw->count;
        if (number >= mesh->triangle_count)
            break;
        const uint16_t *triangle = cull ? cull->corners(&walk, mesh, number) : mesh->triangles[number];
        for (int i = 0; i < 3; i++) {
            int is_new = 0;
            if (triangle[i] >= mesh->vertex_count)
                return GLINT_ERROR_INDEX;
            uint32_t slot = find_slot(s, triangle[i], &is_new);
            if (is_new)
                glint_load_vertices(frame, draw, triangle[i], slot, 1);
            list[draw->count][i] = (uint16_t)slot;
        }
        draw->count++;
    }
    draw->vertex_count = s->count;
    return GLINT_OK;
}

static glint_status load_run(glint_frame *frame, const glint_transform *transform) {
    glint_memory *memory = &frame->memory;
    uint32_t map_size = 0, vertices = run_capacity(frame, transform, &map_size);
    if (vertices < 3)
        return GLINT_ERROR_ARENA;
    glint_draw *draw = add_draw(frame, 0, transform, vertices, 2 * vertices);
    slots s = {0, 0, map_size - 1, 0, vertices};
    uint16_t(*list)[3] = glint_take(memory, vertices * 2 * sizeof *list);
    size_t end = memory->low; /* what follows is needed only while the run is filled */
    s.map = glint_take(memory, map_size * sizeof *s.map);
    s.index = glint_take(memory, vertices * sizeof *s.index);
    for (uint32_t i = 0; i < map_size; i++)
        s.map[i] = 0;
    glint_status status = fill_run(frame, draw, &s, list);
    draw->triangles = (const uint16_t(*)[3])list;
    memory->low = end;
    return status;
}

/* Loading leaves room for that much, and binning has not begun. */
typedef char glint_last_transform_stays[sizeof(glint_transform) <= GLINT_BIN_RESERVE ? 1 : -1];

/* The present object's transform. */
static void find_transform(const glint_frame *frame, glint_transform *transform) {
    const int is_first_load = !frame->vertices_end;
    if (is_first_load && frame->object + 1 == frame->scene->object_count) {
        *transform = *glint_last_transform(frame);
        glint_transform_place(transform, frame->view);
    } else {
        glint_transform_prepare(transform, frame->view, &frame->config, &frame->scene->objects[frame->object]);
    }
}

glint_status glint_load(glint_frame *frame) {
    uint32_t object = frame->object, triangle = frame->triangle;
    glint_draw *last = 0;
    glint_status status = GLINT_OK;
    frame->draws = 0;
    frame->memory.low = frame->prepared_end;
    for (; frame->object < frame->scene->object_count; frame->object++, frame->triangle = 0) {
        glint_transform transform;
        find_transform(frame, &transform);
        if (!transform.visible) {
            frame->stats.hidden++;
            continue;
        }
        if (load_whole(frame, last, &transform)) {
            last = last ? last->next : frame->draws;
            continue;
        }
        if (!last)
            status = load_run(frame, &transform);
        break;
    }
    frame->covers_end = frame->object == frame->scene->object_count;
    frame->resident = frame->covers_end && object == 0 && triangle == 0;
    frame->object = object;
    frame->triangle = triangle;
    frame->vertices_end = frame->memory.low;
    return status;
}
