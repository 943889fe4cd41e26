/* SPDX-License-Identifier: MIT */
/* The kernel for everything. */
#include "proof.h"

#include "../../src/kernel.c"
#include "lit.h"
#include "plane.h"

/*
 * Not proven: glint_draw_any: fragments are shaded when there are 8, so that none is the ninth; spans lie in the tile.
 * The image tests under ASan.
 */

/*
 * Corners of any attributes, 1/w by the bits of the largest, first or last; lit and not, from both sides.
 * @contract glint_plane_begin
 * @unreached 2 leading zeros of 0 and 1
 */
PROOF(begin) {
    static const glint_evaluation kinds[4] = {{3, 0, 0, 0, 0}, {3, 1, 0, 0, 0}, {0, 1, 0, 0, 0}, {3, 1, 0, 0, 0}};
    glint_vertex corners[3];
    int16_t extra[3][3];
    glint_triangle triangle = {{&corners[0], &corners[1], &corners[2]}, {extra[0], extra[1], extra[2]}, 0, 1, 0};
    glint_attributes attributes;
    glint_fragments fragments;
    glint_part part;
    glint_draw draw;
    if (ANY(0, 1))
        any_wide(&part.gradients);
    else
        any_narrow(&part.gradients);
    part.x = ANY(-2047, 2047);
    part.y = ANY(-2047, 2047);
    for (int i = 0; i < 3; i++) {
        any_unit(corners[i].attribute);
        any_unit(extra[i]);
    }
    FOR_PARTS(bits, 7, 31) {
        FOR_PARTS(kind, 0, 7) {
            const int32_t most = (int32_t)((1u << bits) - 1), least = (int32_t)((1u << bits) / 2);
            corners[0].inverse_w = ANY(kind & 1 ? least : 64, most);
            corners[1].inverse_w = ANY(64, most);
            corners[2].inverse_w = ANY(kind & 1 ? 64 : least, most);
            draw.evaluation = &kinds[kind >> 1];
            draw.extra = kind >> 1 == 1 ? 0 : extra;
            draw.double_sided = (uint8_t)(kind >> 1 == 3);
            triangle.back = ANY(0, 1);
            begin(&attributes, &fragments, &draw, &triangle, &part);
        }
    }
}

/* Any 1/w. */
PROOF(depth_of) {
    depth_of(ANY_INT);
}
