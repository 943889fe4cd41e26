/* SPDX-License-Identifier: MIT */
/* Culling, and the tiles of a triangle. */
#include "proof.h"

#include "../../src/bin.c"
#include "../../src/cull.c"
#include "ranges.h"

/*
 * Not proven: glint_bin, append, list_clipped: addresses in the arena, which room() keeps apart. Suite `identity`,
 * every size of arena, and fuzzing, under ASan.
 */

/* Strictly within the guard band, 1023 pixels, from the centre of the screen, which lies up to 512 pixels in. */
#define GUARD (16 * GLINT_GUARD_BAND - 1)

static glint_vertex any_corner(int centre) {
    glint_vertex vertex;
    vertex.x = (int16_t)ANY(-GUARD, centre + GUARD);
    vertex.y = (int16_t)ANY(-GUARD, centre + GUARD);
    vertex.flags = (uint16_t)ANY(0, UINT16_MAX);
    return vertex;
}

/* Any three corners, from the centre of the screen: where that lies cancels. */
PROOF(glint_double_area) {
    const glint_vertex a = any_corner(0), b = any_corner(0), c = any_corner(0);
    const glint_vertex *const v[3] = {&a, &b, &c};
    glint_double_area(&a, &b, &c);
    glint_faces(ANY(0, 1), ANY(0, 1), v);
}

/* Any three corners, any screen, tiles of each size: none but the screen's. */
PROOF(glint_find_tiles) {
    const glint_vertex a = any_corner(8192), b = any_corner(8192), c = any_corner(8192);
    const glint_vertex *const v[3] = {&a, &b, &c};
    glint_frame frame;
    glint_range range;
    frame.config.width = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    frame.config.height = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    FOR_PARTS(shift, 3, 6) {
        frame.tile_shift_x = (uint8_t)shift;
        frame.tile_shift_y = (uint8_t)shift;
        if (glint_find_tiles(&frame, v, &range)) {
            /*@ assert 0 <= range.left && 0 <= range.top; */
            /*@ assert range.right <= 1024 >> shift && range.bottom <= 1024 >> shift; */
        }
    }
}

/* Any three corners, any screen, a pass of any tiles: the one tile is on the screen. */
PROOF(find_tile) {
    const glint_vertex a = any_corner(8192), b = any_corner(8192), c = any_corner(8192);
    const glint_vertex *const v[3] = {&a, &b, &c};
    glint_frame frame;
    uint32_t tile;
    frame.tile_end = (uint16_t)ANY(1, 128 * 128);
    frame.config.width = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    frame.config.height = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    frame.tile_columns = (uint16_t)ANY(1, 128);
    frame.tile_first = (uint16_t)ANY(0, 128 * 128 - 1);
    FOR_PARTS(shift, 3, 6) {
        frame.tile_shift_x = (uint8_t)shift;
        frame.tile_shift_y = (uint8_t)shift;
        const grid g = grid_of(&frame);
        find_tile(&g, v, &tile);
    }
}

/* Any indices, a mesh of 64 vertices, up to 100 triangles from any on. @options -eva-slevel 0 -eva-min-loop-unroll 65
 */
PROOF(glint_cull) {
    static uint16_t triangles[100][3];
    static glint_vertex vertices[64];
    glint_draw draw;
    uint16_t seen[GLINT_SEEN_MAX];
    Frama_C_make_unknown((char *)triangles, sizeof triangles);
    for (int i = 0; i < 64; i++)
        vertices[i] = any_corner(0);
    draw.triangles = (const uint16_t(*)[3])triangles;
    draw.vertices = vertices;
    draw.vertex_count = 64;
    draw.count = 100;
    draw.transform.clips = (uint8_t)ANY(0, 1);
    draw.double_sided = (uint8_t)ANY(0, 1);
    draw.mirrored = (uint8_t)ANY(0, 1);
    uint32_t next = 0;
    glint_cull(&draw, &next, seen);
    next = ANY_UNSIGNED(36, 99);
    glint_cull(&draw, &next, seen);
}
