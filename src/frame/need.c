/* SPDX-License-Identifier: MIT */
/*
 * Goes through a scene as a pass would, without an arena, and counts what a pass would use. What is large on the stack
 * is out of line, so that it is not there at the same time.
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

/* Returns the bytes of a draw of all of an object, whose material is prepared for it. */
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
    glint_range tiles[GLINT_CLIP_CORNERS - 2];
    glint_sight sight;
    if (!glint_sight_begin(&sight, frame, object))
        return GLINT_OK;
    sum->vertices += size_object(frame, object, &sight.transform);
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

/* Returns the bytes of the lists of so many tiles, and of all clipped triangles. */
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
