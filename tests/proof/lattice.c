/* SPDX-License-Identifier: MIT */
/* The lattice, and what draws by nodes. */
#include "proof.h"

#include "../../src/nodes/lattice.c"
#include "contracts.h"

/*
 * Not proven: glint_draw_lattice, draw_cells, draw_cell, draw_eight, begin_cell, begin_quarter, begin_square,
 * swap_nodes, light_square, begin_batch, add_node, light_batch, draw_square, draw_one_by_one, glint_draw_edges:
 * squares, nodes and runs inside what cut_square leaves; no arithmetic beyond that. Suites `nodes` and `identity` under
 * ASan and UBSan, and fuzzing.
 */
/*
 * Not proven: draw_nodes, draw_terms, draw_batch, glint_terms_draw_part: runs of rows, of which counts keep no more
 * than two rows hold. Suites `nodes` and `identity` under ASan and UBSan, and fuzzing.
 */

static lattice_walk w;
static glint_part part;
static glint_attributes attributes;

/* Any spans, any square that begins in a tile, or as far before it as a cell is wide. @contract glint_is_visible */
PROOF(cut_square) {
    lattice_square of;
    w.gathering.part = &part;
    part.top = ANY_UNSIGNED(0, GLINT_TILE_MAX);
    part.bottom = ANY_UNSIGNED(0, GLINT_TILE_MAX);
    for (int y = 0; y < GLINT_TILE_MAX; y++)
        part.spans[y] = (glint_span){(uint8_t)ANY(0, GLINT_TILE_MAX), (uint8_t)ANY(0, GLINT_TILE_MAX)};
    of.x = ANY(1 - CELL, GLINT_TILE_MAX - 1);
    FOR_PARTS(y, 1 - CELL, GLINT_TILE_MAX - 1) {
        of.y = (int32_t)y;
        FOR_PARTS(bits, 2, 4) {
            cut_square(&w, &of, 1 << bits);
        }
    }
}

/* Any planes. */
PROOF(find_largest) {
    for (int c = 0; c < 3; c++) {
        attributes.main[c] = (glint_plane){ANY_INT, ANY_INT, ANY_INT};
        attributes.extra[c] = (glint_plane){ANY_INT, ANY_INT, ANY_INT};
    }
    part.depth = (glint_plane){ANY_INT, ANY_INT, ANY_INT};
    FOR_PARTS(has_surface, 0, 1) {
        find_largest(&part, &attributes, (int)has_surface);
    }
}
