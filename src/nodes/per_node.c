/* SPDX-License-Identifier: MIT */
/* Lighting at nodes: a triangle by polynomials through its own, by those of the lattice's cells, or by fragments. */
#include "../light/evaluation.h"
#include "../pixel/format.h"
#include "terms.h"

/* What runs of a triangle are drawn by. */
typedef struct painter {
    const glint_draw *draw;
    const glint_triangle *triangle;
    const glint_terms *terms;
    const glint_descent *polynomials;
} painter;

static void draw_batch(const glint_frame *frame, glint_workspace *workspace, const painter *by, const glint_part *part,
                       const glint_run *runs, uint32_t count) {
    glint_terms_draw(frame, workspace, by->terms, by->polynomials, runs, count);
    if (by->terms->margin)
        glint_draw_edges(frame, workspace, by->draw, by->triangle, part, by->terms, by->polynomials, runs, count);
}

/* Draws runs, of as many rows at once as fit. */
static void draw_rows(const glint_frame *frame, glint_workspace *workspace, const painter *by, const glint_part *part) {
    glint_run runs[2 * GLINT_ROW_RUNS], *next = runs;
    uint32_t pixels = 0;
    for (uint32_t y = part->top; y < part->bottom; y++) {
        const uint32_t width = (uint32_t)part->spans[y].right - part->spans[y].left;
        pixels += width;
        if (pixels > 2 * frame->config.tile_width || next > runs + GLINT_ROW_RUNS) {
            draw_batch(frame, workspace, by, part, runs, (uint32_t)(next - runs));
            next = runs;
            pixels = width;
        }
        next = glint_find_runs(frame, workspace, part, 0, y, next);
    }
    if (next != runs)
        draw_batch(frame, workspace, by, part, runs, (uint32_t)(next - runs));
}

void glint_terms_draw_part(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                           const glint_triangle *triangle, const glint_part *part, const glint_terms *terms,
                           const glint_polynomials *polynomials) {
    const painter by = {draw, triangle, terms, polynomials->descents};
    if (!terms->is_fused) {
        draw_rows(frame, workspace, &by, part);
        return;
    }
    const glint_spans spans = glint_spans_of(frame, workspace, part);
    frame->config.format->draw_channels(&spans, polynomials->fused, terms->is_curved);
}

/*
 * Draws a triangle by polynomials through its own nodes; what that takes of stack is not there while it is drawn in
 * other ways. @return 0 where they are not close enough
 */
static GLINT_NOINLINE int draw_terms(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                     const glint_triangle *triangle, const glint_part *part) {
    glint_terms terms;
    glint_polynomials polynomials;
    if (!glint_terms_begin(frame, draw, triangle, part, &terms, &polynomials))
        return 0;
    glint_terms_draw_part(frame, workspace, draw, triangle, part, &terms, &polynomials);
    glint_count(workspace, GLINT_KERNEL_CHANNELS, workspace->drawn ? glint_covered_by(part) : 0);
    return 1;
}

/* Draws a triangle that has no polynomials of its own, but for lights that do not shine on it. */
static GLINT_NOINLINE void draw_in_parts(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                         const glint_triangle *triangle, const glint_part *part) {
    const glint_reach reach = glint_find_reach(frame, draw, triangle);
    glint_triangle lit = *triangle;
    lit.away = reach.away;
    if (!glint_draw_lattice(frame, workspace, draw, &lit, reach.lobes, part) &&
        !glint_draw_pieces(frame, workspace, draw, &lit, reach.lobes, part))
        glint_draw_any(frame, workspace, draw, &lit, part);
}

static void draw_nodes(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                       const glint_triangle *triangle, const glint_part *part) {
    if (!draw->shading->terms || triangle->area < GLINT_NODES_LEAST_AREA || glint_is_deep(triangle))
        glint_draw_any(frame, workspace, draw, triangle, part);
    else if (!glint_is_visible(frame, workspace, part)) /* then no node is lit */
        glint_count(workspace, GLINT_KERNEL_CHANNELS, workspace->drawn ? glint_covered_by(part) : 0);
    else if (!draw_terms(frame, workspace, draw, triangle, part))
        draw_in_parts(frame, workspace, draw, triangle, part);
}

static const glint_node_stage stage = {glint_terms_prepare, glint_terms_measure, sizeof(glint_light_terms)};

const glint_evaluation glint_per_node = {GLINT_LIT_AT_FRAGMENTS, glint_terms_light, draw_nodes, &stage};
