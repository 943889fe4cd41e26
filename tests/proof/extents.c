/* SPDX-License-Identifier: MIT */
/* Parts of objects: which tiles they may show. */
#include "proof.h"

#include "../../src/frame/extents.c"
#include "contracts.h"

/*
 * Not proven: glint_sight_begin, glint_sight_next, see, see_corners, find_clipped, choose_shift, find_of_object,
 * glint_extents_find, glint_extent_shows, glint_load_parts: they walk triangles and the arena, by counts of bytes,
 * unsigned, and call what is proven. Suites `identity` and `arenas` under ASan and UBSan, and fuzzing.
 */

/* Any tiles of a frame. */
PROOF(glint_strip_begin) {
    glint_frame frame;
    glint_strip strip;
    frame.tile_columns = (uint16_t)ANY(1, UINT16_MAX);
    frame.tile_first = (uint16_t)ANY(0, UINT16_MAX - 1);
    glint_strip_begin(&strip, &frame, ANY_UNSIGNED(1, UINT16_MAX));
}

/* Any strip and any rectangle of tiles, as far as there is. */
PROOF(glint_is_in_strip) {
    const glint_strip strip = {ANY(0, UINT16_MAX), ANY(0, UINT16_MAX), ANY(0, UINT16_MAX), ANY(0, UINT16_MAX)};
    const glint_range tiles = {ANY(0, INT32_MAX), ANY(0, INT32_MAX), ANY(0, INT32_MAX), ANY(0, INT32_MAX)};
    glint_is_in_strip(&strip, &tiles);
}

/* Any rectangle of tiles. */
PROOF(add_tiles) {
    glint_extent extent = {(uint8_t)ANY(0, 255), (uint8_t)ANY(0, 255), (uint8_t)ANY(0, 255), (uint8_t)ANY(0, 255)};
    const glint_range tiles = {ANY(0, INT32_MAX), ANY(0, INT32_MAX), ANY(0, INT32_MAX), ANY(0, INT32_MAX)};
    add_tiles(&extent, &tiles);
}

/* Any room. */
PROOF(glint_sight_size) {
    glint_sight_size(ANY_UNSIGNED(0, UINT_MAX));
}
