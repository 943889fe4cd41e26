/* SPDX-License-Identifier: MIT */
/* Bin: culls triangles, clips those that need it, and lists the rest with the tiles that they may touch. */
#include "frame.h"

/*
 * Tiles between corners in one direction, of a screen of so many pixels: from the first pixel centre at or after the
 * least coordinate to the last before the greatest; *end is exclusive. @return 0 when there is no centre between.
 */
static inline int find_span(int32_t a, int32_t b, int32_t c, int32_t size, unsigned shift, int32_t *first,
                            int32_t *end) {
    int32_t low = a < b ? a : b, high = a + b - low;
    low = glint_shift_right((low < c ? low : c) + 7, 4);
    high = glint_shift_right((high > c ? high : c) + 7, 4);
    low = low < 0 ? 0 : low;
    high = high > size ? size : high;
    *first = glint_shift_right(low, shift);
    *end = glint_shift_right(high - 1, shift) + 1;
    return low < high;
}

static inline int find_tiles(const glint_frame *frame, const glint_vertex *const v[3], glint_range *range) {
    const glint_vertex *a = v[0], *b = v[1], *c = v[2];
    return find_span(a->x, b->x, c->x, frame->config.width, frame->tile_shift_x, &range->left, &range->right) &&
           find_span(a->y, b->y, c->y, frame->config.height, frame->tile_shift_y, &range->top, &range->bottom);
}

int glint_find_tiles(const glint_frame *frame, const glint_vertex *const v[3], glint_range *range) {
    return find_tiles(frame, v, range);
}

static size_t room(const glint_frame *frame) {
    const uint8_t *low = (const uint8_t *)(frame->references + frame->reference_count);
    return (size_t)((const uint8_t *)frame->clipped - low);
}

/* What the reference count may come to. */
static uint32_t most_references(const glint_frame *frame) {
    const size_t most =
        (size_t)((const uint8_t *)frame->clipped - (const uint8_t *)frame->references) / sizeof(glint_reference);
    return most < GLINT_LIST_END ? (uint32_t)most : GLINT_LIST_END;
}

/* Appends a triangle to a tile's list, counted in the pass; there is room. */
static inline void append(glint_frame *frame, uint32_t tile, uint32_t triangle) {
    const uint32_t here = frame->reference_count;
    uint16_t *const next = &frame->references->next; /* every other of these, a list's head among them */
    next[2 * here] = GLINT_LIST_END;
    next[2 * here + 1] = (uint16_t)triangle;
    next[2 * next[2 * tile + 1]] = (uint16_t)here;
    next[2 * tile + 1] = (uint16_t)here;
    frame->reference_count = here + 1;
}

/* Appends a triangle to the list of each tile of the pass in range. @return 0 when the arena is full. */
static inline int list_triangle(glint_frame *frame, const glint_range *range, uint32_t triangle) {
    const uint32_t count = glint_pass_tiles(frame), most = most_references(frame);
    for (int32_t row = range->top; row < range->bottom; row++) {
        uint32_t tile = (uint32_t)(row * frame->tile_columns + range->left - frame->tile_first);
        for (int32_t column = range->left; column < range->right; column++, tile++)
            if (tile < count) {
                if (frame->reference_count >= most)
                    return 0;
                append(frame, tile, triangle);
            }
    }
    return 1;
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

/* Lights a triangle that is going to be seen, as far as that comes before it is drawn. */
static inline void light(const glint_frame *frame, glint_draw *draw, uint32_t triangle) {
    draw->light(frame, draw, &draw->transform, triangle);
}

static void finish_corner(const glint_transform *transform, const glint_corner *corner, glint_vertex *vertex,
                          int16_t extra[3]) {
    glint_project(transform, &corner->position, vertex);
    for (int c = 0; c < 3; c++) {
        vertex->attribute[c] = (int16_t)corner->attribute[c];
        extra[c] = (int16_t)corner->attribute[3 + c];
    }
    vertex->flags = 0;
}

/* Clips a triangle and lists the fan that is left of it. */
static int list_clipped(glint_frame *frame, glint_draw *draw, uint32_t triangle) {
    const glint_clipped *top = (const glint_clipped *)(const void *)(frame->memory.base + frame->memory.high);
    glint_corner corners[GLINT_CLIP_CORNERS];
    glint_range range;
    light(frame, draw, triangle);
    gather_corners(draw, draw->triangles[triangle], corners);
    int count = glint_clip(&draw->transform, corners);
    frame->stats.clipped++;
    for (int last = 2; last < count; last++) {
        glint_clipped *part = frame->clipped - 1;
        const glint_vertex *const v[3] = {&part->corners[0], &part->corners[1], &part->corners[2]};
        if (room(frame) < sizeof *part) /* a pass of many tiles can run out of room half way */
            return 0;
        for (int i = 0; i < 3; i++)
            finish_corner(&draw->transform, &corners[i ? last - 2 + i : 0], &part->corners[i], part->extra[i]);
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
static GLINT_NOINLINE int bin_whole(glint_frame *frame, glint_draw *draw, uint32_t triangle) {
    const uint16_t *indices = draw->triangles[triangle];
    const glint_vertex *const v[3] = {&draw->vertices[indices[0]], &draw->vertices[indices[1]],
                                      &draw->vertices[indices[2]]};
    glint_range range;
    if (!find_tiles(frame, v, &range)) {
        frame->stats.outside++;
        return 1;
    }
    if (!(v[0]->flags & v[1]->flags & v[2]->flags & GLINT_VERTEX_NORMAL) || draw->evaluation->light_triangle)
        light(frame, draw, triangle);
    return list_triangle(frame, &range, draw->first + triangle);
}

/* Bins any triangle. @return 0 when the arena is full. */
static int bin_any(glint_frame *frame, glint_draw *draw, uint32_t triangle) {
    const uint16_t *indices = draw->triangles[triangle];
    const glint_vertex *const v[3] = {&draw->vertices[indices[0]], &draw->vertices[indices[1]],
                                      &draw->vertices[indices[2]]};
    if ((v[0]->flags | v[1]->flags | v[2]->flags) & GLINT_VERTEX_CLIP)
        return has_room_for_clipped(frame) && list_clipped(frame, draw, triangle);
    if (glint_takes_all(draw) && !glint_faces(draw->mirrored, draw->double_sided, v)) {
        frame->stats.facing_away++;
        return 1;
    }
    return bin_whole(frame, draw, triangle);
}

/* Where a pass's tiles lie, to find the one of most triangles: words of two halves, for x and y, as place_of gives. */
typedef struct grid {
    uint32_t shift_x, shift_y; /* from a half to a tile's column and row */
    uint32_t above;            /* the bits of these */
    uint32_t last;             /* the last place on the screen */
    uint32_t columns, first, count;
} grid;

static grid grid_of(const glint_frame *frame) {
    const uint32_t shift_x = frame->tile_shift_x + 4u, shift_y = frame->tile_shift_y + 4u;
    return (grid){shift_x,
                  shift_y + 16,
                  (0xffffu << shift_x & 0xffffu) | 0xffff0000u << shift_y,
                  (16u * frame->config.width - 1) | (16u * frame->config.height - 1) << 16,
                  frame->tile_columns,
                  frame->tile_first,
                  glint_pass_tiles(frame)};
}

/* x and y of a vertex as two halves of a word, from the last pixel centre before it. */
static inline uint32_t place_of(const glint_vertex *v) {
    return ((uint32_t)(uint16_t)v->x | (uint32_t)(uint16_t)v->y << 16) + 0x00070007;
}

/*
 * Most triangles lie in one tile: then their corners' places agree in all bits above it. A carry from x to y comes from
 * x < 0, which is on no tile.
 */
typedef enum where { NOWHERE, ONE_TILE, SOMEWHERE } where;

static inline where find_tile(const grid *g, const glint_vertex *const v[3], uint32_t *tile) {
    const uint32_t a = place_of(v[0]), differ = (a ^ place_of(v[1])) | (a ^ place_of(v[2]));
    if (!(differ & 0xfff0) || !(differ >> 20))
        return NOWHERE;
    /* Off the screen, a half or its difference from the last one is below 0. */
    if ((differ & g->above) | ((a | (g->last - a)) & 0x80008000))
        return SOMEWHERE;
    *tile = (a >> g->shift_y) * g->columns + ((a & 0xffff) >> g->shift_x) - g->first;
    return ONE_TILE;
}

/* Bins triangles that cull saw. @return how many, before the arena is full. */
static GLINT_NOINLINE int bin_seen(glint_frame *frame, glint_draw *draw, const uint16_t *seen, int count) {
    const uint32_t ready = draw->evaluation->light_triangle ? 0 : GLINT_VERTEX_NORMAL;
    const uint32_t most = most_references(frame);
    const grid g = grid_of(frame);
    const uint16_t *next = seen;
    for (const uint16_t *end = seen + count; next < end;) {
        const uint32_t triangle = *next++;
        const uint16_t *indices = draw->triangles[triangle];
        const glint_vertex *const v[3] = {&draw->vertices[indices[0]], &draw->vertices[indices[1]],
                                          &draw->vertices[indices[2]]};
        const uint32_t flags = v[0]->flags & v[1]->flags & v[2]->flags;
        uint32_t tile;
        const where place = find_tile(&g, v, &tile);
        if (place == SOMEWHERE) {
            if (!bin_whole(frame, draw, triangle))
                return (int)(next - seen) - 1;
        } else if (place == NOWHERE) {
            frame->stats.outside++;
        } else if (tile < g.count) {
            if (frame->reference_count >= most)
                return (int)(next - seen) - 1;
            if (!(flags & ready))
                light(frame, draw, triangle);
            append(frame, tile, draw->first + triangle);
        }
    }
    return count;
}

/* The same, of draws that cull takes all of, or in a small library. */
static int bin_each(glint_frame *frame, glint_draw *draw, const uint16_t *seen, int count) {
    int i = 0;
    while (i < count && bin_any(frame, draw, seen[i]))
        i++;
    return i;
}

/* Bins the triangles of a draw from frame->triangle on. @return 1, 0 when the arena is full, or an error. */
static int bin_draw(glint_frame *frame, glint_draw *draw) {
    uint16_t seen[GLINT_SEEN_MAX];
    uint32_t next = frame->triangle - draw->first_triangle;
    const int closely = GLINT_SMALL || glint_takes_all(draw);
    while (next < draw->count) {
        uint32_t from = next;
        int count = glint_cull(draw, &next, seen);
        if (count < 0)
            return count;
        int binned = closely ? bin_each(frame, draw, seen, count) : bin_seen(frame, draw, seen, count);
        uint32_t end = binned < count ? seen[binned] : next;
        frame->stats.triangles += end - from;
        frame->stats.facing_away += end - from - (uint32_t)binned;
        frame->triangle = draw->first_triangle + end;
        if (binned < count)
            return 0;
    }
    return 1;
}

/* @return 0 when the arena cannot hold the lists. */
static int begin_lists(glint_frame *frame) {
    const uint32_t tiles = glint_pass_tiles(frame);
    frame->memory.low = frame->vertices_end;
    frame->lists = glint_take(&frame->memory, tiles * sizeof *frame->lists);
    frame->clipped = (glint_clipped *)(void *)(frame->memory.base + frame->memory.high);
    frame->reference_count = tiles;
    if (!frame->lists)
        return 0;
    frame->references = (glint_reference *)(void *)frame->lists;
    for (uint32_t i = 0; i < tiles; i++)
        frame->lists[i] = (glint_list){GLINT_LIST_END, (uint16_t)i};
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
