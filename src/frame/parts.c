/* SPDX-License-Identifier: MIT */
/*
 * Loads parts of objects, where not all vertices fit. A part has those triangles of an object that face the eye and
 * that some tiles may show, an index list of its own, and the vertices that it names. Which tiles runs of triangles may
 * show is found once a frame.
 */
#include "frame.h"

/* ---- Triangles of an object ---- */

/* ---- Sight: triangles of an object, and the tiles that they may show ---- */

/* Flags of a place where no vertex is. */
#define UNSEEN 0xffffu

size_t glint_sight_size(size_t room) {
    size_t count = room < 256 ? 0 : 1024;
    while (count * sizeof(glint_vertex) > room)
        count /= 2;
    return GLINT_ALIGNED(count * sizeof(glint_vertex));
}

/* It fits there. */
typedef char sight_fits_reserve[sizeof(glint_sight) <= GLINT_BIN_RESERVE ? 1 : -1];

void glint_sight_begin(glint_sight *sight, glint_frame *frame, const glint_object *object, void *memory, size_t size) {
    sight->frame = frame;
    sight->mesh = object->mesh;
    const glint_cull *cull = glint_cull_of(object->mesh);
    sight->corners = cull                      ? cull->corners
                     : object->mesh->triangles ? 0
                                               : object->mesh->layout->triangles.type->stage->corners;
    sight->bring = glint_transform_of(object->mesh);
    sight->position = sight->transform.clips ? &sight->clipped : 0;
    sight->seen = memory;
    sight->seen_count = (uint32_t)(size / sizeof(glint_vertex));
    for (uint32_t i = 0; i < sight->seen_count; i++)
        sight->seen[i].flags = UNSEEN;
    if (cull)
        cull->begin(&sight->walk, object->mesh, &sight->transform);
}

static inline void see(glint_sight *sight, uint32_t index, glint_vertex *vertex) {
    sight->bring(&sight->transform, sight->mesh, index, 1, vertex, sight->position);
    sight->frame->stats.vertices++;
}

/* Finds corners on the screen: among those that were seen, unless two have the same place there. */
static void see_corners(glint_sight *sight, const uint32_t index[3], const glint_vertex *v[3]) {
    const uint32_t mask = sight->seen_count - 1;
    const int is_apart = sight->seen_count && ((index[0] ^ index[1]) & mask) && ((index[1] ^ index[2]) & mask) &&
                         ((index[0] ^ index[2]) & mask);
    for (int i = 0; i < 3; i++) {
        glint_vertex *const vertex = is_apart ? &sight->seen[index[i] & mask] : &sight->own[i];
        if (!is_apart || vertex->flags == UNSEEN || (uint16_t)vertex->attribute[0] != index[i])
            see(sight, index[i], vertex);
        v[i] = vertex;
    }
}

/* The tiles of what clipping leaves of a triangle. @return 0 when that shows on none */
static GLINT_NOINLINE int find_clipped(glint_sight *sight, const uint32_t index[3], glint_range *tiles) {
    const glint_transform *transform = &sight->transform;
    glint_corner corners[GLINT_CLIP_CORNERS] = {0};
    glint_vertex *const own = sight->own;
    const glint_vertex *const v[3] = {&own[0], &own[1], &own[2]};
    for (int i = 0; i < 3; i++)
        glint_transform_vertices(transform, sight->mesh, index[i], 1, &own[i], &corners[i].position);
    const int count = glint_clip(transform, corners);
    *tiles = (glint_range){INT32_MAX, INT32_MAX, 0, 0};
    for (int last = 2; last < count; last++) {
        glint_range part;
        for (int i = 0; i < 3; i++)
            glint_project(transform, &corners[i ? last - 2 + i : 0].position, &own[i]);
        if (!glint_faces(transform->mirrored, (sight->mesh->flags & GLINT_MESH_DOUBLE_SIDED) != 0, v) ||
            !glint_find_tiles(sight->frame, v, &part))
            continue;
        tiles->left = glint_least(tiles->left, part.left);
        tiles->top = glint_least(tiles->top, part.top);
        tiles->right = glint_most(tiles->right, part.right);
        tiles->bottom = glint_most(tiles->bottom, part.bottom);
    }
    if (tiles->left < tiles->right)
        return 1;
    sight->frame->stats.triangles++;
    sight->frame->stats.clipped++;
    return 0;
}

static inline void drop(const glint_sight *sight) {
    sight->frame->stats.triangles++;
    sight->frame->stats.facing_away++;
}

const uint16_t *glint_sight_next(glint_sight *sight, uint32_t number, glint_range *tiles, glint_status *status) {
    const glint_mesh *mesh = sight->mesh;
    const uint16_t *corners = sight->corners ? sight->corners(&sight->walk, mesh, number) : mesh->triangles[number];
    const uint32_t index[3] = {corners[0], corners[1], corners[2]};
    const glint_vertex *v[3];
    *status = GLINT_OK;
    if (index[0] >= mesh->vertex_count || index[1] >= mesh->vertex_count || index[2] >= mesh->vertex_count) {
        *status = GLINT_ERROR_INDEX;
        return 0;
    }
    if (index[0] == index[1]) { /* without area; so are those of clusters that face away */
        drop(sight);
        return 0;
    }
    see_corners(sight, index, v);
    if ((v[0]->flags | v[1]->flags | v[2]->flags) & GLINT_VERTEX_CLIP)
        return find_clipped(sight, index, tiles) ? corners : 0;
    if (!glint_faces(sight->transform.mirrored, (mesh->flags & GLINT_MESH_DOUBLE_SIDED) != 0, v)) {
        drop(sight);
        return 0;
    }
    return glint_find_tiles(sight->frame, v, tiles) ? corners : 0;
}

/* ---- Extents ---- */

/* As far as there is. */
#define NO_END 255

static void add_tiles(glint_extent *extent, const glint_range *tiles) {
    extent->left = (uint8_t)glint_least(extent->left, tiles->left);
    extent->top = (uint8_t)glint_least(extent->top, tiles->top);
    extent->right = (uint8_t)glint_most(extent->right, glint_least(tiles->right, NO_END));
    extent->bottom = (uint8_t)glint_most(extent->bottom, glint_least(tiles->bottom, NO_END));
}

/* Triangles of an extent, a power of two: as few as take an eighth of what is free. @return 0 where no number does */
static int choose_shift(glint_frame *frame, uint32_t *count) {
    const glint_scene *scene = frame->scene;
    const size_t room = frame->memory.high - frame->memory.low;
    for (frame->extent_shift = 4; frame->extent_shift <= 16; frame->extent_shift++) {
        *count = 0;
        for (uint32_t i = 0; i < scene->object_count; i++)
            *count += glint_extents_of(frame, scene->objects[i].mesh->triangle_count);
        const size_t size = GLINT_ALIGNED(*count * sizeof(glint_extent)) + GLINT_ALIGNMENT;
        if (size <= room / 8 && room - size >= frame->least_room)
            return 1;
    }
    return 0;
}

static glint_status find_of_object(glint_frame *frame, const glint_object *object, glint_extent *extents) {
    const size_t room = frame->memory.high - frame->memory.low, size = glint_sight_size(room / 2);
    uint8_t *const memory = frame->memory.base + GLINT_ALIGNED(frame->memory.low);
    glint_sight *const sight = glint_sight_of(frame);
    glint_status status = glint_transform_prepare(&sight->transform, frame->view, &frame->config, object);
    frame->stats.hidden += status == GLINT_OK && !sight->transform.visible;
    if (status != GLINT_OK || !sight->transform.visible)
        return status;
    glint_transform_place(&sight->transform, frame->view);
    glint_sight_begin(sight, frame, object, memory, size);
    for (uint32_t i = 0; i < object->mesh->triangle_count && status == GLINT_OK; i++) {
        glint_range tiles;
        if (glint_sight_next(sight, i, &tiles, &status))
            add_tiles(&extents[i >> frame->extent_shift], &tiles);
    }
    return status;
}

glint_status glint_extents_find(glint_frame *frame) {
    const glint_scene *scene = frame->scene;
    const uint32_t triangles = frame->stats.triangles, away = frame->stats.facing_away, clipped = frame->stats.clipped;
    uint32_t count;
    glint_status status = GLINT_OK;
    if (!choose_shift(frame, &count))
        return GLINT_OK;
    glint_extent *extent = glint_take(&frame->memory, count * sizeof *extent);
    frame->extents = extent;
    frame->prepared_end = frame->memory.low;
    for (uint32_t i = 0; i < count; i++)
        extent[i] = (glint_extent){NO_END, NO_END, 0, 0};
    for (uint32_t i = 0; i < scene->object_count && status == GLINT_OK; i++) {
        status = find_of_object(frame, &scene->objects[i], extent);
        extent += glint_extents_of(frame, scene->objects[i].mesh->triangle_count);
    }
    frame->stats.triangles = triangles; /* counted where they are drawn or dropped */
    frame->stats.facing_away = away;
    frame->stats.clipped = clipped;
    return status;
}

void glint_strip_begin(glint_strip *strip, const glint_frame *frame, uint32_t end) {
    const int32_t columns = frame->tile_columns, first = frame->tile_first, last = (int32_t)end - 1;
    strip->first_row = first / columns;
    strip->last_row = last / columns;
    strip->first_column = first % columns;
    strip->last_column = last % columns;
}

int glint_is_in_strip(const glint_strip *strip, const glint_range *tiles) {
    const int32_t top = glint_most(tiles->top, strip->first_row),
                  bottom = glint_least(tiles->bottom - 1, strip->last_row);
    if (top > bottom) /* where a range is empty, its rows are */
        return 0;
    const int starts = tiles->right > strip->first_column, ends = tiles->left <= strip->last_column;
    if (strip->first_row == strip->last_row)
        return starts && ends;
    return (starts && top == strip->first_row) || (ends && bottom == strip->last_row) ||
           glint_most(top, strip->first_row + 1) <= glint_least(bottom, strip->last_row - 1);
}

int glint_extent_shows(const glint_frame *frame, const glint_strip *strip, uint32_t index) {
    if (!frame->extents)
        return 1;
    const glint_extent *e = &frame->extents[index];
    const glint_range tiles = {e->left, e->top, e->right, e->bottom};
    return glint_is_in_strip(strip, &tiles);
}

/* ---- Parts ---- */

/* Vertices of a part, and twice as many triangles, still fit a draw. */
#define PART_VERTICES_MAX 0x6000

/*
 * A part on its way. Triangles are listed from the arena's low end on, where they stay; all else waits at the high end:
 * the numbers in the mesh of vertices, until they are loaded, then what is needed only while triangles are found.
 */
typedef struct object_part {
    uint16_t (*list)[3];
    uint16_t *origin; /* numbers of triangles, from the first on */
    uint16_t *index;  /* numbers of vertices in the mesh */
    uint16_t *map;    /* slot + 1 or 0, by a vertex's number: open addressing */
    uint32_t mask;
    uint32_t vertices, triangles, most_vertices, most_triangles;
    int is_short; /* of room for vertices */
    glint_vertex *seen;
    size_t seen_size;
} object_part;

/* The slot of a mesh's vertex, for which there is room. */
static uint32_t find_slot(object_part *p, uint32_t index) {
    uint32_t place = (index * 40503u) & p->mask;
    for (; p->map[place]; place = (place + 1) & p->mask)
        if (p->index[p->map[place] - 1] == index)
            return p->map[place] - 1u;
    p->index[p->vertices] = (uint16_t)index;
    p->map[place] = (uint16_t)(p->vertices + 1);
    return p->vertices++;
}

/* Entries of a map for so many vertices. */
static uint32_t map_entries(uint32_t vertices) {
    uint32_t entries = 4;
    while (entries <= vertices)
        entries *= 2;
    return entries;
}

/* Bytes that a part of so many vertices and twice as many triangles takes, all that waits included. */
static size_t part_size(const glint_frame *frame, const glint_object *object, const glint_transform *transform,
                        uint32_t vertices) {
    return glint_draw_size(frame, object, transform, vertices, 2 * (size_t)vertices, 1) +
           2 * GLINT_ALIGNED(2 * vertices * sizeof(uint16_t)) + GLINT_ALIGNED(vertices * sizeof(uint16_t)) +
           GLINT_ALIGNED(map_entries(vertices) * sizeof(uint16_t));
}

/* Shares the free room out to a part of an object, some of whose triangles may show. @return 0 when there is too little
 */
static int share_room(glint_frame *frame, const glint_object *object, const glint_transform *transform,
                      uint32_t triangles, object_part *p) {
    const size_t low = GLINT_ALIGNED(frame->memory.low), high = frame->memory.high;
    if (high < low + GLINT_BIN_RESERVE)
        return 0;
    const size_t room = high - low - GLINT_BIN_RESERVE, seen = glint_sight_size(room / 6);
    const size_t fixed = part_size(frame, object, transform, 0), some = part_size(frame, object, transform, 256);
    const uint32_t all = object->mesh->vertex_count < 3 * triangles ? object->mesh->vertex_count : 3 * triangles;
    const uint32_t most = all < PART_VERTICES_MAX ? all : PART_VERTICES_MAX;
    if (room < fixed + seen)
        return 0;
    const size_t fit = (room - fixed - seen) / ((some - fixed) / 256) + 3; /* at least */
    uint32_t vertices = fit < most ? (uint32_t)fit : most;
    while (vertices && part_size(frame, object, transform, vertices) + seen > room)
        vertices -= (vertices + 15) / 16;
    if (vertices < most && vertices < 3) /* a mesh of fewer has no triangle that shows */
        return 0;
    uint8_t *top = frame->memory.base + high - GLINT_BIN_RESERVE;
    top -= GLINT_ALIGNED(vertices * sizeof(uint16_t));
    p->index = (uint16_t *)(void *)top;
    p->mask = map_entries(vertices) - 1;
    top -= GLINT_ALIGNED((p->mask + 1) * sizeof(uint16_t));
    p->map = (uint16_t *)(void *)top;
    top -= seen;
    p->seen = (glint_vertex *)(void *)top;
    p->seen_size = seen;
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

/* Lists triangles from frame->triangle on that show in a strip, as far as there is room. @return the next's number */
static uint32_t find_triangles(glint_frame *frame, const glint_strip *strip, uint32_t first_extent, glint_sight *sight,
                               object_part *p, uint32_t most, glint_status *status) {
    const uint32_t count = sight->mesh->triangle_count, shift = frame->extents ? frame->extent_shift : 31;
    uint32_t i = frame->triangle;
    *status = GLINT_OK;
    while (i < count) {
        const uint32_t extent = i >> shift, next = (extent + 1) << shift, end = next < count ? next : count;
        if (!glint_extent_shows(frame, strip, first_extent + extent)) {
            i = end;
            continue;
        }
        for (; i < end; i++) {
            glint_range tiles;
            const uint16_t *corners = glint_sight_next(sight, i, &tiles, status);
            if (*status != GLINT_OK)
                return i;
            if (!corners || !glint_is_in_strip(strip, &tiles))
                continue;
            if (!p->triangles)
                frame->triangle = i; /* the part's first */
            if (p->triangles == p->most_triangles || p->triangles == most || i - frame->triangle > UINT16_MAX ||
                (p->vertices + 3 > p->most_vertices && p->is_short))
                return i;
            p->origin[p->triangles] = (uint16_t)(i - frame->triangle);
            for (int c = 0; c < 3; c++)
                p->list[p->triangles][c] = (uint16_t)find_slot(p, corners[c]);
            p->triangles++;
        }
    }
    return count;
}

/* The draw of a part whose triangles are found. */
static glint_draw *add_part(glint_frame *frame, glint_draw *last, const glint_transform *transform,
                            const object_part *p) {
    const glint_mesh *mesh = frame->scene->objects[frame->object].mesh;
    const size_t list = GLINT_ALIGNED(p->triangles * sizeof *p->list);
    glint_draw *draw = glint_add_draw(frame, last, transform, p->vertices, p->triangles,
                                      list + GLINT_ALIGNED(p->triangles * sizeof *p->origin));
    uint16_t *origin = (uint16_t *)(void *)((uint8_t *)p->list + list);
    for (uint32_t i = 0; i < p->triangles; i++) /* upwards: they may overlap */
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

/* Triangles of an object, from one on, whose extents show in a strip. */
static uint32_t count_shown(const glint_frame *frame, uint32_t object, uint32_t triangle, const glint_strip *strip,
                            uint32_t first_extent) {
    const uint32_t count = frame->scene->objects[object].mesh->triangle_count, shift = frame->extent_shift;
    uint32_t shown = 0;
    if (!frame->extents)
        return count - triangle;
    for (uint32_t e = triangle >> shift; e << shift < count; e++)
        shown += (uint32_t)glint_extent_shows(frame, strip, first_extent + e) << shift;
    return shown;
}

/* A part of the present object behind the last draw. @return 1, 0 where not all fits, or an error */
static int load_object(glint_frame *frame, glint_draw **last, const glint_strip *strip, uint32_t first_extent) {
    const glint_object *object = &frame->scene->objects[frame->object];
    const uint32_t shown = count_shown(frame, frame->object, frame->triangle, strip, first_extent);
    const uint32_t numbered = *last ? (uint32_t)(*last)->first + (*last)->count : 0;
    glint_sight *const sight = glint_sight_of(frame);
    const glint_transform *const transform = &sight->transform;
    glint_status status;
    object_part p;
    if (!shown && object->mesh->triangle_count)
        return 1;
    glint_transform_prepare(&sight->transform, frame->view, &frame->config, object);
    if (!transform->visible) {
        frame->stats.hidden += !frame->extents; /* with them, it has been counted */
        return 1;
    }
    glint_transform_place(&sight->transform, frame->view);
    if (!share_room(frame, object, transform, shown, &p))
        return 0;
    glint_sight_begin(sight, frame, object, p.seen, p.seen_size);
    const uint32_t next =
        find_triangles(frame, strip, first_extent, sight, &p, GLINT_TRIANGLES_MAX - numbered, &status);
    if (status != GLINT_OK)
        return status;
    if (p.triangles) {
        *last = add_part(frame, *last, transform, &p);
        (*last)->end = next;
    }
    frame->triangle = next;
    return next == object->mesh->triangle_count;
}

/* Loads parts for a strip, as far as there is room. @return 1 to the scene's end, 0, or an error */
static int load_strip(glint_frame *frame, const glint_strip *strip) {
    const glint_scene *scene = frame->scene;
    uint32_t extent = 0;
    glint_draw *last = 0;
    int loaded = 1;
    frame->draws = 0;
    frame->memory.low = frame->prepared_end;
    for (uint32_t i = 0; i < frame->object; i++)
        extent += glint_extents_of(frame, scene->objects[i].mesh->triangle_count);
    for (; frame->object < scene->object_count; frame->object++, frame->triangle = 0) {
        loaded = load_object(frame, &last, strip, extent);
        if (loaded <= 0)
            break;
        extent += glint_extents_of(frame, scene->objects[frame->object].mesh->triangle_count);
    }
    return loaded == 0 && !last ? GLINT_ERROR_ARENA : loaded;
}

/* Triangles of the scene that may show on so many tiles. */
static uint32_t count_all_shown(const glint_frame *frame, uint32_t tiles) {
    const uint32_t end = frame->tile_first + tiles;
    uint32_t shown = 0, extent = 0;
    glint_strip strip;
    glint_strip_begin(&strip, frame, end < frame->tile_count ? end : frame->tile_count);
    for (uint32_t i = 0; i < frame->scene->object_count; i++) {
        shown += count_shown(frame, i, 0, &strip, extent);
        extent += glint_extents_of(frame, frame->scene->objects[i].mesh->triangle_count);
    }
    return shown;
}

/* Chooses how many tiles to load for: as many as last time, halved or doubled as far as the arena is likely to hold. */
static void choose_tiles(glint_frame *frame) {
    const size_t room = frame->memory.high - frame->prepared_end;
    const size_t most = room / frame->part_bytes;
    while (frame->pass_tiles > 1 && count_all_shown(frame, frame->pass_tiles) > most)
        frame->pass_tiles = (uint16_t)((frame->pass_tiles + 1) / 2);
    while (frame->pass_tiles < frame->tile_count && count_all_shown(frame, 2u * frame->pass_tiles) <= most)
        frame->pass_tiles =
            (uint16_t)(2u * frame->pass_tiles < frame->tile_count ? 2u * frame->pass_tiles : frame->tile_count);
}

/* About what a triangle that may show takes of the arena: half face the eye, each with a vertex and its references. */
#define PART_BYTES 28

static glint_status begin_parts(glint_frame *frame) {
    frame->memory.low = frame->prepared_end;
    frame->stats.hidden = 0;
    frame->has_extents = 1;
    frame->part_bytes = PART_BYTES;
    return glint_extents_find(frame);
}

glint_status glint_load_parts(glint_frame *frame) {
    const uint32_t object = frame->object, triangle = frame->triangle;
    uint32_t end;
    int loaded = frame->has_extents ? GLINT_OK : (int)begin_parts(frame);
    if (loaded < 0)
        return (glint_status)loaded;
    if (object || triangle)
        frame->pass_tiles = 1; /* the rest of a tile's */
    else if (frame->extents)
        choose_tiles(frame);
    for (;;) {
        glint_strip strip;
        end = (uint32_t)frame->tile_first + frame->pass_tiles;
        end = end < frame->tile_count ? end : frame->tile_count;
        glint_strip_begin(&strip, frame, end);
        loaded = load_strip(frame, &strip);
        frame->object = object;
        frame->triangle = triangle;
        if (loaded > 0 || frame->pass_tiles == 1 || (loaded < 0 && loaded != GLINT_ERROR_ARENA))
            break;
        frame->pass_tiles = (uint16_t)((frame->pass_tiles + 1) / 2);
        if (frame->part_bytes < frame->memory.high) /* beyond, no tile is added to a pass for what it may take */
            frame->part_bytes += frame->part_bytes / 2;
    }
    if (loaded < 0)
        return (glint_status)loaded;
    frame->covers_end = loaded > 0;
    frame->loaded_end = (uint16_t)end;
    frame->vertices_end = frame->memory.low;
    return GLINT_OK;
}
