/* SPDX-License-Identifier: MIT */
/*
 * Goes through a scene as a pass would, without an arena, and counts what a pass would use. What is large on the stack
 * is out of line, so that it is not there at the same time.
 */
#include "../blend/blend.h"
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

/* Counts references to a triangle that may touch some tiles: all, and those in each quarter of the frame's tiles. */
static void count_references(const glint_frame *frame, const glint_range *range, need_tally *sum) {
    const int32_t quarter = (int32_t)glint_quarter_of_tiles(frame);
    sum->references += (size_t)((range->right - range->left) * (range->bottom - range->top));
    for (int32_t row = range->top; row < range->bottom; row++) {
        const int32_t first = row * frame->tile_columns + range->left, end = first + range->right - range->left;
        for (int32_t i = 0; i < 4; i++) {
            const int32_t inside = glint_least(end, (i + 1) * quarter) - glint_most(first, i * quarter);
            sum->of_quarter[i] += (size_t)glint_most(inside, 0);
        }
    }
}

/* ---- What is prepared ---- */

/* Finds whether an object is visible, and whether it may be clipped. */
static GLINT_NOINLINE int is_object_visible(const glint_frame *frame, const glint_object *object, int *clips) {
    glint_transform transform;
    glint_transform_prepare(&transform, frame->view, &frame->config, object); /* the view met no error */
    *clips = transform.clips;
    return transform.visible;
}

/* Returns the bytes of a draw of all of an object, whose material is prepared for it. */
static GLINT_NOINLINE size_t size_object(glint_frame *frame, const glint_object *object, int clips) {
    const glint_mesh *mesh = object->mesh;
    glint_shading shading = {0};
    glint_prepare_shading(frame, &shading, object->material);
    frame->shading = &shading;
    const size_t size = glint_draw_size(frame, object, clips, mesh->vertex_count, mesh->triangle_count, 0);
    frame->shading = 0;
    return size;
}

/* Counts the bytes of distinct materials, and checks each. */
static GLINT_NOINLINE glint_status count_materials(glint_frame *frame, need_tally *sum) {
    const glint_scene *scene = frame->scene;
    const glint_suns_stage *suns = glint_find_suns(scene);
    glint_status status = GLINT_OK;
    for (uint32_t i = 0; i < scene->object_count && status == GLINT_OK; i++) {
        if (!glint_is_first_of_material(scene, i))
            continue;
        glint_shading shading = {0};
        status = glint_prepare_shading(frame, &shading, scene->objects[i].material);
        sum->materials += GLINT_ALIGNED(sizeof shading);
        if (suns && status == GLINT_OK)
            suns->need(frame, &shading, &sum->materials, &sum->tables);
    }
    return status;
}

/* Checks a scene, all but its meshes' indices, and prepares frame and view. */
static GLINT_NOINLINE glint_status begin_need(glint_frame *frame, glint_view *view, const glint_config *config,
                                              const glint_scene *scene) {
    glint_transform transform;
    glint_status status = glint_frame_grid(frame, config, scene);
    if (status == GLINT_OK)
        status = glint_check_scene(config, scene);
    if (status == GLINT_OK)
        status = glint_prepare_view(view, &frame->config, scene, &transform, 1);
    frame->view = view;
    return status;
}

/* Begins a frame, and counts the bytes of what is prepared and of vertices. */
static GLINT_NOINLINE glint_status count_prepared(glint_frame *frame, const glint_config *config,
                                                  const glint_scene *scene, need_tally *sum) {
    glint_whole_view whole;
    glint_status status = begin_need(frame, &whole.view, config, scene);
    if (status == GLINT_OK)
        status = count_materials(frame, sum);
    for (uint32_t i = 0; i < scene->object_count && status == GLINT_OK; i++) {
        int clips;
        if (is_object_visible(frame, &scene->objects[i], &clips))
            sum->vertices += size_object(frame, &scene->objects[i], clips);
    }
    frame->view = 0;
    return status;
}

/* ---- What is listed ---- */

/* A view without lights lists triangles: its range of depths, where it has one, takes their place. */
typedef char dark_view_has_room[sizeof(glint_depth_range) <= sizeof(glint_prepared_light) ? 1 : -1];

static GLINT_NOINLINE void prepare_dark_view(glint_view *view, const glint_frame *frame) {
    glint_transform transform;
    glint_scene dark = *frame->scene;
    dark.light_count = 0;
    glint_prepare_view(view, &frame->config, &dark, &transform, 1); /* the whole view met no error */
}

static glint_status count_object(glint_frame *frame, const glint_object *object, need_tally *sum) {
    glint_range tiles[GLINT_CLIP_CORNERS - 2];
    glint_sight sight;
    if (!glint_sight_begin(&sight, frame, object))
        return GLINT_OK;
    for (uint32_t i = 0; i < object->mesh->triangle_count; i++) {
        const int parts = glint_sight_next(&sight, i, tiles);
        if (parts < 0)
            return (glint_status)parts;
        for (int part = 0; part < parts; part++)
            count_references(frame, &tiles[part], sum);
        sum->clipped += sight.is_clipped ? (size_t)parts : 0;
    }
    return GLINT_OK;
}

/* Counts references to the triangles of all objects. */
static GLINT_NOINLINE glint_status count_lists(glint_frame *frame, need_tally *sum) {
    glint_status status = GLINT_OK;
    glint_view view;
    prepare_dark_view(&view, frame);
    frame->view = &view;
    for (uint32_t i = 0; i < frame->scene->object_count && status == GLINT_OK; i++)
        status = count_object(frame, &frame->scene->objects[i], sum);
    frame->view = 0;
    return status;
}

/* ---- Their sum ---- */

/* Returns the bytes of the lists of so many tiles, and of all clipped triangles. */
static size_t size_lists(const need_tally *sum, size_t tiles, size_t references) {
    return GLINT_ALIGNED(tiles * sizeof(glint_reference)) + GLINT_ALIGNED(references * sizeof(glint_reference)) +
           GLINT_ALIGNED(sum->clipped * sizeof(glint_clipped)) + GLINT_BIN_RESERVE;
}

static size_t larger_of(size_t a, size_t b) {
    return a > b ? a : b;
}

/* Sets the bytes that a tally of all objects comes to. */
static void finish_need(const glint_frame *frame, const need_tally *sum, glint_need *need) {
    const size_t prepared =
        GLINT_ALIGNMENT - 1 + glint_tile_buffers_size(&frame->config) + GLINT_ALIGNED(glint_view_size(frame->scene)) +
        GLINT_ALIGNED(glint_corners_size(frame->scene)) + glint_order_size(&frame->config, frame->scene) +
        glint_fog_size(frame->scene) + sum->materials;
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
    need_tally sum = {0};
    glint_status status = count_prepared(&frame, config, scene, &sum);
    if (status == GLINT_OK)
        status = count_lists(&frame, &sum);
    if (status == GLINT_OK)
        finish_need(&frame, &sum, need);
    return status;
}
