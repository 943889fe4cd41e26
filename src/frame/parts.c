/* SPDX-License-Identifier: MIT */
/*
 * Loads parts of objects, where not all vertices fit. A part has those triangles of an object that face the eye and
 * that some tiles may show, an index list of its own, and the vertices that it names. Once a frame, the tiles that runs
 * of triangles may show are found.
 */
#include "frame.h"

/* ---- Triangles of an object, in order ---- */

/* These are the flags of a cached vertex that is not there yet. */
#define UNSEEN 0xffffu

/* The sight lies in the room that is kept for binning. */
typedef char sight_fits_reserve[sizeof(glint_sight) <= GLINT_BIN_RESERVE ? 1 : -1];

int glint_sight_begin(glint_sight *sight, glint_frame *frame, const glint_object *object) {
    const glint_mesh *const mesh = object->mesh;
    const glint_cull *const cull = glint_cull_of(mesh);
    glint_transform_prepare(&sight->transform, frame->view, &frame->config, object); /* the view met no error */
    if (!sight->transform.visible)
        return 0;
    glint_transform_place(&sight->transform, frame->view);
    sight->frame = frame;
    sight->mesh = mesh;
    sight->find_corners = cull ? cull->corners : mesh->triangles ? 0 : mesh->layout->triangles.type->stage->corners;
    sight->bring = glint_transform_of(mesh);
    sight->position = sight->transform.clips ? &sight->clipped : 0;
    sight->cached = 0;
    if (cull)
        cull->begin(&sight->walk, mesh, &sight->transform);
    return 1;
}

/* Returns the bytes of a cache of vertices: no more than `room`, nor than are worth having. */
static size_t cache_size(size_t room) {
    size_t count = room < 256 ? 0 : 1024;
    while (count * sizeof(glint_vertex) > room)
        count /= 2;
    return GLINT_ALIGNED(count * sizeof(glint_vertex));
}

/* Gives a sight memory for a cache of vertices. */
static void begin_cache(glint_sight *sight, void *memory, size_t size) {
    sight->cache = memory;
    sight->cached = (uint32_t)(size / sizeof(glint_vertex));
    for (uint32_t i = 0; i < sight->cached; i++)
        sight->cache[i].flags = UNSEEN;
}

/* Finds corners on the screen: in the cache, unless two of them share a place there. */
static void look_at_corners(glint_sight *sight, const uint16_t *index, const glint_vertex *v[3]) {
    const uint32_t mask = sight->cached - 1u;
    const int is_apart = sight->cached && ((index[0] ^ index[1]) & mask) && ((index[1] ^ index[2]) & mask) &&
                         ((index[0] ^ index[2]) & mask);
    for (int i = 0; i < 3; i++) {
        glint_vertex *const vertex = is_apart ? &sight->cache[index[i] & mask] : &sight->own[i];
        if (!is_apart || vertex->flags == UNSEEN || (uint16_t)vertex->attribute[0] != index[i]) {
            sight->bring(&sight->transform, sight->mesh, index[i], 1, vertex, sight->position);
            sight->frame->stats.vertices++;
        }
        v[i] = vertex;
    }
}

/* Finds the tiles of each triangle that clipping leaves. @return how many there are */
static GLINT_NOINLINE int find_clipped(glint_sight *sight, const uint16_t *index, glint_range *tiles) {
    const glint_transform *transform = &sight->transform;
    glint_corner corners[GLINT_CLIP_CORNERS] = {0};
    glint_vertex *const own = sight->own;
    const glint_vertex *const v[3] = {&own[0], &own[1], &own[2]};
    int parts = 0;
    for (int i = 0; i < 3; i++)
        glint_transform_vertices(transform, sight->mesh, index[i], 1, &own[i], &corners[i].position);
    const int count = glint_clip(transform, corners);
    for (int last = 2; last < count; last++) {
        for (int i = 0; i < 3; i++)
            glint_project(transform, &corners[i ? last - 2 + i : 0].position, &own[i]);
        if (glint_faces(transform->mirrored, (sight->mesh->flags & GLINT_MESH_DOUBLE_SIDED) != 0, v) &&
            glint_find_tiles(sight->frame, v, &tiles[parts]))
            parts++;
    }
    sight->is_clipped = 1;
    if (parts)
        return parts;
    sight->frame->stats.triangles++;
    sight->frame->stats.clipped++;
    return 0;
}

int glint_sight_next(glint_sight *sight, uint32_t number, glint_range tiles[GLINT_CLIP_CORNERS - 2]) {
    const glint_mesh *mesh = sight->mesh;
    const uint16_t *const index =
        sight->find_corners ? sight->find_corners(&sight->walk, mesh, number) : mesh->triangles[number];
    const glint_vertex *v[3];
    sight->corners = index;
    sight->is_clipped = 0;
    if (index[0] >= mesh->vertex_count || index[1] >= mesh->vertex_count || index[2] >= mesh->vertex_count)
        return GLINT_ERROR_INDEX;
    const int has_area = index[0] != index[1]; /* triangles of clusters that face away have none */
    if (has_area) {
        look_at_corners(sight, index, v);
        if ((v[0]->flags | v[1]->flags | v[2]->flags) & GLINT_VERTEX_CLIP)
            return find_clipped(sight, index, tiles);
    }
    if (!has_area || !glint_faces(sight->transform.mirrored, (mesh->flags & GLINT_MESH_DOUBLE_SIDED) != 0, v)) {
        sight->frame->stats.triangles++;
        sight->frame->stats.facing_away++;
        return 0;
    }
    return glint_find_tiles(sight->frame, v, tiles);
}

/* ---- Extents: the tiles that runs of triangles may show ---- */

/*
 * The tiles that 2^frame->extent_shift consecutive triangles of a mesh may show. Right and bottom are exclusive, and
 * NO_END stands for all tiles there are.
 */
struct glint_extent {
    uint8_t left, top, right, bottom;
};

#define NO_END 255

static void add_tiles(struct glint_extent *extent, const glint_range *tiles) {
    extent->left = (uint8_t)glint_least(extent->left, tiles->left);
    extent->top = (uint8_t)glint_least(extent->top, tiles->top);
    extent->right = (uint8_t)glint_most(extent->right, glint_least(tiles->right, NO_END));
    extent->bottom = (uint8_t)glint_most(extent->bottom, glint_least(tiles->bottom, NO_END));
}

/* Returns the extents of a mesh of so many triangles. */
static inline uint32_t count_extents(const glint_frame *frame, uint32_t triangles) {
    return (triangles + (1u << frame->extent_shift) - 1) >> frame->extent_shift;
}

/* Chooses the length of a run, a power of two: the shortest whose extents use an eighth of the free bytes at most.
 * @return 0 where no length does */
static int choose_shift(glint_frame *frame, uint32_t *count) {
    const glint_scene *scene = frame->scene;
    const size_t room = frame->memory.high - frame->memory.low;
    for (frame->extent_shift = 4; frame->extent_shift <= 16; frame->extent_shift++) {
        *count = 0;
        for (uint32_t i = 0; i < scene->object_count; i++)
            *count += count_extents(frame, scene->objects[i].mesh->triangle_count);
        const size_t size = GLINT_ALIGNED(*count * sizeof(struct glint_extent)) + GLINT_ALIGNMENT;
        if (size <= room / 8 && room - size >= frame->least_room)
            return 1;
    }
    return 0;
}

static glint_status find_extents_of(glint_frame *frame, const glint_object *object, struct glint_extent *extents) {
    const size_t size = cache_size((frame->memory.high - frame->memory.low) / 2);
    glint_sight *const sight = glint_sight_of(frame);
    if (!glint_sight_begin(sight, frame, object)) {
        frame->stats.hidden++;
        return GLINT_OK;
    }
    begin_cache(sight, frame->memory.base + GLINT_ALIGNED(frame->memory.low), size);
    for (uint32_t i = 0; i < object->mesh->triangle_count; i++) {
        glint_range tiles[GLINT_CLIP_CORNERS - 2];
        const int parts = glint_sight_next(sight, i, tiles);
        if (parts < 0)
            return (glint_status)parts;
        for (int part = 0; part < parts; part++)
            add_tiles(&extents[i >> frame->extent_shift], &tiles[part]);
    }
    return GLINT_OK;
}

/* Finds the extents of all objects, where there is room for them. */
static glint_status find_extents(glint_frame *frame) {
    const glint_scene *scene = frame->scene;
    const glint_stats before = frame->stats;
    uint32_t count;
    glint_status status = GLINT_OK;
    if (!choose_shift(frame, &count))
        return GLINT_OK;
    struct glint_extent *extent = glint_take(&frame->memory, count * sizeof *extent);
    frame->extents = extent;
    frame->prepared_end = frame->memory.low;
    for (uint32_t i = 0; i < count; i++)
        extent[i] = (struct glint_extent){NO_END, NO_END, 0, 0};
    for (uint32_t i = 0; i < scene->object_count && status == GLINT_OK; i++) {
        status = find_extents_of(frame, glint_object_at(frame, i), extent);
        extent += count_extents(frame, glint_object_at(frame, i)->mesh->triangle_count);
    }
    frame->stats.triangles = before.triangles; /* triangles are counted where they are drawn or dropped */
    frame->stats.facing_away = before.facing_away;
    frame->stats.clipped = before.clipped;
    return status;
}

/* ---- Strips: the tiles of a pass ---- */

/* Tiles that follow each other, from a row and a column to another, both included. */
typedef struct strip {
    int32_t first_row, first_column, last_row, last_column;
} strip;

/* Returns the tiles from frame->tile_first to before `end`. */
static strip strip_to(const glint_frame *frame, uint32_t end) {
    const int32_t columns = frame->tile_columns, first = frame->tile_first;
    const int32_t last = (int32_t)(end < frame->tile_count ? end : frame->tile_count) - 1;
    return (strip){first / columns, first % columns, last / columns, last % columns};
}

/* Is one of some tiles in a strip? */
static int is_in_strip(const strip *s, const glint_range *tiles) {
    const int32_t top = glint_most(tiles->top, s->first_row), bottom = glint_least(tiles->bottom - 1, s->last_row);
    if (top > bottom) /* an empty range has no rows */
        return 0;
    const int starts = tiles->right > s->first_column, ends = tiles->left <= s->last_column;
    if (s->first_row == s->last_row)
        return starts && ends;
    return (starts && top == s->first_row) || (ends && bottom == s->last_row) ||
           glint_most(top, s->first_row + 1) <= glint_least(bottom, s->last_row - 1);
}

/* May triangles of an extent, counted through all objects, be visible in a strip? */
static int is_extent_in_strip(const glint_frame *frame, const strip *s, uint32_t index) {
    if (!frame->extents)
        return 1;
    const struct glint_extent *e = &frame->extents[index];
    const glint_range tiles = {e->left, e->top, e->right, e->bottom};
    return is_in_strip(s, &tiles);
}

/* ---- Parts ---- */

/* A draw can hold so many vertices of a part, and twice as many triangles. */
#define PART_VERTICES_MAX 0x6000

/*
 * A part on its way. Triangles are listed from the arena's low end on, where they stay. All else waits at the high end:
 * first the numbers of vertices, until these are loaded, then what is needed only while triangles are found.
 */
typedef struct object_part {
    uint16_t (*list)[3];
    uint16_t *origin; /* numbers of triangles, from the first on */
    uint16_t *index;  /* numbers of vertices in the mesh */
    uint16_t *map;    /* slot + 1 or 0, by a vertex's number: open addressing */
    uint32_t mask;
    uint32_t vertices, triangles, most_vertices, most_triangles;
    int is_short; /* of room for vertices */
    glint_vertex *cache;
    size_t cache_size;
} object_part;

/* Returns the slot of a mesh's vertex, for which there is room. */
static uint32_t find_slot(object_part *p, uint32_t index) {
    uint32_t place = (index * 40503u) & p->mask;
    for (; p->map[place]; place = (place + 1) & p->mask)
        if (p->index[p->map[place] - 1] == index)
            return p->map[place] - 1u;
    p->index[p->vertices] = (uint16_t)index;
    p->map[place] = (uint16_t)(p->vertices + 1);
    return p->vertices++;
}

/* Returns the entries of a map for so many vertices. */
static uint32_t map_entries(uint32_t vertices) {
    uint32_t entries = 4;
    while (entries <= vertices)
        entries *= 2;
    return entries;
}

/* Returns the bytes that a part of so many vertices and twice as many triangles uses, with all that waits. */
static size_t part_size(const glint_frame *frame, const glint_object *object, const glint_transform *transform,
                        uint32_t vertices) {
    return glint_draw_size(frame, object, transform->clips, vertices, 2 * (size_t)vertices, 1) +
           2 * GLINT_ALIGNED(2 * vertices * sizeof(uint16_t)) + GLINT_ALIGNED(vertices * sizeof(uint16_t)) +
           GLINT_ALIGNED(map_entries(vertices) * sizeof(uint16_t));
}

/* Shares the free room out to a part of an object, of which so many triangles may be visible.
 * @return 0 when there is too little */
static int share_room(glint_frame *frame, const glint_object *object, const glint_transform *transform,
                      uint32_t triangles, object_part *p) {
    const size_t low = GLINT_ALIGNED(frame->memory.low), high = frame->memory.high;
    if (high < low + GLINT_BIN_RESERVE)
        return 0;
    const size_t room = high - low - GLINT_BIN_RESERVE, cache = cache_size(room / 6);
    const size_t fixed = part_size(frame, object, transform, 0), some = part_size(frame, object, transform, 256);
    const uint32_t all = object->mesh->vertex_count < 3 * triangles ? object->mesh->vertex_count : 3 * triangles;
    const uint32_t most = all < PART_VERTICES_MAX ? all : PART_VERTICES_MAX;
    if (room < fixed + cache)
        return 0;
    const size_t fit = (room - fixed - cache) / ((some - fixed) / 256) + 3; /* at least */
    uint32_t vertices = fit < most ? (uint32_t)fit : most;
    while (vertices && part_size(frame, object, transform, vertices) + cache > room)
        vertices -= (vertices + 15) / 16;
    if (vertices < most && vertices < 3) /* a mesh of fewer has no visible triangle */
        return 0;
    uint8_t *top = frame->memory.base + high - GLINT_BIN_RESERVE;
    top -= GLINT_ALIGNED(vertices * sizeof(uint16_t));
    p->index = (uint16_t *)(void *)top;
    p->mask = map_entries(vertices) - 1;
    top -= GLINT_ALIGNED((p->mask + 1) * sizeof(uint16_t));
    p->map = (uint16_t *)(void *)top;
    top -= cache;
    p->cache = (glint_vertex *)(void *)top;
    p->cache_size = cache;
    top -= GLINT_ALIGNED(2 * vertices * sizeof(uint16_t));
    p->origin = (uint16_t *)(void *)top;
    p->list = (uint16_t(*)[3])(void *)(frame->memory.base + low + GLINT_ALIGNED(sizeof(glint_draw)));
    p->vertices = p->triangles = 0;
    p->most_vertices = vertices;
    p->is_short = vertices < all;
    p->most_triangles = 2 * vertices;
    for (uint32_t i = 0; i <= p->mask; i++)
        p->map[i] = 0;
    return 1;
}

/* Lists triangles from frame->triangle on that may be visible in a strip, as far as there is room.
 * @return the number of the next, or GLINT_ERROR_INDEX */
static int32_t find_triangles(glint_frame *frame, const strip *s, uint32_t first_extent, glint_sight *sight,
                              object_part *p, uint32_t most) {
    const uint32_t count = sight->mesh->triangle_count, shift = frame->extents ? frame->extent_shift : 31;
    uint32_t i = frame->triangle;
    while (i < count) {
        const uint32_t extent = i >> shift, next = (extent + 1) << shift, end = next < count ? next : count;
        if (!is_extent_in_strip(frame, s, first_extent + extent)) {
            i = end;
            continue;
        }
        for (; i < end; i++) {
            glint_range tiles[GLINT_CLIP_CORNERS - 2];
            int part = glint_sight_next(sight, i, tiles);
            if (part < 0)
                return part;
            while (part && !is_in_strip(s, &tiles[part - 1]))
                part--;
            if (!part)
                continue;
            if (!p->triangles)
                frame->triangle = i; /* the part's first */
            if (p->triangles == p->most_triangles || p->triangles == most || i - frame->triangle > UINT16_MAX ||
                (p->vertices + 3 > p->most_vertices && p->is_short))
                return (int32_t)i;
            p->origin[p->triangles] = (uint16_t)(i - frame->triangle);
            for (int c = 0; c < 3; c++)
                p->list[p->triangles][c] = (uint16_t)find_slot(p, sight->corners[c]);
            p->triangles++;
        }
    }
    return (int32_t)count;
}

/* Adds the draw of a part whose triangles are found. */
static glint_draw *add_part(glint_frame *frame, glint_draw *last, const glint_transform *transform,
                            const object_part *p) {
    const glint_mesh *mesh = glint_object_at(frame, frame->object)->mesh;
    const size_t list = GLINT_ALIGNED(p->triangles * sizeof *p->list);
    glint_draw *draw = glint_add_draw(frame, last, transform, p->vertices, p->triangles,
                                      list + GLINT_ALIGNED(p->triangles * sizeof *p->origin));
    uint16_t *origin = (uint16_t *)(void *)((uint8_t *)p->list + list);
    for (uint32_t i = 0; i < p->triangles; i++) /* upwards, as they may overlap */
        origin[i] = p->origin[i];
    draw->triangles = (const uint16_t(*)[3])p->list;
    draw->origin = origin;
    draw->count = (uint16_t)p->triangles;
    draw->vertex_count = p->vertices;
    draw->cull = 0;
    for (uint32_t i = 0; i < p->vertices; i++)
        glint_load_vertices(frame, draw, mesh, p->index[i], i, 1);
    return draw;
}

/* Counts triangles of an object, from one on, whose extents are in a strip. */
static uint32_t count_shown(const glint_frame *frame, uint32_t object, uint32_t triangle, const strip *s,
                            uint32_t first_extent) {
    const uint32_t count = glint_object_at(frame, object)->mesh->triangle_count, shift = frame->extent_shift;
    uint32_t shown = 0;
    if (!frame->extents)
        return count - triangle;
    for (uint32_t e = triangle >> shift; e << shift < count; e++)
        shown += (uint32_t)is_extent_in_strip(frame, s, first_extent + e) << shift;
    return shown;
}

/* Loads a part of the present object behind the last draw. @return 1, 0 where not all fits, or an error */
static int load_object(glint_frame *frame, glint_draw **last, const strip *s, uint32_t first_extent) {
    const glint_object *object = glint_object_at(frame, frame->object);
    const uint32_t shown = count_shown(frame, frame->object, frame->triangle, s, first_extent);
    const uint32_t numbered = *last ? (uint32_t)(*last)->first + (*last)->count : 0;
    glint_sight *const sight = glint_sight_of(frame);
    object_part p;
    if (!shown && object->mesh->triangle_count)
        return 1;
    if (!glint_sight_begin(sight, frame, object)) {
        frame->stats.hidden += !frame->extents; /* extents have counted it */
        return 1;
    }
    if (!share_room(frame, object, &sight->transform, shown, &p))
        return 0;
    begin_cache(sight, p.cache, p.cache_size);
    const int32_t next = find_triangles(frame, s, first_extent, sight, &p, GLINT_TRIANGLES_MAX - numbered);
    if (next < 0)
        return next;
    if (p.triangles) {
        *last = add_part(frame, *last, &sight->transform, &p);
        (*last)->end = (uint32_t)next;
    }
    frame->triangle = (uint32_t)next;
    return frame->triangle == object->mesh->triangle_count;
}

/* Loads parts for a strip, as far as there is room. @return 1 to the scene's end, 0, or an error */
static int load_strip(glint_frame *frame, const strip *s) {
    const glint_scene *scene = frame->scene;
    uint32_t extent = 0;
    glint_draw *last = 0;
    int loaded = 1;
    frame->draws = 0;
    frame->memory.low = frame->prepared_end;
    for (uint32_t i = 0; i < frame->object; i++)
        extent += count_extents(frame, glint_object_at(frame, i)->mesh->triangle_count);
    for (; frame->object < scene->object_count; frame->object++, frame->triangle = 0) {
        loaded = load_object(frame, &last, s, extent);
        if (loaded <= 0)
            break;
        extent += count_extents(frame, glint_object_at(frame, frame->object)->mesh->triangle_count);
    }
    return loaded == 0 && !last ? GLINT_ERROR_ARENA : loaded;
}

/* ---- Passes ---- */

/* Counts triangles of the scene that may be visible on so many tiles. */
static uint32_t count_all_shown(const glint_frame *frame, uint32_t tiles) {
    const strip s = strip_to(frame, frame->tile_first + tiles);
    uint32_t shown = 0, extent = 0;
    for (uint32_t i = 0; i < frame->scene->object_count; i++) {
        shown += count_shown(frame, i, 0, &s, extent);
        extent += count_extents(frame, glint_object_at(frame, i)->mesh->triangle_count);
    }
    return shown;
}

/* Chooses how many tiles to load for: as many as last time, halved or doubled as far as the arena is likely to hold. */
static void choose_tiles(glint_frame *frame) {
    const size_t most = (frame->memory.high - frame->prepared_end) / frame->part_bytes;
    while (frame->pass_tiles > 1 && count_all_shown(frame, frame->pass_tiles) > most)
        frame->pass_tiles = (uint16_t)((frame->pass_tiles + 1) / 2);
    while (frame->pass_tiles < frame->tile_count && count_all_shown(frame, 2u * frame->pass_tiles) <= most)
        frame->pass_tiles =
            (uint16_t)(2u * frame->pass_tiles < frame->tile_count ? 2u * frame->pass_tiles : frame->tile_count);
}

/* A triangle that may be visible uses about so much of the arena: half face the eye, each with a vertex and its
 * references. */
#define PART_BYTES 28

static glint_status begin_parts(glint_frame *frame) {
    frame->memory.low = frame->prepared_end;
    frame->stats.hidden = 0;
    frame->has_extents = 1;
    frame->part_bytes = PART_BYTES;
    return find_extents(frame);
}

glint_status glint_load_parts(glint_frame *frame) {
    const uint32_t object = frame->object, triangle = frame->triangle;
    const glint_status status = frame->has_extents ? GLINT_OK : begin_parts(frame);
    if (status != GLINT_OK)
        return status;
    if (object || triangle)
        frame->pass_tiles = 1; /* the rest of a tile's triangles are left */
    else if (frame->extents)
        choose_tiles(frame);
    for (;;) {
        const uint32_t end = (uint32_t)frame->tile_first + frame->pass_tiles;
        const strip s = strip_to(frame, end);
        const int loaded = load_strip(frame, &s);
        frame->object = object;
        frame->triangle = triangle;
        if (loaded > 0 || frame->pass_tiles == 1 || (loaded < 0 && loaded != GLINT_ERROR_ARENA)) {
            frame->covers_end = loaded > 0;
            frame->loaded_end = (uint16_t)(end < frame->tile_count ? end : frame->tile_count);
            frame->vertices_end = frame->memory.low;
            return loaded < 0 ? (glint_status)loaded : GLINT_OK;
        }
        frame->pass_tiles = (uint16_t)((frame->pass_tiles + 1) / 2);
        if (frame->part_bytes < frame->memory.high) /* beyond, this size adds no tile to a pass */
            frame->part_bytes += frame->part_bytes / 2;
    }
}
