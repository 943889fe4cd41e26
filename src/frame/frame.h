/* SPDX-License-Identifier: MIT */
/** @file frame.h Stages of a frame: load, bin, tile. */
#ifndef GLINT_FRAME_H
#define GLINT_FRAME_H

#include "../geometry/draw.h"
#include "arena.h"

/** A triangle made by clipping. */
typedef struct glint_clipped {
    glint_vertex corners[3];
    int16_t extra[3][3];
    uint16_t triangle; /* of the draw */
    const glint_draw *draw;
} glint_clipped;

/** Two halves that are stored and loaded as one word. */
#if defined(__GNUC__)
#define GLINT_WORD __attribute__((aligned(4)))
#else
#define GLINT_WORD
#endif

/**
 * A triangle in a tile's list, by its number: of a draw from 0 up, of the clipped from GLINT_CLIPPED_TOP down. The
 * first reference of a list is its tile's: it has no triangle, but the number of the last reference there, its own
 * where the list is empty.
 */
typedef struct GLINT_WORD glint_reference {
    uint16_t next; /* number of the next reference, or GLINT_LIST_END */
    uint16_t triangle;
} glint_reference;

#define GLINT_LIST_END 0xffffu
#define GLINT_CLIPPED_TOP 0xfffeu

/** Most triangles of draws in a pass: numbers above are left to clipped ones. */
#define GLINT_TRIANGLES_MAX 0xe000u

/** Tiles of a pass. */
static inline uint32_t glint_pass_tiles(const glint_frame *frame) {
    return (uint32_t)(frame->tile_end - frame->tile_first);
}

/** Of a frame's tiles, rounded up: with fewer to a pass, vertices are no longer kept from pass to pass. */
static inline uint32_t glint_quarter_of_tiles(const glint_frame *frame) {
    return (frame->tile_count + 3u) / 4;
}

/** A rectangle of pixels or tiles; right and bottom are exclusive. */
typedef struct glint_range {
    int32_t left, top, right, bottom;
} glint_range;

/** Checks a scene, all but its meshes' indices. */
glint_status glint_check_scene(const glint_config *config, const glint_scene *scene);

/** A pass finds once what it takes to list a triangle in a tile. A place is a word of two halves, x and y in 28.4. */
typedef struct glint_bin_pass {
    glint_frame *frame;
    uint32_t shift_x, shift_y;      /* from a place to the column and row of its tile */
    uint32_t above;                 /* the bits of these */
    uint32_t last;                  /* the last place of the region */
    uint32_t columns, first, count; /* tiles: of a row, before the pass, in the pass */
    uint32_t most;                  /* references that there may be */
    uint32_t end, reference;        /* behind the last triangle: its number and what would refer to it */
} glint_bin_pass;

/** Puts triangles from (frame->object, frame->triangle) on into the lists of the pass's tiles. */
glint_status glint_bin(glint_frame *frame, int *complete);

/** Brings stats.arena_used up to date after binning. */
void glint_count_arena(glint_frame *frame);

/** What a pass leaves free of the arena. */
glint_spare glint_find_spare(const glint_frame *frame);

/**
 * Where the last object's transform waits from when the view is prepared until vertices are loaded: at the arena's high
 * end, which none of that takes. Those of objects before it wait below, as long as nothing takes their place.
 */
static inline glint_transform *glint_last_transform(const glint_frame *frame) {
    return (glint_transform *)(void *)(frame->memory.base + frame->memory.high) - 1;
}

/** Loads `count` vertices of its mesh from `index` on into those of a draw from `slot` on. */
void glint_load_vertices(glint_frame *frame, glint_draw *draw, const glint_mesh *mesh, uint32_t index, uint32_t slot,
                         uint32_t count);

/**
 * Bins the triangles of a draw from number `next` to before `end`.
 * @return the first that the arena had no room for, `end`, or GLINT_ERROR_INDEX
 */
int glint_bin_some(glint_bin_pass *pass, glint_draw *draw, uint32_t next, uint32_t end);

/**
 * A draw at the end of the list, behind `last`, with room for so many vertices and triangles, and `list` bytes behind
 * the draw itself; the arena has it.
 */
glint_draw *glint_add_draw(glint_frame *frame, glint_draw *last, const glint_transform *transform, uint32_t vertices,
                           uint32_t triangles, size_t list);

/** Loads what the next pass draws: all objects, once a frame, or parts of them, from (frame->object, frame->triangle)
 * on. */
glint_status glint_load(glint_frame *frame);

/** Checks the configuration's region, which becomes the whole screen where it is all 0. */
glint_status glint_check_region(glint_config *config);

/** Sets the tiles of a frame whose tile size is set: those of its region. */
glint_status glint_region_begin(glint_frame *frame);

/** Sets up all of a frame but its arena. */
glint_status glint_frame_grid(glint_frame *frame, const glint_config *config, const glint_scene *scene);

/** Tiles that a triangle may touch. @return 0 when it covers no pixel centre of the screen. */
int glint_find_tiles(const glint_frame *frame, const glint_vertex *const v[3], glint_range *range);

/** Bytes of arena that glint_render keeps for tiles. */
size_t glint_tile_buffers_size(const glint_config *config);

/** Pixels apart from the arena begin at multiples of so many bytes from the first. */
#define GLINT_CACHE_LINE 64

/** Bytes from the first tile's pixels to the second's. */
size_t glint_second_pixels(const glint_config *config);

/** Free bytes with which any triangle can be binned into one tile. */
#define GLINT_BIN_RESERVE                   \
    GLINT_ALIGNED(sizeof(glint_reference) + \
                  (GLINT_CLIP_CORNERS - 2) * (sizeof(glint_reference) + sizeof(glint_clipped)))

/** Bytes of arena that a draw of so many vertices and triangles takes, its own index list included if it has one. */
size_t glint_draw_size(const glint_frame *frame, const glint_object *object, const glint_transform *transform,
                       size_t vertices, size_t triangles, int has_list);

/** Bytes beyond what is prepared with which any scene can be drawn: a part of one triangle, and its bin. */
#define GLINT_LEAST_ROOM                                                                                        \
    (GLINT_ALIGNED(sizeof(glint_draw)) + GLINT_ALIGNED(3 * sizeof(glint_vertex)) +                              \
     GLINT_ALIGNED(3 * sizeof(glint_position)) + GLINT_ALIGNED(24 * GLINT_LIGHTS_MAX) + 2 * GLINT_ALIGNED(36) + \
     2 * GLINT_ALIGNED(12) + GLINT_ALIGNED(8) + GLINT_ALIGNED(6) + GLINT_BIN_RESERVE)

/** Bytes that are to be free behind so many of tables: for any scene, light at a triangle's nodes, and some more. */
static inline size_t glint_room_behind_tables(size_t tables) {
    return GLINT_LEAST_ROOM + 512 + tables / 4;
}

/** Is all that a tile shows background, now that this pass is prepared? */
int glint_tile_is_empty(const glint_frame *frame, uint32_t tile);

#endif
