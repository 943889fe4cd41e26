/* SPDX-License-Identifier: MIT */
/* Bin: culls triangles, clips those that need it, and lists the rest with the tiles that they may touch. */
#include "cull.h"
#include "lists.h"

/*
 * Tiles between corners in one direction, of pixels from `from` to before `to`: from the first pixel centre at or after
 * the least coordinate to the last before the greatest, counted from tile `origin` on; *end is exclusive.
 * @return 0 when there is no centre between
 */
static inline int find_span(int32_t a, int32_t b, int32_t c, int32_t from, int32_t to, unsigned shift, int32_t origin,
                            int32_t *first, int32_t *end) {
    int32_t low = a < b ? a : b, high = a + b - low;
    low = glint_shift_right((low < c ? low : c) + 7, 4);
    high = glint_shift_right((high > c ? high : c) + 7, 4);
    low = low < from ? from : low;
    high = high > to ? to : high;
    *first = glint_shift_right(low, shift) - origin;
    *end = glint_shift_right(high - 1, shift) + 1 - origin;
    return low < high;
}

static inline int find_tiles(const glint_frame *frame, const glint_vertex *const v[3], glint_range *range) {
    const glint_vertex *a = v[0], *b = v[1], *c = v[2];
    const glint_rectangle *of = &frame->config.region;
    return find_span(a->x, b->x, c->x, of->x, frame->right, frame->tile_shift_x, frame->first_column, &range->left,
                     &range->right) &&
           find_span(a->y, b->y, c->y, of->y, frame->bottom, frame->tile_shift_y, frame->first_row, &range->top,
                     &range->bottom);
}

int glint_find_tiles(const glint_frame *frame, const glint_vertex *const v[3], glint_range *range) {
    return find_tiles(frame, v, range);
}

/* Appends a triangle to the list of each tile of the pass in range. @return 0 when the arena is full. */
static inline int list_triangle(glint_frame *frame, const glint_range *range, uint32_t triangle) {
    const uint32_t count = glint_pass_tiles(frame), most = glint_most_references(frame);
    for (int32_t row = range->top; row < range->bottom; row++) {
        uint32_t tile = (uint32_t)(row * frame->tile_columns + range->left - frame->tile_first);
        for (int32_t column = range->left; column < range->right; column++, tile++)
            if (tile < count) {
                if (frame->reference_count >= most)
                    return 0;
                glint_list_append(frame, tile, glint_reference_to(triangle));
            }
    }
    return 1;
}

static size_t room(const glint_frame *frame) {
    const uint8_t *low = (const uint8_t *)(frame->references + frame->reference_count);
    return (size_t)((const uint8_t *)frame->clipped - low);
}

/* Is there room for all that clipping a triangle can make, in one tile? A pass of one tile never stops half way. */
static int has_room_for_clipped(const glint_frame *frame) {
    const uint32_t most_made = GLINT_CLIP_CORNERS - 2;
    const size_t clipped = (size_t)(frame->memory.base + frame->memory.high - (const uint8_t *)frame->clipped);
    return room(frame) >= most_made * (sizeof(glint_clipped) + sizeof(glint_reference)) &&
           frame->reference_count + most_made <= GLINT_LIST_END &&
           clipped <= (GLINT_CLIPPED_TOP - GLINT_TRIANGLES_MAX - most_made) * sizeof(glint_clipped);
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

static void finish_corner(const glint_frame *frame, const glint_transform *transform, const glint_corner *corner,
                          glint_vertex *vertex, int16_t extra[3]) {
    glint_project(transform, &corner->position, vertex);
    vertex->flags = 0;
    if (transform->clips & GLINT_PARALLEL)
        frame->scene->camera.projection->finish(frame->view, transform, vertex, 1);
    for (int c = 0; c < 3; c++) {
        vertex->attribute[c] = (int16_t)corner->attribute[c];
        extra[c] = (int16_t)corner->attribute[3 + c];
    }
}

/* Clips a triangle and lists the fan that is left of it. */
static int list_clipped(glint_frame *frame, glint_draw *draw, uint32_t triangle) {
    const glint_clipped *top = (const glint_clipped *)(const void *)(frame->memory.base + frame->memory.high);
    glint_corner corners[GLINT_CLIP_CORNERS];
    glint_range range;
    if (draw->light)
        draw->light(frame, draw, &draw->transform, triangle);
    gather_corners(draw, draw->triangles[triangle], corners);
    int count = glint_clip(&draw->transform, corners);
    frame->stats.clipped++;
    for (int last = 2; last < count; last++) {
        glint_clipped *part = frame->clipped - 1;
        const glint_vertex *const v[3] = {&part->corners[0], &part->corners[1], &part->corners[2]};
        if (room(frame) < sizeof *part) /* a pass of many tiles can run out of room half way */
            return 0;
        for (int i = 0; i < 3; i++)
            finish_corner(frame, &draw->transform, &corners[i ? last - 2 + i : 0], &part->corners[i], part->extra[i]);
        if (!glint_faces(draw->mirrored, draw->double_sided, v) || !glint_find_tiles(frame, v, &range))
            continue;
        part->draw = draw;
        part->triangle = (uint16_t)triangle;
        frame->clipped = part;
        if (!list_triangle(frame, &range, GLINT_CLIPPED_TOP + 1 - (uint32_t)(top - part)))
            return 0;
    }
    return 1;
}

/* Bins a triangle that is whole and faces the eye, wherever it lies. @return 0 when the arena is full. */
GLINT_NOINLINE int glint_bin_whole(glint_frame *frame, glint_draw *draw, uint32_t triangle) {
    const uint16_t *indices = draw->triangles[triangle];
    const glint_vertex *const v[3] = {&draw->vertices[indices[0]], &draw->vertices[indices[1]],
                                      &draw->vertices[indices[2]]};
    glint_range range;
    if (!find_tiles(frame, v, &range)) {
        frame->stats.outside++;
        return 1;
    }
    glint_list_light(frame, draw, v, triangle);
    return list_triangle(frame, &range, draw->first + triangle);
}

/* Bins any triangle. @return 1, 0 when the arena is full, or GLINT_ERROR_INDEX. */
static int bin_any(glint_frame *frame, glint_draw *draw, uint32_t triangle) {
    const uint16_t *indices = draw->triangles[triangle];
    const uint32_t a = indices[0], b = indices[1], c = indices[2];
    if (a >= draw->vertex_count || b >= draw->vertex_count || c >= draw->vertex_count)
        return GLINT_ERROR_INDEX;
    const glint_vertex *const v[3] = {&draw->vertices[a], &draw->vertices[b], &draw->vertices[c]};
    if ((v[0]->flags | v[1]->flags | v[2]->flags) & GLINT_VERTEX_CLIP)
        return has_room_for_clipped(frame) && list_clipped(frame, draw, triangle);
    if (!glint_faces(draw->mirrored, draw->double_sided, v)) {
        frame->stats.facing_away++;
        return 1;
    }
    return glint_bin_whole(frame, draw, triangle);
}

/* The same, of those from number `next` on, up to `end`. @return the first that the arena had no room for, `end`, or
 * GLINT_ERROR_INDEX. */
static int bin_each(glint_frame *frame, glint_draw *draw, uint32_t next, uint32_t end) {
    for (; next < end; next++) {
        const int binned = bin_any(frame, draw, next);
        if (binned <= 0)
            return binned < 0 ? binned : (int)next;
    }
    return (int)next;
}

/* ---- Draws ---- */

/* Is a draw nowhere clipped, in tiles from the screen's first on? */
static int is_plain(const glint_frame *frame, const glint_draw *draw) {
    return !draw->transform.clips && !frame->first_column && !frame->first_row;
}

int glint_bin_some(glint_frame *frame, glint_draw *draw, uint32_t next, uint32_t end) {
    return GLINT_SMALL || !is_plain(frame, draw) ? bin_each(frame, draw, next, end)
                                                 : glint_bin_plain(frame, draw, next, end);
}

/* Bins the triangles of a draw from frame->triangle on. @return 1, 0 when the arena is full, or an error. */
static int bin_draw(glint_frame *frame, glint_draw *draw) {
    const uint32_t from = draw->origin ? 0 : frame->triangle; /* parts begin where a pass does */
    const int end = draw->away ? draw->cull->bin(frame, draw, from) : glint_bin_some(frame, draw, from, draw->count);
    if (end < 0)
        return end;
    frame->stats.triangles += (uint32_t)end - from;
    frame->triangle =
        end == draw->count ? draw->end : draw->first_triangle + (draw->origin ? draw->origin[end] : (uint32_t)end);
    return end == draw->count;
}

/* @return 0 when the arena cannot hold the lists. */
static int begin_lists(glint_frame *frame) {
    const uint32_t tiles = glint_pass_tiles(frame);
    frame->memory.low = frame->vertices_end;
    frame->references = glint_take(&frame->memory, tiles * sizeof *frame->references);
    frame->clipped = (glint_clipped *)(void *)(frame->memory.base + frame->memory.high);
    frame->reference_count = tiles;
    if (!frame->references)
        return 0;
    for (uint32_t i = 0; i < tiles; i++)
        frame->references[i] = (glint_reference){GLINT_LIST_END, (uint16_t)i};
    return 1;
}

glint_status glint_bin(glint_frame *frame, int *complete) {
    *complete = 0;
    if (!begin_lists(frame))
        return GLINT_OK;
    for (glint_draw *draw = frame->draws; draw; draw = draw->next) {
        if (draw->object < frame->object || (draw->object == frame->object && draw->end <= frame->triangle))
            continue;
        if (draw->object > frame->object)
            frame->triangle = 0;
        frame->object = draw->object;
        int binned = bin_draw(frame, draw);
        if (binned <= 0)
            return (glint_status)binned;
    }
    if (frame->draws && frame->triangle == frame->scene->objects[frame->object].mesh->triangle_count) {
        frame->object++;
        frame->triangle = 0;
    }
    *complete = 1;
    return GLINT_OK;
}
