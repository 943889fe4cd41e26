/* SPDX-License-Identifier: MIT */
/* Runs of a row. */
#include "proof.h"

#include "../../src/raster/runs.h"

/*
 * Not proven: glint_find_runs: it hands a row of the tile on to one of the two that are. Suite `reads`, and the image
 * tests under ASan.
 */

#define WIDTH 8

static uint16_t depths[WIDTH];
static glint_run runs[(WIDTH + 1) / 2];

/* Runs follow each other in a span, with a pixel at least between two. */
static void check_runs(const glint_run *end, glint_span span) {
    uint32_t from = span.left;
    for (const glint_run *run = runs; run != end; run++) {
        /*@ assert from <= run->x && 0 < run->count && run->x + run->count <= span.right; */
        from = (uint32_t)run->x + run->count + 1u;
    }
}

/* Every span of a row of 8 pixels, of which any are hidden; 1/w of a triangle that lies in between. */
#define FOR_ROWS(span)                              \
    FOR_PARTS(left, 0, WIDTH)                       \
    FOR_PARTS(right, left, WIDTH)                   \
    FOR_PARTS(hidden, 0, (1 << (right - left)) - 1) \
    for (const glint_span *span = any_row(left, right, hidden); span; span = 0)

static const glint_span *any_row(int left, int right, int hidden) {
    static glint_span span;
    span = (glint_span){(uint8_t)left, (uint8_t)right};
    for (int i = left; i < right; i++)
        depths[i] = (uint16_t)(hidden >> (i - left) & 1 ? UINT16_MAX : 0);
    return &span;
}

/* Every span of a row of 8 pixels, any of them hidden: no more runs than half of its pixels. */
PROOF(glint_find_near_runs) {
    FOR_ROWS(span) {
        check_runs(glint_find_near_runs(depths, *span, ANY_UNSIGNED(1u << 15, 0x7fff7fff), 0, 5, runs), *span);
    }
}

/* The same, and 1/w below 0. @narrowing 1/w is a number with a sign */
PROOF(glint_find_deep_runs) {
    FOR_ROWS(span) {
        check_runs(glint_find_deep_runs(depths, *span, (uint32_t)ANY(INT32_MIN, 0x7fff7fff), 0, 5, runs), *span);
    }
}

/* The same, and any 1/w: nothing is nearer than what lies there. @narrowing 1/w is a number with a sign */
PROOF(glint_hide_behind) {
    FOR_PARTS(below, 0, 1) {
        FOR_ROWS(span) {
            glint_hide_behind(depths, *span, below ? ANY(INT32_MIN, -1) : ANY(0, 0x7ffeffff), 0);
            for (int i = span->left; i < span->right; i++) {
                if (below && !(hidden >> (i - left) & 1)) {
                    /*@ assert depths[i] == 0; */
                } else if (!(hidden >> (i - left) & 1)) {
                    /*@ assert depths[i] <= 65533; */
                } else {
                    /*@ assert depths[i] == 65535; */
                }
            }
        }
    }
}

/* Any rows of a tile of 8 x 8, any spans, any 1/w on any plane. @narrowing planes are evaluated modulo 2^32 */
PROOF(glint_is_visible) {
    static uint16_t tile[WIDTH * WIDTH];
    const glint_workspace workspace = {.depth = tile};
    glint_frame frame;
    glint_part part;
    frame.tile_shift_x = 3;
    part.depth = (glint_plane){ANY_INT, ANY_INT, ANY_INT};
    part.x = ANY(-2047, 2047);
    part.y = ANY(-2047, 2047);
    for (int i = 0; i < WIDTH * WIDTH; i++)
        tile[i] = (uint16_t)ANY(0, UINT16_MAX);
    FOR_PARTS(bottom, 0, WIDTH) {
        part.top = ANY_UNSIGNED(0, WIDTH);
        part.bottom = (uint32_t)bottom;
        for (int row = 0; row < WIDTH; row++) {
            part.spans[row].left = (uint8_t)ANY(0, WIDTH);
            part.spans[row].right = (uint8_t)ANY(0, WIDTH);
        }
        const int is_visible = glint_is_visible(&frame, &workspace, &part);
        /*@ assert is_visible == 0 || is_visible == 1; */
    }
}

/* Any rows of any spans. */
PROOF(glint_covered_by) {
    glint_part part;
    FOR_PARTS(bottom, 0, GLINT_TILE_MAX) {
        part.top = ANY_UNSIGNED(0, (uint32_t)bottom);
        part.bottom = (uint32_t)bottom;
        for (int row = 0; row < GLINT_TILE_MAX; row++) {
            part.spans[row].left = (uint8_t)ANY(0, GLINT_TILE_MAX);
            part.spans[row].right = (uint8_t)ANY(part.spans[row].left, GLINT_TILE_MAX);
        }
        glint_covered_by(&part);
    }
}
