/* SPDX-License-Identifier: MIT */
/** @file runs.h Runs: pixels of a row that are nearer than what was there, and follow each other. */
#ifndef GLINT_RUNS_H
#define GLINT_RUNS_H

#include "spans.h"

/** From column x of row y on. */
typedef struct glint_run {
    uint8_t x, y, count;
} glint_run;

/** Most runs of a row. */
#define GLINT_ROW_RUNS ((GLINT_TILE_MAX + 1) / 2)

/** Finds the runs of a span, and stores their depth; 1/w is given with GLINT_DEPTH_BIAS. @return where the next goes */
static inline glint_run *glint_find_near_runs(uint16_t *depth, glint_span span, uint32_t z, uint32_t z_dx, uint32_t y,
                                              glint_run *run) {
    uint32_t column = span.left;
    while (column < span.right) {
        while (z >> 15 <= depth[column]) {
            z += z_dx;
            if (++column == span.right)
                return run;
        }
        const uint32_t first = column;
        do {
            depth[column] = (uint16_t)(z >> 15);
            z += z_dx;
            column++;
        } while (column < span.right && z >> 15 > depth[column]);
        *run++ = (glint_run){(uint8_t)first, (uint8_t)y, (uint8_t)(column - first)};
    }
    return run;
}

/** The same where 1/w may be below 0, as of a deep triangle's planes; and shorter. */
static inline glint_run *glint_find_deep_runs(uint16_t *depth, glint_span span, uint32_t z, uint32_t z_dx, uint32_t y,
                                              glint_run *run) {
    uint32_t first = 0, end = GLINT_TILE_MAX;
    for (uint32_t column = span.left; column < span.right; column++, z += z_dx) {
        const uint32_t here = (uint32_t)glint_most((int32_t)z, GLINT_DEPTH_BIAS) >> 15;
        if (here <= depth[column])
            continue;
        depth[column] = (uint16_t)here;
        if (column != end) {
            first = column;
            *run++ = (glint_run){(uint8_t)first, (uint8_t)y, 0};
        }
        end = column + 1;
        run[-1].count = (uint8_t)(end - first);
    }
    return run;
}

/** Finds the runs of a part's row y, and stores their depth. @return where the next goes */
static inline glint_run *glint_find_runs(const glint_frame *frame, const glint_workspace *workspace,
                                         const glint_part *part, int is_deep, uint32_t y, glint_run *run) {
    const glint_span span = part->spans[y];
    const uint32_t z_dx = (uint32_t)part->depth.dx;
    const uint32_t z =
        (uint32_t)glint_plane_at(&part->depth, part->x + span.left, part->y + (int32_t)y) + GLINT_DEPTH_BIAS;
    uint16_t *const depth = workspace->depth + (y << frame->tile_shift_x);
    return GLINT_SMALL || is_deep ? glint_find_deep_runs(depth, span, z, z_dx, y, run)
                                  : glint_find_near_runs(depth, span, z, z_dx, y, run);
}

/** Is a pixel of a part nearer than what was there? Of one that is not deep; stores nothing. */
static inline int glint_is_visible(const glint_frame *frame, const glint_workspace *workspace, const glint_part *part) {
    const uint32_t z_dx = (uint32_t)part->depth.dx;
    for (uint32_t y = part->top; y < part->bottom; y++) {
        const glint_span span = part->spans[y];
        const uint16_t *const depth = workspace->depth + (y << frame->tile_shift_x);
        uint32_t z =
            (uint32_t)glint_plane_at(&part->depth, part->x + span.left, part->y + (int32_t)y) + GLINT_DEPTH_BIAS;
        for (uint32_t column = span.left; column < span.right; column++, z += z_dx)
            if (z >> 15 > depth[column])
                return 1;
    }
    return 0;
}

/**
 * Hides what lies behind a span: stores its depth, a step less than it has, so that it still is nearer itself.
 * @return whether a pixel of it may show; not where all lie behind what was there
 */
static inline int glint_hide_behind(uint16_t *depth, glint_span span, int32_t z, int32_t z_dx) {
    const uint16_t *const end = depth + span.right;
    int may_show = 0;
    for (depth += span.left; depth < end; depth++, z = glint_add_wrap(z, z_dx)) {
        const uint32_t here = (uint32_t)glint_most(z, 0) >> 15;
        if (here >= *depth) {
            *depth = (uint16_t)here;
            may_show = 1;
        }
    }
    return may_show;
}

/** Pixels of a part's spans. */
static inline uint32_t glint_covered_by(const glint_part *part) {
    uint32_t covered = 0;
    for (uint32_t y = part->top; y < part->bottom; y++)
        covered += (uint32_t)part->spans[y].right - part->spans[y].left;
    return covered;
}

#endif
