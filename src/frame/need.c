/* SPDX-License-Identifier: MIT */
/*
 * Need: goes through a scene as a pass would, with no arena at all, and counts what it would take. What is large on the
 * stack is out of line, so that it is not there at the same time.
 */
#include "../light/corners.h"
#include "../light/evaluation.h"
#include "../pixel/format.h"
#include "frame.h"

/* Holds what the parts of a scene add up to. */
typedef struct need_tally {
    size_t vertices, references, clipped; /* bytes, counts */
    size_t of_quarter[4];                 /* references in each quarter of the tiles */
    size_t materials, tables;             /* bytes */
} need_tally;

/* Counts references in each quarter of the tiles, of a triangle that may touch those from `first` to before `end`. */
static void count_row(const glint_frame *frame, int32_t first, int32_t end, need_tally *sum) {
    const int32_t quarter = (int32_t)glint_quarter_of_tiles(frame);
    for (int32_t i = 0; i < 4; i++) {
        const int32_t inside = glint_least(end, (i + 1) * quarter) - glint_most(first, i * quarter);
        sum->of_quarter[i] += (size_t)glint_most(inside, 0);
    }
}

static void count_part(const glint_frame *frame, const glint_transform *transform, const glint_mesh *mesh,
                       const glint_vertex *const v[3], int clipped, need_tally *sum) {
    glint_range range;
    int double_sided = (mesh->flags & GLINT_MESH_DOUBLE_SIDED) != 0;
    if (!glint_faces(transform->mirrored, double_sided, v) || !glint_find_tiles(frame, v, &range))
        return;
    sum->references += (size_t)((range.right - range.left) * (range.bottom - range.top));
    for (int32_t row = range.top; row < range.bottom; row++)
        count_row(frame, row * frame->tile_columns + range.left, row * frame->tile_columns + range.right, sum);
    sum->clipped += (size_t)clipped;
}

static GLINT_NOINLINE glint_status count_triangle(const glint_frame *frame, const glint_transform *transform,
                                                  const glint_mesh *mesh, const uint16_t *indices, need_tally *sum) {
    glint_vertex vertices[GLINT_CLIP_CORNERS];
    glint_corner corners[GLINT_CLIP_CORNERS] = {0};
    uint32_t flags = 0;
    int count = 3, clips = transform->clips;
    for (int i = 0; i < 3; i++) {
        if (indices[i] >= mesh->vertex_count)
            return GLINT_ERROR_INDEX;
        glint_transform_vertices(transform, mesh, indices[i], 1, &vertices[i], clips ? &corners[i].position : 0);
        flags |= vertices[i].flags;
    }
    clips = (flags & GLINT_VERTEX_CLIP) != 0;
    if (clips) {
        count = glint_clip(transform, corners);
        for (int i = 0; i < count; i++)
            glint_project(transform, &corners[i].position, &vertices[i]);
    }
    for (int i = 2; i < count; i++) {
        const glint_vertex *const part[3] = {&vertices[0], &vertices[i - 1], &vertices[i]};
        count_part(frame, transform, mesh, part, clips, sum);
    }
    return GLINT_OK;
}

/* Bytes of a draw of all of an object, whose material is prepared for it. */
static GLINT_NOINLINE size_t size_object(glint_frame *frame, const glint_object *object,
                                         const glint_transform *transform) {
    const glint_mesh *mesh = object->mesh;
    glint_shading shading = {0};
    glint_prepare_shading(frame, &shading, object->material);
    frame->shading = &shading;
    const size_t size = glint_draw_size(frame, object, transform, mesh->vertex_count, mesh->triangle_count, 0);
    frame->shading = 0;
    return size;
}

static glint_status count_object(glint_frame *frame, const glint_object *object, need_tally *sum) {
    const glint_mesh *mesh = object->mesh;
    const glint_cull *cull = glint_cull_of(mesh);
    glint_transform transform;
    glint_walk walk;
    glint_transform_prepare(&transform, frame->view, &frame->config, object); /* the view had no error */
    glint_transform_place(&transform, frame->view);
    if (!transform.visible)
        return GLINT_OK;
    glint_status status = GLINT_OK;
    sum->vertices += size_object(frame, object, &transform);
    if (cull)
        cull->begin(&walk, mesh, &transform);
    for (uint32_t i = 0; i < mesh->triangle_count && status == GLINT_OK; i++) {
        const uint16_t *corners = cull ? cull->corners(&walk, mesh, i) : glint_corners_of(&walk, mesh, i);
        status = count_triangle(frame, &transform, mesh, corners, sum);
    }
    return status;
}

/* Bytes of distinct materials, each checked. */
static GLINT_NOINLINE glint_status count_materials(glint_frame *frame, need_tally *sum) {
    const glint_scene *scene = frame->scene;
    const glint_suns_stage *suns = glint_find_suns(scene);
    glint_shading shading;
    glint_status status = GLINT_OK;
    for (uint32_t i = 0; i < scene->object_count && status == GLINT_OK; i++) {
        uint32_t earlier = 0;
        while (scene->objects[earlier].material != scene->objects[i].material)
            earlier++;
        if (earlier < i)
            continue;
        shading = (glint_shading){0};
        status = glint_prepare_shading(frame, &shading, scene->objects[i].material);
        sum->materials += GLINT_ALIGNED(sizeof shading);
        if (suns && status == GLINT_OK)
            suns->need(frame, &shading, &sum->materials, &sum->tables);
    }
    return status;
}

/* Bytes of the lists of so many tiles, and of all clipped triangles. */
static size_t size_lists(const need_tally *sum, size_t tiles, size_t references) {
    return GLINT_ALIGNED(tiles * sizeof(glint_reference)) + GLINT_ALIGNED(references * sizeof(glint_reference)) +
           GLINT_ALIGNED(sum->clipped * sizeof(glint_clipped)) + GLINT_BIN_RESERVE;
}

static size_t larger_of(size_t a, size_t b) {
    return a > b ? a : b;
}

/* Checks a scene, all but its meshes' indices, prepares frame and view, and begins a tally with the materials. */
static GLINT_NOINLINE glint_status begin_need(glint_frame *frame, glint_view *view, const glint_config *config,
                                              const glint_scene *scene, need_tally *sum) {
    glint_transform transform;
    glint_status status = glint_frame_grid(frame, config, scene);
    *sum = (need_tally){0};
    if (status == GLINT_OK)
        status = glint_check_scene(config, scene);
    if (status == GLINT_OK)
        status = glint_prepare_view(view, &frame->config, scene, &transform, 1);
    frame->view = view;
    if (status == GLINT_OK)
        status = count_materials(frame, sum);
    return status;
}

/* Sets the bytes that a tally of all objects comes to. */
static void finish_need(const glint_frame *frame, const need_tally *sum, glint_need *need) {
    const size_t prepared = GLINT_ALIGNMENT - 1 + glint_tile_buffers_size(&frame->config) +
                            GLINT_ALIGNED(glint_view_size(frame->scene)) +
                            GLINT_ALIGNED(glint_corners_size(frame->scene)) + sum->materials;
    const size_t behind = sum->tables ? glint_room_behind_tables(sum->tables) : 0;
    const size_t quarter = size_lists(sum, glint_quarter_of_tiles(frame),
                                      larger_of(larger_of(sum->of_quarter[0], sum->of_quarter[1]),
                                                larger_of(sum->of_quarter[2], sum->of_quarter[3])));
    const size_t lists = size_lists(sum, frame->tile_count, sum->references);
    need->least = prepared + GLINT_LEAST_ROOM;
    need->resident = larger_of(prepared + sum->tables + larger_of(sum->vertices + quarter, behind), need->least);
    need->one_pass = prepared + sum->tables + larger_of(sum->vertices + lists, behind);
    need->one_pass = larger_of(need->one_pass, need->resident);
}

glint_status glint_arena_need(const glint_config *config, const glint_scene *scene, glint_need *need) {
    if (!config || !scene || !need)
        return GLINT_ERROR_NULL;
    glint_frame frame;
    glint_whole_view whole;
    need_tally sum;
    glint_status status = begin_need(&frame, &whole.view, config, scene, &sum);
    for (uint32_t i = 0; i < scene->object_count && status == GLINT_OK; i++)
        status = count_object(&frame, &scene->objects[i], &sum);
    if (status == GLINT_OK)
        finish_need(&frame, &sum, need);
    return status;
}
