/* SPDX-License-Identifier: MIT */
/** @file frame.h Goes through the stages of a frame: check, load, bin, draw tiles. */
#ifndef GLINT_FRAME_H
#define GLINT_FRAME_H

#include "../geometry/draw.h"

/** Checks all of a configuration but its region, and fills defaults in. @return GLINT_ERROR_NULL, _SIZE, _TILE or
 * _SAMPLES */
glint_status glint_check_config(glint_config *config);

/** Returns the number of a pass's tiles. */
static inline uint32_t glint_pass_tiles(const glint_frame *frame) {
    return (uint32_t)(frame->tile_end - frame->tile_first);
}

/** Returns a quarter of the frame's tiles, rounded up. When a pass has fewer tiles, vertices are not kept from pass to
 * pass. */
static inline uint32_t glint_quarter_of_tiles(const glint_frame *frame) {
    return (frame->tile_count + 3u) / 4;
}

/** Is an object the first of its material in a scene? */
static inline int glint_is_first_of_material(const glint_scene *scene, uint32_t object) {
    uint32_t first = 0;
    while (scene->objects[first].material != scene->objects[object].material)
        first++;
    return first == object;
}

/** A range is a rectangle of pixels or tiles. Right and bottom are exclusive. */
typedef struct glint_range {
    int32_t left, top, right, bottom;
} glint_range;

/** Checks a scene, all but the indices of its meshes. */
glint_status glint_check_scene(const glint_config *config, const glint_scene *scene);

/** A pass computes once what listing a triangle in a tile needs. A place is a word of two halves, x and y in 28.4. */
typedef struct glint_bin_pass {
    glint_frame *frame;
    uint32_t shift_x, shift_y;      /* shifts from a place to the column and row of its tile */
    uint32_t above;                 /* the bits of these */
    uint32_t last;                  /* the last place of the region */
    uint32_t columns, first, count; /* tiles of a row, before the pass, in the pass */
    uint32_t most;                  /* the largest reference count */
    uint32_t end, reference;        /* the number behind the last triangle, and the word that would refer to it */
} glint_bin_pass;

/** Puts triangles from (frame->object, frame->triangle) on into the lists of the pass's tiles. */
glint_status glint_bin(glint_frame *frame, int *complete);

/** Returns the free bytes between references and clipped triangles. */
static inline size_t glint_free_bytes(const glint_frame *frame) {
    return (size_t)((const uint8_t *)frame->clipped - (const uint8_t *)(frame->references + frame->reference_count));
}

/**
 * Returns where the last object's transform waits, from when the view is prepared until vertices are loaded: at the
 * arena's high end, which nothing else uses then. Transforms of objects before it wait below, as long as nothing needs
 * their room.
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

/** Adds a draw behind `last`, with room for so many vertices and triangles, and `list` bytes behind the draw itself.
 * The arena has to have that room. */
glint_draw *glint_add_draw(glint_frame *frame, glint_draw *last, const glint_transform *transform, uint32_t vertices,
                           uint32_t triangles, size_t list);

/** Loads what the next pass draws: all objects, once a frame, or parts of them, from (frame->object, frame->triangle)
 * on. */
glint_status glint_load(glint_frame *frame);

/** Checks the configuration's region. A region of 0 becomes the whole screen. */
glint_status glint_check_region(glint_config *config);

/** Sets all of a frame up but its arena. */
glint_status glint_frame_grid(glint_frame *frame, const glint_config *config, const glint_scene *scene);

/** Finds the tiles that a triangle may touch. @return 0 when it covers no pixel centre of the screen */
int glint_find_tiles(const glint_frame *frame, const glint_vertex *const v[3], glint_range *range);

/** Returns the bytes of arena that glint_render uses for tiles. */
size_t glint_tile_buffers_size(const glint_config *config);

/** Places the lights of a workspace where its rows are. */
void glint_place_lights(glint_workspace *workspace);

/** Takes these bytes from the arena of a configuration, and lays the workspace of glint_render out there. The pixels of
 * two tiles lie behind each other; all else lies before or behind both. */
void glint_take_buffers(glint_config *config, glint_workspace *workspace);

/** Pixels apart from the arena begin at multiples of so many bytes from the first. */
#define GLINT_CACHE_LINE 64

/** Returns the bytes from the first tile's pixels to the second's. */
size_t glint_second_pixels(const glint_config *config);

/** Returns the bytes of arena that a draw of so many vertices and triangles uses, with its own index list if it has
 * one. */
size_t glint_draw_size(const glint_frame *frame, const glint_object *object, int clips, size_t vertices,
                       size_t triangles, int has_list);

/** Does a tile show nothing but background, now that this pass is prepared? */
int glint_tile_is_empty(const glint_frame *frame, uint32_t tile);

/* ---- Clusters ---- */

/** A walk goes through a mesh's clusters, one after the other. */
typedef struct glint_walk {
    glint_eye eye;
    const glint_cluster *cluster; /* the next cluster */
    uint32_t end;                 /* its first triangle */
    uint8_t away;                 /* whether the last cluster faces away */
    uint16_t fetched[3];          /* corners of a triangle that the mesh has no array of */
} glint_walk;

/** This stage is linked where meshes have clusters. */
struct glint_cull {
    /** Checks clusters. @return GLINT_ERROR_NULL where there is no list, GLINT_ERROR_MESH where clusters do not add up
     * to the mesh */
    glint_status (*check)(const glint_mesh *mesh);
    /** Loads the vertices of a draw of a whole mesh. */
    void (*load)(glint_frame *frame, glint_draw *draw, const glint_mesh *mesh);
    /** Does what glint_bin_some does of all triangles from `next` on, except clusters that face away. */
    int (*bin)(glint_bin_pass *pass, glint_draw *draw, uint32_t next);
    /** Begins a run of triangles. */
    void (*begin)(glint_walk *walk, const glint_mesh *mesh, const glint_transform *transform);
    /** Returns the corners of a run's triangles, in order. All three are the same where a cluster faces away. */
    const uint16_t *(*corners)(glint_walk *walk, const glint_mesh *mesh, uint32_t triangle);
};

/** Returns what drops a mesh's clusters, null where it has none. */
static inline const glint_cull *glint_cull_of(const glint_mesh *mesh) {
    return mesh->clusters ? mesh->clusters->cull : 0;
}

/* ---- Triangles of an object, in order ---- */

/** A sight looks at the triangles of an object, one after the other. */
typedef struct glint_sight {
    glint_transform transform;
    glint_frame *frame;
    const glint_mesh *mesh;
    /** Finds the corners of a triangle; null where they lie in the array of the mesh. */
    const uint16_t *(*find_corners)(glint_walk *walk, const glint_mesh *mesh, uint32_t triangle);
    const uint16_t *corners; /* of the last triangle */
    int is_clipped;          /* whether that was clipped */
    glint_walk walk;
    glint_vertex *cache; /* vertices that were transformed last, by the low bits of their numbers */
    uint32_t cached;     /* entries, a power of two, or 0 */
    glint_vertex own[3]; /* corners that the cache does not hold */
    glint_transform_some *bring;
    glint_position *position, clipped; /* where unused clip positions go; null where the object is not clipped */
} glint_sight;

/** Returns the frame's sight: it lies at the arena's high end, in the room that is kept for binning. */
static inline glint_sight *glint_sight_of(const glint_frame *frame) {
    return (glint_sight *)(void *)(frame->memory.base + frame->memory.high) - 1;
}

/** Begins before the first triangle of an object, without a cache. @return 0 where the object is not visible */
int glint_sight_begin(glint_sight *sight, glint_frame *frame, const glint_object *object);

/**
 * Looks at a triangle whose number is above the last one's. Sets the tiles that it may touch; a clipped triangle sets
 * those of each of its parts.
 * @return how many of `tiles` are set, 0 where the triangle is not visible, or GLINT_ERROR_INDEX
 */
int glint_sight_next(glint_sight *sight, uint32_t number, glint_range tiles[GLINT_CLIP_CORNERS - 2]);

/**
 * Loads what the tiles from frame->tile_first on may show of the scene, from (frame->object, frame->triangle) on: for
 * as many tiles as frame->pass_tiles says and the arena has room for, or for one as many triangles as fit.
 */
glint_status glint_load_parts(glint_frame *frame);

#endif
