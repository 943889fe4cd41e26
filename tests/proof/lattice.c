/* SPDX-License-Identifier: MIT */
/* The lattice, and what draws by nodes. */
#include "proof.h"

#include "../../src/nodes/lattice.c"

/*
 * Not proven: glint_draw_lattice, draw_cell, draw_eight, begin_quarter, light_square, add_node, light_batch,
 * draw_square, draw_edges, glint_draw_edges, draw_one_by_one, test_cell, test_row: squares of a cell, spans and pixels
 * inside a tile; no arithmetic beyond that. Suites `nodes` and `identity` under ASan and UBSan, and fuzzing.
 */
/*
 * Not proven: draw_nodes, draw_terms, draw_batch, glint_terms_draw_part: runs of rows, of which counts keep no more
 * than two rows hold. Suites `nodes` and `identity` under ASan and UBSan, and fuzzing.
 */
/*
 * Not proven: glint_is_visible: spans of a part, as glint_find_near_runs walks them, whose driver stands for it. Suite
 * `nodes` and the image tests under ASan and UBSan.
 */

static lattice_walk w;
static glint_part part;
static glint_attributes attributes;

/* Every row of a square of eight pixels, by its bits: no run but inside it. */
PROOF(find_runs) {
    glint_run runs[CELL / 2];
    FOR_PARTS(visible, 0, 255) {
        uint32_t pixels = 0;
        const glint_run *end = find_runs((uint32_t)visible, ANY_UNSIGNED(0, CELL - 1), &pixels, runs);
        /*@ assert end <= runs + 4 && pixels <= 8; */
    }
}

/* Any row of any square of a cell. */
PROOF(row_of_nodes) {
    for (int i = 0; i < CELL; i++)
        w.visible[i] = (uint16_t)ANY(0, UINT16_MAX);
    FOR_PARTS(bits, 2, 4) {
        row_of_nodes(&w, ANY(0, CELL - 1), ANY(0, CELL - 1), 1 << bits);
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
