/* SPDX-License-Identifier: MIT */
/* Triangles that are seen from the back. */
#include "proof.h"

#include "../../src/light/backs.c"
#include "../../src/nodes/terms.h"
#include "contracts.h"

/*
 * Not proven: draw_node_back, draw_node_sides: they hand glint_draw_back, which is proven, room for what three corners
 * keep, or call draw_nodes. Suite `nodes` under ASan and UBSan, and fuzzing.
 */

static glint_vertex corners[3], elsewhere[3];
static int16_t terms[3][3];
static glint_triangle triangle;
static glint_part part;
static glint_draw draw;

/* Any corners, whole or made by clipping; any area. */
static void any_triangle(void) {
    for (int i = 0; i < 3; i++) {
        for (int c = 0; c < 3; c++)
            corners[i].attribute[c] = ANY_COMPONENT;
        corners[i].x = ANY_SHORT;
        corners[i].y = ANY_SHORT;
        corners[i].inverse_w = ANY(64, INT32_MAX);
        corners[i].flags = (uint16_t)ANY(0, UINT16_MAX);
        triangle.corners[i] = &corners[i];
    }
    triangle.area = ANY(1, INT32_MAX);
}

/* Corners' normals are in range, and of corners that are turned over no terms are known. */
#define TURNED(v) \
    (\initialized(&(v)->attribute[0..2]) && \initialized(&(v)->flags) && \
     \subset((v)->attribute[0..2], (-32767..32767)) && (v)->flags <= GLINT_VERTEX_NORMAL)

/* Any corners, normals of either sign. */
PROOF(turn_over) {
    glint_vertex turned[3];
    any_triangle();
    const int is_whole = turn_over(&triangle, turned);
    /*@ assert is_whole == 0 || is_whole == 1; */
    /*@ assert TURNED(&turned[0]) && TURNED(&turned[1]) && TURNED(&turned[2]); */
}

/* What lights a triangle: all corners are its own, of indices below 3, and it has room for their terms. */
static void any_light(const glint_frame *frame, glint_draw *alone, const glint_transform *transform, uint32_t i) {
    (void)frame, (void)transform;
    for (int corner = 0; corner < 3; corner++) {
        const uint32_t index = alone->triangles[i][corner];
        /*@ assert index < 3 && TURNED(&alone->vertices[index]); */
        alone->vertices[index].flags |= (uint16_t)ANY(0, UINT16_MAX);
        for (int c = 0; c < 3 && alone->terms; c++)
            alone->terms[index][c] = ANY_SHORT;
    }
}

/* The same, and room for what they keep. */
static void any_node_light(const glint_frame *frame, glint_draw *alone, const glint_transform *transform, uint32_t i) {
    any_light(frame, alone, transform, i);
    for (int n = 0; n < 3 * GLINT_KEPT_MAX; n++)
        alone->nodes[n] = ANY_SHORT;
}

/* What draws it: either the draw's own with corners of no terms, or the triangle alone. */
static void any_kernel(const glint_frame *frame, glint_workspace *workspace, const glint_draw *of,
                       const glint_triangle *front, const glint_part *seen) {
    (void)frame, (void)workspace, (void)seen;
    for (int i = 0; i < 3; i++) {
        const glint_vertex *const v = front->corners[i];
        /*@ assert \initialized(&v->attribute[0 .. 2]) && \subset(v->attribute[0 .. 2], (-32767 .. 32767)); */
        if (of != &draw) {
            /*@ assert v == &of->vertices[i]; */
            /*@ assert of->terms == \null || \initialized(&of->terms[0 .. 2][0 .. 2]); */
        } else if (front != &triangle) {
            /*@ assert v->flags <= GLINT_VERTEX_NORMAL; */
        }
    }
}

static const glint_evaluation by_fragments = {.light = any_light, .kernel = any_kernel},
                              at_nodes = {.light = any_node_light, .kernel = any_kernel};

/* A draw of any other vertices, with terms of fast lighting and without; parts are counted or not. */
static void any_draw(glint_workspace *workspace, int has_terms) {
    static glint_drawn drawn[GLINT_KERNELS];
    workspace->drawn = ANY(0, 1) ? drawn : 0;
    part.top = 0;
    part.bottom = ANY_UNSIGNED(0, 2);
    for (int i = 0; i < 2; i++)
        part.spans[i] = (glint_span){0, (uint8_t)ANY(0, GLINT_TILE_MAX)};
    draw.vertices = elsewhere;
    draw.terms = has_terms ? terms : 0;
    draw.evaluation = &by_fragments;
}

/* Any corners, 1/w and area, with fast lighting and without, with what corners keep for nodes and without.
 * @contract glint_is_visible */
PROOF(glint_draw_back) {
    glint_frame frame;
    glint_workspace workspace;
    any_triangle();
    FOR_PARTS(kind, 0, 2) {
        int16_t nodes[3 * GLINT_KEPT_MAX];
        any_draw(&workspace, kind == 1);
        if (kind == 2)
            draw.evaluation = &at_nodes;
        glint_draw_back(&frame, &workspace, &draw, &triangle, &part, kind == 2 ? nodes : 0);
    }
}

/* The same but for nodes, seen from both sides. @contract glint_is_visible */
PROOF(glint_draw_sides) {
    glint_frame frame;
    glint_workspace workspace;
    any_triangle();
    FOR_PARTS(kind, 0, 3) {
        triangle.back = kind & 1;
        any_draw(&workspace, kind >> 1);
        glint_draw_sides(&frame, &workspace, &draw, &triangle, &part);
    }
}
