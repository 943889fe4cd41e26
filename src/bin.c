/* SPDX-License-Identifier: MIT */
/* Bin: culls triangles, clips those that need it, and lists the rest with the tiles that they may touch. */
#include "frame.h"

static int32_t least(int32_t a, int32_t b, int32_t c) {
    int32_t m = a < b ? a : b;
    return m < c ? m : c;
}

static int32_t most(int32_t a, int32_t b, int32_t c) {
    return -least(-a, -b, -c);
}

int glint_find_tiles(const glint_frame *frame, int mirrored, int double_sided, const glint_vertex *const v[3],
                     glint_range *range) {
    int32_t area = glint_double_area(v[0], v[1], v[2]);
    if (area == 0 || (!double_sided && (area > 0) != mirrored))
        return 0;
    /* From the first pixel centre at or after the least coordinate to the last before the greatest. */
    int32_t left = glint_shift_right(least(v[0]->x, v[1]->x, v[2]->x) + 7, 4);
    int32_t right = glint_shift_right(most(v[0]->x, v[1]->x, v[2]->x) + 7, 4);
    int32_t top = glint_shift_right(least(v[0]->y, v[1]->y, v[2]->y) + 7, 4);
    int32_t bottom = glint_shift_right(most(v[0]->y, v[1]->y, v[2]->y) + 7, 4);
    left = left < 0 ? 0 : left;
    top = top < 0 ? 0 : top;
    right = right > frame->config.width ? frame->config.width : right;
    bottom = bottom > frame->config.height ? frame->config.height : bottom;
    if (left >= right || top >= bottom)
        return 0;
    range->left = left >> frame->tile_shift_x;
    range->top = top >> frame->tile_shift_y;
    range->right = ((right - 1) >> frame->tile_shift_x) + 1;
    range->bottom = ((bottom - 1) >> frame->tile_shift_y) + 1;
    return 1;
}

static size_t room(const glint_frame *frame) {
    const uint8_t *low = (const uint8_t *)(frame->references + frame->reference_count);
    return (size_t)((const uint8_t *)frame->clipped - low);
}

/* Appends a triangle to the list of each tile of the pass in range. @return 0 when the arena is full. */
static int list_triangle(glint_frame *frame, const glint_range *range, uint32_t triangle) {
    for (int32_t row = range->top; row < range->bottom; row++) {
        for (int32_t column = range->left; column < range->right; column++) {
            int32_t tile = row * frame->tile_columns + column;
            if (tile < frame->tile_first || tile >= frame->tile_end)
                continue;
            if (room(frame) < sizeof(glint_reference) || frame->reference_count == GLINT_LIST_END)
                return 0;
            glint_list *list = &frame->lists[tile - frame->tile_first];
            uint16_t here = (uint16_t)frame->reference_count++;
            frame->references[here].next = GLINT_LIST_END;
            frame->references[here].triangle = (uint16_t)triangle;
            if (list->head == GLINT_LIST_END)
                list->head = here;
            else
                frame->references[list->tail].next = here;
            list->tail = here;
            frame->stats.references++;
        }
    }
    return 1;
}

/* Is there room for all that clipping a triangle can make, in one tile? A pass of one tile never stops half way. */
static int has_room_for_clipped(const glint_frame *frame) {
    const uint32_t most_made = GLINT_CLIP_CORNERS - 2;
    const glint_clipped *top = (const glint_clipped *)(const void *)(frame->memory.base + frame->memory.high);
    return room(frame) >= most_made * (sizeof(glint_clipped) + sizeof(glint_reference)) &&
           frame->reference_count + most_made <= GLINT_LIST_END &&
           (uint32_t)(top - frame->clipped) + most_made <= GLINT_CLIPPED_TOP - GLINT_TRIANGLES_MAX;
}

/* Corners of a triangle of a draw, as clipping takes them. */
static void gather_corners(const glint_draw *draw, const uint16_t *indices, glint_corner corners[3]) {
    for (int i = 0; i < 3; i++) {
        corners[i].position = draw->positions[indices[i]];
        for (int c = 0; c < 3; c++) {
            corners[i].attribute[c] = draw->vertices[indices[i]].attribute[c];
            corners[i].attribute[3 + c] = draw->extra ? draw->extra[indices[i]][c] : 0;
        }
    }
}

static void finish_corner(const glint_transform *transform, const glint_corner *corner, glint_vertex *vertex) {
    glint_project(transform, &corner->position, vertex);
    for (int c = 0; c < 3; c++)
        vertex->attribute[c] = (int16_t)corner->attribute[c];
    vertex->flags = 0;
}

/* Keeps a part of a clipped triangle and lists it. */
static int keep_part(glint_frame *frame, const glint_draw *draw, uint32_t triangle, const glint_vertex *const v[3],
                     const glint_corner *const corners[3], const glint_range *range) {
    const glint_clipped *top = (const glint_clipped *)(const void *)(frame->memory.base + frame->memory.high);
    uint32_t number = (uint32_t)(top - frame->clipped);
    if (room(frame) < sizeof(glint_clipped)) /* a pass of many tiles can run out of room half way */
        return 0;
    glint_clipped *part = --frame->clipped;
    part->draw = draw;
    part->triangle = (uint16_t)triangle;
    for (int i = 0; i < 3; i++) {
        part->corners[i] = *v[i];
        for (int c = 0; c < 3; c++)
            part->extra[i][c] = (int16_t)corners[i]->attribute[3 + c];
    }
    return list_triangle(frame, range, GLINT_CLIPPED_TOP - number);
}

static void light_once(const glint_frame *frame, glint_draw *draw, const glint_transform *transform, uint32_t i) {
    if (draw->evaluation->light_triangle)
        draw->evaluation->light_triangle(frame, draw, transform, i);
}

/* Clips a triangle and lists the fan that is left of it. */
static int list_clipped(glint_frame *frame, glint_draw *draw, const glint_transform *transform, uint32_t triangle) {
    glint_corner corners[GLINT_CLIP_CORNERS];
    glint_vertex fan[GLINT_CLIP_CORNERS];
    gather_corners(draw, draw->triangles[triangle], corners);
    int count = glint_clip(transform, corners);
    frame->stats.clipped++;
    if (count)
        light_once(frame, draw, transform, triangle);
    for (int i = 0; i < count; i++)
        finish_corner(transform, &corners[i], &fan[i]);
    for (int i = 2; i < count; i++) {
        const glint_vertex *const part[3] = {&fan[0], &fan[i - 1], &fan[i]};
        const glint_corner *const ends[3] = {&corners[0], &corners[i - 1], &corners[i]};
        glint_range range;
        if (glint_find_tiles(frame, draw->mirrored, draw->double_sided, part, &range) &&
            !keep_part(frame, draw, triangle, part, ends, &range))
            return 0;
    }
    return 1;
}

/* @return 1, 0 when the arena is full, or an error. */
static int bin_triangle(glint_frame *frame, glint_draw *draw, const glint_transform *transform, uint32_t i) {
    const uint16_t *indices = draw->triangles[i];
    if (indices[0] >= draw->vertex_count || indices[1] >= draw->vertex_count || indices[2] >= draw->vertex_count)
        return GLINT_ERROR_INDEX;
    const glint_vertex *const v[3] = {&draw->vertices[indices[0]], &draw->vertices[indices[1]],
                                      &draw->vertices[indices[2]]};
    if ((v[0]->flags | v[1]->flags | v[2]->flags) & GLINT_VERTEX_CLIP)
        return has_room_for_clipped(frame) && list_clipped(frame, draw, transform, i);
    glint_range range;
    if (!glint_find_tiles(frame, draw->mirrored, draw->double_sided, v, &range)) {
        frame->stats.culled++;
        return 1;
    }
    light_once(frame, draw, transform, i);
    return list_triangle(frame, &range, draw->first + i);
}

/* @return 0 when the arena cannot hold the lists. */
static int begin_lists(glint_frame *frame) {
    uint32_t tiles = (uint32_t)(frame->tile_end - frame->tile_first);
    frame->memory.low = frame->vertices_end;
    frame->lists = glint_take(&frame->memory, tiles * sizeof *frame->lists);
    frame->references = glint_take(&frame->memory, 0);
    frame->clipped = (glint_clipped *)(void *)(frame->memory.base + frame->memory.high);
    frame->reference_count = 0;
    if (!frame->lists || !frame->references)
        return 0;
    for (uint32_t i = 0; i < tiles; i++)
        frame->lists[i].head = GLINT_LIST_END;
    return 1;
}

glint_status glint_bin(glint_frame *frame, int *complete) {
    *complete = 0;
    if (!begin_lists(frame))
        return GLINT_OK;
    for (glint_draw *draw = frame->draws; draw; draw = draw->next) {
        uint32_t end = draw->first_triangle + draw->count;
        if (draw->object < frame->object || (draw->object == frame->object && end <= frame->triangle))
            continue;
        if (draw->object > frame->object)
            frame->triangle = 0;
        frame->object = draw->object;
        glint_transform transform;
        if (draw->positions)
            glint_transform_prepare(&transform, frame->view, &frame->config, &frame->scene->objects[draw->object]);
        for (; frame->triangle < end; frame->triangle++) {
            int binned = bin_triangle(frame, draw, &transform, frame->triangle - draw->first_triangle);
            if (binned <= 0)
                return (glint_status)binned;
            frame->stats.triangles++;
        }
    }
    if (frame->draws && frame->triangle == frame->scene->objects[frame->object].mesh->triangle_count) {
        frame->object++;
        frame->triangle = 0;
    }
    *complete = 1;
    return GLINT_OK;
}
