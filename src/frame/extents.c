/* SPDX-License-Identifier: MIT */
/* Extents: which tiles triangles of a mesh that follow each other may show, found once a frame. */
#include "../geometry/layout.h"
#include "parts.h"

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
