/* SPDX-License-Identifier: MIT */
/* Culls triangles, clips those that need it, and lists the rest with the tiles that they may touch. */
#include "frame.h"

/* ---- Tiles and lists ---- */

/*
 * Finds the tiles between corners in one direction, of pixels from `from` to before `to`: from the first pixel centre
 * at or after the least coordinate to the last before the greatest, counted from tile `origin` on. *end is exclusive.
 * @return 0 when there is no centre between
 */
static inline int find_span(int32_t a, int32_t b, int32_t c, int32_t from, int32_t to, unsigned shift, int32_t origin,
                            int32_t *first, int32_t *end) {
    const int32_t low = glint_most(glint_shift_right(glint_least_of(a, b, c) + 7, 4), from);
    const int32_t high = glint_least(glint_shift_right(glint_most_of(a, b, c) + 7, 4), to);
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

/* Returns the largest reference count that the arena has room for. */
static inline uint32_t most_references(const glint_frame *frame) {
    const size_t most =
        (size_t)((const uint8_t *)frame->clipped - (const uint8_t *)frame->references) / sizeof(glint_reference);
    return most < GLINT_LIST_END ? (uint32_t)most : GLINT_LIST_END;
}

/* Returns a triangle's reference at the end of a list, as one word. */
static inline uint32_t reference_to(uint32_t triangle) {
    return triangle << 16 | GLINT_LIST_END;
}

/* Puts a triangle's reference, number `here`, behind a tile's list. */
static inline void append(glint_reference *references, uint32_t here, uint32_t tile, uint32_t reference) {
    GLINT_OPAQUE(reference); /* otherwise its halves are stored one by one */
    references[here].next = (uint16_t)reference;
    references[here].triangle = (uint16_t)(reference >> 16);
    references[references[tile].triangle].next = (uint16_t)here;
    references[tile].triangle = (uint16_t)here;
}

/* Lists a triangle with each tile of the pass in a range, which is not empty. @return 0 when the arena is full */
static inline int list_in_range(glint_frame *frame, const glint_range *range, uint32_t reference) {
    glint_reference *const references = frame->references;
    const uint32_t count = glint_pass_tiles(frame), most = most_references(frame), columns = frame->tile_columns;
    const uint32_t width = (uint32_t)(range->right - range->left);
    uint32_t here = frame->reference_count,
             row = (uint32_t)range->top * columns + (uint32_t)range->left - frame->tile_first;
    const uint32_t end = row + (uint32_t)(range->bottom - range->top) * columns;
    do {
        uint32_t tile = row;
        do {
            if (tile < count) {
                if (here >= most)
                    return 0;
                append(references, here++, tile, reference);
                frame->reference_count = here;
            }
        } while (++tile != row + width);
        row += columns;
    } while (row != end);
    return 1;
}

/* ---- Triangles that are clipped ---- */

/* Is there room for all that clipping a triangle can make, in one tile? A pass of one tile never stops half way. */
static int has_room_for_clipped(const glint_frame *frame) {
    const uint32_t most_made = GLINT_CLIP_CORNERS - 2;
    const size_t clipped = (size_t)(frame->memory.base + frame->memory.high - (const uint8_t *)frame->clipped);
    return glint_free_bytes(frame) >= most_made * (sizeof(glint_clipped) + sizeof(glint_reference)) &&
           frame->reference_count + most_made <= GLINT_LIST_END &&
           clipped <= (GLINT_CLIPPED_TOP - GLINT_TRIANGLES_MAX - most_made) * sizeof(glint_clipped);
}

/* Gathers the corners of a triangle of a draw for clipping. */
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
        vertex->attribute[c] = corner->attribute[c];
        extra[c] = corner->attribute[3 + c];
    }
}

/* Clips a triangle and lists the fan that is left of it. */
static GLINT_NOINLINE int list_clipped(glint_frame *frame, glint_draw *draw, uint32_t triangle) {
    const glint_clipped *top = (const glint_clipped *)(const void *)(frame->memory.base + frame->memory.high);
    glint_corner corners[GLINT_CLIP_CORNERS];
    glint_range range;
    if (!has_room_for_clipped(frame))
        return 0;
    if (draw->light)
        draw->light(frame, draw, &draw->transform, triangle);
    gather_corners(draw, draw->triangles[triangle], corners);
    int count = glint_clip(&draw->transform, corners);
    frame->stats.clipped++;
    for (int last = 2; last < count; last++) {
        glint_clipped *part = frame->clipped - 1;
        const glint_vertex *const v[3] = {&part->corners[0], &part->corners[1], &part->corners[2]};
        if (glint_free_bytes(frame) < sizeof *part) /* a pass of many tiles can run out of room half way */
            return 0;
        for (int i = 0; i < 3; i++)
            finish_corner(frame, &draw->transform, &corners[i ? last - 2 + i : 0], &part->corners[i], part->extra[i]);
        if (!glint_faces(draw->mirrored, draw->double_sided, v) || !glint_find_tiles(frame, v, &range))
            continue;
        part->draw = draw;
        part->triangle = (uint16_t)triangle;
        frame->clipped = part;
        if (!list_in_range(frame, &range, reference_to(GLINT_CLIPPED_TOP + 1 - (uint32_t)(top - part))))
            return 0;
    }
    return 1;
}

/* ---- Whole triangles ---- */

/* Lights a triangle that is going to be drawn, as far as that comes before it is drawn, unless its corners are lit. */
static inline void light_listed(const glint_frame *frame, glint_draw *draw, const glint_vertex *const v[3],
                                uint32_t triangle) {
    if (draw->light && !(v[0]->flags & v[1]->flags & v[2]->flags & GLINT_VERTEX_NORMAL))
        draw->light(frame, draw, &draw->transform, triangle);
}

/* Lists a visible triangle in any tiles. @return 0 when the arena is full */
static GLINT_NOINLINE int list_anywhere(glint_frame *frame, glint_draw *draw, uint32_t triangle) {
    const uint16_t *indices = draw->triangles[triangle];
    const glint_vertex *const v[3] = {&draw->vertices[indices[0]], &draw->vertices[indices[1]],
                                      &draw->vertices[indices[2]]};
    glint_range range;
    if (!find_tiles(frame, v, &range)) {
        frame->stats.outside++;
        return 1;
    }
    light_listed(frame, draw, v, triangle);
    return list_in_range(frame, &range, reference_to(draw->first + triangle));
}

static void begin_bin(glint_bin_pass *pass, glint_frame *frame) {
    const uint32_t shift_x = frame->tile_shift_x + 4u, shift_y = frame->tile_shift_y + 4u;
    pass->frame = frame;
    if (GLINT_SMALL) /* all triangles are listed the long way here */
        return;
    pass->shift_x = shift_x;
    pass->shift_y = shift_y + 16;
    pass->above = (0xffffu << shift_x & 0xffffu) | 0xffff0000u << shift_y;
    if (frame->config.region.x | frame->config.region.y)
        pass->above = 0xffffffff; /* a region is listed the long way */
    pass->last = (16u * frame->right - 1) | (16u * frame->bottom - 1) << 16;
    pass->columns = frame->tile_columns;
    pass->first = frame->tile_first;
    pass->count = glint_pass_tiles(frame);
    pass->most = most_references(frame);
}

/* Lists a visible triangle, given the first corner's place and the bits that differ between the places of all. Most
 * triangles lie in one tile: then these agree in all bits above it. @return 0 when the arena is full */
static GLINT_INLINE int list_seen(const glint_bin_pass *pass, glint_draw *draw, const glint_vertex *const v[3],
                                  uint32_t left, uint32_t place, uint32_t differ) {
    glint_frame *const frame = pass->frame;
    /* Off the screen, a half is below 0, or its difference from the last place is. */
    if (GLINT_SMALL || (differ & pass->above) | ((place | (pass->last - place)) & 0x80008000))
        return list_anywhere(frame, draw, pass->end - left);
    const uint32_t tile = (place >> pass->shift_y) * pass->columns + ((place & 0xffff) >> pass->shift_x) - pass->first;
    if (tile >= pass->count)
        return 1;
    const uint32_t here = frame->reference_count;
    if (here >= pass->most)
        return 0;
    light_listed(frame, draw, v, pass->end - left);
    append(frame->references, here, tile, pass->reference - (left << 16));
    frame->reference_count = here + 1;
    return 1;
}

/* ---- Draws ---- */

/* Returns x and y of a vertex as two halves of a word. */
static inline uint32_t word_of(const glint_vertex *v) {
    return (uint32_t)(uint16_t)v->x | (uint32_t)(uint16_t)v->y << 16;
}

/* Returns twice the area of corners' words, as glint_double_area does. The guard band keeps differences in 16 bits. */
static inline int32_t area_of_words(uint32_t a, uint32_t b, uint32_t c) {
    uint32_t x1 = b - a, x2 = c - a;
    const int32_t y = glint_shift_right((int32_t)a, 16);
    GLINT_OPAQUE(x1); /* otherwise both halves are taken out first */
    GLINT_OPAQUE(x2);
    return (int16_t)x1 * (glint_shift_right((int32_t)c, 16) - y) -
           (int16_t)x2 * (glint_shift_right((int32_t)b, 16) - y);
}

/* This takes a word to a place. A carry from x to y comes from x < 0, which is on no tile. */
#define TO_PLACE 0x00070007u

int glint_bin_some(glint_bin_pass *pass, glint_draw *draw, uint32_t next, uint32_t end) {
    const glint_vertex *const vertices = draw->vertices;
    const uint16_t *indices = draw->triangles[next];
    const uint32_t whole =
        draw->transform.clips ? 0 : draw->vertex_count; /* vertices below are valid and not clipped */
    const int sees_clockwise = draw->mirrored || draw->double_sided,
              sees_others = !draw->mirrored || draw->double_sided;
    uint32_t left = end - next, away = 0;
    pass->end = end;
    pass->reference = reference_to(draw->first + end);
    for (; left; left--, indices += 3) {
        const uint32_t a = indices[0], b = indices[1], c = indices[2];
        if ((a | b | c) >= whole && (a >= draw->vertex_count || b >= draw->vertex_count || c >= draw->vertex_count))
            return GLINT_ERROR_INDEX;
        const glint_vertex *const v[3] = {&vertices[a], &vertices[b], &vertices[c]};
        if (!whole && (v[0]->flags | v[1]->flags | v[2]->flags) & GLINT_VERTEX_CLIP) {
            if (!list_clipped(pass->frame, draw, end - left))
                break;
            if (!GLINT_SMALL)
                pass->most = most_references(pass->frame);
            continue;
        }
        const uint32_t w[3] = {word_of(v[0]), word_of(v[1]), word_of(v[2])};
        const int32_t area = area_of_words(w[0], w[1], w[2]);
        if (area < 0 ? !sees_others : !sees_clockwise || !area) {
            away++;
            continue;
        }
        const uint32_t place = w[0] + TO_PLACE, differ = (place ^ (w[1] + TO_PLACE)) | (place ^ (w[2] + TO_PLACE));
        if (!GLINT_SMALL && (!(differ & 0xfff0) || !(differ >> 20))) /* no pixel centre lies between */
            pass->frame->stats.outside++;
        else if (!list_seen(pass, draw, v, left, place, differ))
            break;
    }
    pass->frame->stats.facing_away += away;
    return (int)(end - left);
}

/* Bins the triangles of a draw from frame->triangle on. @return 1, 0 when the arena is full, or an error */
static int bin_draw(glint_bin_pass *pass, glint_draw *draw) {
    glint_frame *const frame = pass->frame;
    const uint32_t from = draw->origin ? 0 : frame->triangle; /* parts begin where a pass does */
    const int end = draw->away ? draw->cull->bin(pass, draw, from) : glint_bin_some(pass, draw, from, draw->count);
    if (end < 0)
        return end;
    frame->stats.triangles += (uint32_t)end - from;
    frame->triangle =
        end == draw->count ? draw->end : draw->first_triangle + (draw->origin ? draw->origin[end] : (uint32_t)end);
    return end == draw->count;
}

/* Begins the lists of a pass. @return 0 when the arena cannot hold them */
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
    glint_bin_pass pass;
    begin_bin(&pass, frame);
    for (glint_draw *draw = frame->draws; draw; draw = draw->next) {
        if (draw->object < frame->object || (draw->object == frame->object && draw->end <= frame->triangle))
            continue;
        if (draw->object > frame->object)
            frame->triangle = 0;
        frame->object = draw->object;
        int binned = bin_draw(&pass, draw);
        if (binned <= 0)
            return (glint_status)binned;
    }
    if (frame->draws && frame->triangle == glint_object_at(frame, frame->object)->mesh->triangle_count) {
        frame->object++;
        frame->triangle = 0;
    }
    *complete = 1;
    return GLINT_OK;
}
