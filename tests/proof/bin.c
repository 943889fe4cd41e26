/* SPDX-License-Identifier: MIT */
/* Culling, and the tiles of a triangle. */
#include "proof.h"

#include "../../src/frame/bin.c"
#include "../../src/frame/bin_plain.c"
#include "ranges.h"

/*
 * Not proven: glint_bin, bin_loop, bin_several, list_four, put, list_clipped: addresses in the arena, which room()
 * keeps apart. Suite `identity`, every size of arena, and fuzzing, under ASan.
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

/* Any three corners, any region, tiles of each size: none but the region's. */
PROOF(glint_find_tiles) {
    const glint_vertex a = any_corner(8192), b = any_corner(8192), c = any_corner(8192);
    const glint_vertex *const v[3] = {&a, &b, &c};
    glint_frame frame;
    glint_range range;
    frame.right = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    frame.bottom = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    FOR_PARTS(shift, 3, 6) {
        frame.tile_shift_x = (uint8_t)shift;
        frame.tile_shift_y = (uint8_t)shift;
        FOR_PARTS(first, 0, (GLINT_SIZE_MAX - 1) >> shift) {
            frame.first_column = frame.first_row = (uint16_t)first;
            frame.config.region.x = (int16_t)ANY(first << shift, ((first + 1) << shift) - 1);
            frame.config.region.y = (int16_t)ANY(first << shift, ((first + 1) << shift) - 1);
            if (glint_find_tiles(&frame, v, &range)) {
                /*@ assert 0 <= range.left && 0 <= range.top; */
                /*@ assert range.right <= 1024 >> shift && range.bottom <= 1024 >> shift; */
            }
        }
    }
}

/* Any three corners. @narrowing x of two corners differs by less than 2^15 */
PROOF(is_seen) {
    const glint_vertex a = any_corner(0), b = any_corner(0), c = any_corner(0);
    const uint32_t w[3] = {word_of(&a), word_of(&b), word_of(&c)};
    is_seen(w, ANY_UNSIGNED(1, 3));
}

/* Any side, from any corner to any point of any screen. */
PROOF(quadrant_beyond) {
    quadrant_beyond(ANY(-2 * GUARD, 2 * GUARD), ANY(-2 * GUARD, 2 * GUARD), ANY(-8192 - GUARD, 8192 + GUARD),
                    ANY(-8192 - GUARD, 8192 + GUARD));
}

/* Any three corners, any screen: the pixels are on it. */
PROOF(find_pixels) {
    const int32_t a = ANY(-GUARD, 8192 + GUARD), b = ANY(-GUARD, 8192 + GUARD), c = ANY(-GUARD, 8192 + GUARD);
    int32_t low, high;
    find_pixels(a * 65536 + ANY(0, 65535), b * 65536 + ANY(0, 65535), c * 65536 + ANY(0, 65535), ANY(1, GLINT_SIZE_MAX),
                &low, &high);
    if (low < high) {
        /*@ assert 0 <= low && high <= 1024; */
    }
}

/* Any three corners, any screen, a pass of any tiles: the one tile is on the screen. */
PROOF(find_tile) {
    const glint_vertex a = any_corner(8192), b = any_corner(8192), c = any_corner(8192);
    const uint32_t w[3] = {word_of(&a), word_of(&b), word_of(&c)};
    static uint8_t arena[1 << 19];
    glint_frame frame;
    glint_draw draw;
    uint32_t tile;
    frame.references = (glint_reference *)(void *)arena;
    frame.clipped = (glint_clipped *)(void *)(arena + ANY(0, 1 << 19));
    draw.first = (uint16_t)ANY(0, UINT16_MAX);
    frame.tile_end = (uint16_t)ANY(1, 128 * 128);
    frame.right = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    frame.bottom = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    frame.tile_columns = (uint16_t)ANY(1, 128);
    frame.tile_first = (uint16_t)ANY(0, 128 * 128 - 1);
    FOR_PARTS(shift, 3, 6) {
        frame.tile_shift_x = (uint8_t)shift;
        frame.tile_shift_y = (uint8_t)shift;
        const grid g = grid_of(&frame, &draw, ANY_UNSIGNED(0, UINT16_MAX));
        find_tile(&g, w, 0, &tile);
        find_tile(&g, w, 1, &tile);
    }
}
