/* SPDX-License-Identifier: MIT */
/* Lighting at nodes: a triangle by polynomials through its own, by those of the lattice's cells, or by fragments. */
#include "../light/backs.h"
#include "../pixel/format.h"
#include "../raster/found.h"
#include "rows.h"
#include "shapes.h"

/* What polynomials a triangle has, found here unless another tile did. @param own room for it */
static const glint_found_terms *find_whole(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                           const glint_triangle *triangle, const glint_part *part,
                                           glint_found_terms *own) {
    const glint_found_terms *const before = glint_found_find(workspace, triangle, part, 0);
    if (before)
        return before;
    glint_found_terms *const kept = glint_found_begin(workspace, triangle, part, sizeof *kept);
    glint_found_terms *const found = kept ? kept : own;
    found->fits =
        (uint32_t)glint_terms_begin(frame, draw, triangle, part, &found->terms, &found->polynomials, &found->reach);
    if (kept)
        glint_found_keep(workspace, triangle, 0, glint_found_terms_size(kept));
    return found;
}

/*
 * Draws a triangle by polynomials through its own nodes; what that takes of stack is not there while it is drawn in
 * other ways. @return 0 where they are not close enough: then sets its reach
 */
static GLINT_NOINLINE int draw_terms(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                     const glint_triangle *triangle, const glint_part *part, glint_reach *reach) {
    glint_found_terms own;
    const glint_found_terms *const found = find_whole(frame, workspace, draw, triangle, part, &own);
    if (!found->fits) {
        *reach = found->reach;
        return 0;
    }
    glint_terms_draw_part(frame, workspace, draw, triangle, part, &found->terms, &found->polynomials);
    glint_count(workspace, GLINT_KERNEL_CHANNELS, workspace->drawn ? glint_covered_by(part) : 0);
    return 1;
}

/* Draws a triangle that has no polynomials of its own, but for lights that do not shine on it. */
static GLINT_NOINLINE void draw_in_parts(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                         const glint_triangle *triangle, const glint_part *part, glint_reach reach) {
    glint_triangle lit = *triangle;
    lit.away = reach.away;
    if (!glint_draw_lattice(frame, workspace, draw, &lit, reach.lobes, part) &&
        !glint_draw_pieces(frame, workspace, draw, &lit, reach.lobes, part))
        glint_draw_any(frame, workspace, draw, &lit, part);
}

static void draw_nodes(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                       const glint_triangle *triangle, const glint_part *part) {
    glint_reach reach;
    if (!draw->shading->terms || triangle->area < GLINT_NODES_LEAST_AREA || glint_is_deep(triangle))
        glint_draw_any(frame, workspace, draw, triangle, part);
    else if (!glint_is_visible(frame, workspace, part)) /* then no node is lit */
        glint_count(workspace, GLINT_KERNEL_CHANNELS, workspace->drawn ? glint_covered_by(part) : 0);
    else if (!draw_terms(frame, workspace, draw, triangle, part, &reach))
        draw_in_parts(frame, workspace, draw, triangle, part, reach);
}

/* Of double-sided objects. */
static GLINT_NOINLINE void draw_node_back(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                          const glint_triangle *triangle, const glint_part *part) {
    int16_t nodes[3 * GLINT_KEPT_MAX];
    glint_draw_back(frame, workspace, draw, triangle, part, nodes);
}

static void draw_node_sides(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                            const glint_triangle *triangle, const glint_part *part) {
    if (triangle->back)
        draw_node_back(frame, workspace, draw, triangle, part);
    else
        draw_nodes(frame, workspace, draw, triangle, part);
}

static const glint_node_stage stage = {glint_terms_prepare, glint_terms_measure, sizeof(glint_light_terms)};

const glint_evaluation glint_per_node = {GLINT_LIT_AT_FRAGMENTS, 0,     glint_terms_light, draw_nodes,
                                         draw_node_sides,        &stage};
