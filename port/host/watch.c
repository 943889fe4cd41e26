/* SPDX-License-Identifier: MIT */
#include "watch.h"

#include "light/evaluation.h"
#include "raster/found.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The library's functions. */
extern __typeof__(glint_render_tile) __real_glint_render_tile;
extern __typeof__(glint_setup) __real_glint_setup, __wrap_glint_setup;
extern __typeof__(glint_draw_unlit) __real_glint_draw_unlit, __wrap_glint_draw_unlit;
extern __typeof__(glint_ring_find) __real_glint_ring_find, __wrap_glint_ring_find;
extern __typeof__(glint_gathering_store) __real_glint_gathering_store;
extern __typeof__(glint_draw_facet) __real_glint_draw_facet;
extern __typeof__(glint_draw_lit) __real_glint_draw_lit;
extern __typeof__(glint_nodes_light) __real_glint_nodes_light;
extern __typeof__(glint_terms_begin) __real_glint_terms_begin;
extern __typeof__(glint_shape_begin) __real_glint_shape_begin;
extern __typeof__(glint_terms_draw_part) __real_glint_terms_draw_part;

const way_look watch_looks[WAYS] = {
    {"background", {0x00, 0x00, 0x00}},
    {"fast lighting", {0x8d, 0x93, 0x9c}},
    {"one colour: no light reaches it", {0x4b, 0x4f, 0x57}},
    {"planes", {0xc3, 0xe8, 0x8d}},
    {"quadratics", {0x4f, 0xb0, 0x6d}},
    {"quadratics over length", {0x14, 0x71, 0x3a}},
    {"pieces: triangles in four", {0x12, 0xb5, 0xa5}},
    {"squares of 16", {0xbc, 0xd9, 0xf7}},
    {"squares of 8", {0x5f, 0x9d, 0xe0}},
    {"squares of 4", {0x1d, 0x50, 0xa2}},
    {"fragments one by one", {0xe0, 0x40, 0x2a}},
    {"at corners, once a vertex", {0xf2, 0xb1, 0x34}},
    {"once a facet", {0xa8, 0x6b, 0xd6}},
};

/* At least as many as four cells and all their squares have nodes: for so long a corner may be kept. */
enum { PLACES = 512 };

/* A node, and where it lies. */
typedef struct placed {
    const glint_node *node;
    node_place at;
} placed;

/* What is seen, and of what. */
static struct {
    watched *seen; /* or null */
    const glint_workspace *workspace;
    unsigned shift;                                   /* binary logarithm of the tile's width */
    int left, top, width, height;                     /* of the tile */
    uint16_t depth[GLINT_TILE_MAX * GLINT_TILE_MAX];  /* as it was before the triangle */
    uint8_t is_told[GLINT_TILE_MAX * GLINT_TILE_MAX]; /* pixels of the triangle whose way was seen one by one */
    int has_triangle, triangle, region;               /* numbers of areas; no region is -1 */
    way usual, of_region; /* of the triangle's other pixels, and of what is drawn by polynomials */
    placed places[PLACES];
    unsigned place_count;
} now;

/* ---- Pixels ---- */

static void tell(int column, int row, way how, int owner) {
    const int at = (now.top + row) * now.seen->width + now.left + column;
    now.seen->ways[at] = (uint8_t)how;
    if (now.seen->owners != NULL)
        now.seen->owners[at] = owner;
}

static void tell_one(int column, int row, way how, int owner) {
    now.is_told[(row << now.shift) + column] = 1;
    tell(column, row, how, owner);
}

/* Tells of the pixels that the last triangle drew: those that came nearer. */
static void finish_triangle(void) {
    for (int row = 0; row < now.height && now.has_triangle; row++)
        for (int column = 0; column < now.width; column++) {
            const int at = (row << now.shift) + column;
            if (now.workspace->depth[at] != now.depth[at] && !now.is_told[at])
                tell(column, row, now.usual, now.triangle);
        }
    now.has_triangle = 0;
}

static int add_area(const lit_area *of) {
    if (now.seen->areas == NULL)
        return -1;
    if (now.seen->area_count == WATCH_AREAS_MAX) {
        fputs("too many areas\n", stderr);
        exit(1);
    }
    now.seen->areas[now.seen->area_count] = *of;
    return now.seen->area_count++;
}

/* ---- Tiles and triangles ---- */

int watch_render_tile(const glint_frame *frame, glint_workspace *workspace, uint32_t tile) {
    if (now.seen == NULL)
        return __real_glint_render_tile(frame, workspace, tile);
    now.workspace = workspace;
    now.shift = frame->tile_shift_x;
    now.has_triangle = 0;
    glint_tile_rectangle(frame, tile, &now.left, &now.top, &now.width, &now.height);
    const int is_finished = __real_glint_render_tile(frame, workspace, tile);
    finish_triangle();
    return is_finished;
}

static void begin_triangle(const glint_triangle *triangle) {
    lit_area of = {.node_count = 0};
    finish_triangle();
    for (int i = 0; i < 3; i++)
        of.corners[i] = (node_place){triangle->corners[i]->x, triangle->corners[i]->y};
    now.triangle = add_area(&of);
    now.has_triangle = 1;
    now.region = -1;
    now.usual = WAY_FAST; /* of which nothing else is seen */
    memcpy(now.depth, now.workspace->depth, sizeof now.depth[0] * (size_t)now.height << now.shift);
    memset(now.is_told, 0, sizeof now.is_told);
}

void __wrap_glint_setup(glint_part *part, glint_triangle *triangle) {
    if (now.seen != NULL)
        begin_triangle(triangle);
    __real_glint_setup(part, triangle);
}

/* What is watched is found anew in each tile: the ways are the same. */
const void *__wrap_glint_ring_find(const glint_workspace *workspace, uint32_t key) {
    return now.seen != NULL ? NULL : __real_glint_ring_find(workspace, key);
}

void __wrap_glint_draw_unlit(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                             const glint_triangle *triangle, const glint_part *part) {
    now.usual = WAY_EVEN;
    __real_glint_draw_unlit(frame, workspace, draw, triangle, part);
}

void watch_draw_facet(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                      const glint_triangle *triangle, const glint_part *part) {
    now.usual = WAY_FACET;
    __real_glint_draw_facet(frame, workspace, draw, triangle, part);
}

void watch_draw_lit(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                    const glint_triangle *triangle, const glint_part *part) {
    now.usual = WAY_CORNERS;
    __real_glint_draw_lit(frame, workspace, draw, triangle, part);
}

static node_place middle_of(node_place a, node_place b) {
    return (node_place){(a.x + b.x) / 2, (a.y + b.y) / 2};
}

int watch_terms_begin(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                      const glint_part *part, glint_terms *terms, glint_polynomials *polynomials, glint_reach *reach) {
    if (!__real_glint_terms_begin(frame, draw, triangle, part, terms, polynomials, reach))
        return 0;
    now.usual = terms->is_over_length ? WAY_OVER_LENGTH : terms->is_curved ? WAY_QUADRATICS : WAY_PLANES;
    now.of_region = now.usual;
    now.region = now.triangle;
    if (now.seen == NULL || now.seen->areas == NULL)
        return 1;
    lit_area *of = &now.seen->areas[now.triangle];
    of->node_count = terms->is_curved ? 6 : 3;
    for (int i = 0; i < 3; i++) {
        of->nodes[i] = of->corners[i];
        of->nodes[3 + i] = middle_of(of->corners[i], of->corners[(i + 1) % 3]);
    }
    return 1;
}

/* ---- Pieces and squares ---- */

/* A point's ray tells where on the screen it lies: glint_find_ray. */
void watch_nodes_light(const glint_frame *frame, const glint_shading *shading, glint_fragments *at, uint32_t lights,
                       uint32_t lobes, int tells, glint_node *const nodes[]) {
    for (uint32_t i = 0; now.seen != NULL && i < at->count; i++)
        now.places[now.place_count++ % PLACES] = (placed){
            nodes[i],
            {(frame->config.width * 4096 - at->ray[i][0]) / 512, (frame->config.height * 4096 + at->ray[i][1]) / 512}};
    __real_glint_nodes_light(frame, shading, at, lights, lobes, tells, nodes);
}

/* Where a node was lit last. */
static node_place place_of(const glint_node *node) {
    for (unsigned i = 1; i <= PLACES; i++) {
        const placed *found = &now.places[(now.place_count - i) % PLACES];
        if (found->node == node)
            return found->at;
    }
    fputs("a node that was never lit\n", stderr);
    exit(1);
}

static int add_region(const glint_shape *shape, glint_node *const nodes[]) {
    if (now.seen->areas == NULL)
        return -1;
    lit_area of = now.seen->areas[now.triangle];
    const int is_piece = shape->count != GLINT_CELL_NODES;
    of.size = is_piece ? 0 : 2 << shape->shift;
    of.node_count = shape->count;
    for (int i = 0; i < of.node_count; i++)
        of.nodes[i] = place_of(nodes[i]);
    for (int i = 0; i < 3 && is_piece; i++)
        of.corners[i] = of.nodes[i];
    return add_area(&of);
}

int watch_shape_begin(const glint_frame *frame, const glint_draw *draw, const glint_shape *shape,
                      glint_node *const nodes[], glint_terms *terms, glint_polynomials *polynomials) {
    now.region = -1;
    if (!__real_glint_shape_begin(frame, draw, shape, nodes, terms, polynomials))
        return 0;
    if (now.seen != NULL) {
        const int size = 2 << shape->shift;
        now.region = add_region(shape, nodes);
        now.of_region = shape->count != GLINT_CELL_NODES ? WAY_PIECES
                        : size == 16                     ? WAY_SQUARES_16
                        : size == 8                      ? WAY_SQUARES_8
                                                         : WAY_SQUARES_4;
    }
    return 1;
}

void watch_terms_draw_part(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                           const glint_triangle *triangle, const glint_part *part, const glint_terms *terms,
                           const glint_polynomials *polynomials) {
    static uint16_t before[GLINT_TILE_MAX * GLINT_TILE_MAX];
    if (now.seen != NULL)
        memcpy(before, workspace->depth, sizeof before[0] * (size_t)now.height << now.shift);
    __real_glint_terms_draw_part(frame, workspace, draw, triangle, part, terms, polynomials);
    if (now.seen == NULL)
        return;
    for (int row = (int)part->top; row < (int)part->bottom; row++)
        for (int column = part->spans[row].left; column < part->spans[row].right; column++) {
            const int at = (row << now.shift) + column;
            if (workspace->depth[at] != before[at] && !now.is_told[at])
                tell_one(column, row, now.of_region, now.region);
        }
}

/* ---- Fragments ---- */

void watch_gathering_store(const glint_gathering *gathering) {
    const glint_fragments *fragments = gathering->fragments;
    for (uint32_t i = 0; now.seen != NULL && i < fragments->count; i++)
        tell_one(fragments->column[i], fragments->row[i], WAY_ONE_BY_ONE, now.triangle);
    __real_glint_gathering_store(gathering);
}

/* ---- Public ---- */

void watch_into(watched *seen) {
    now.seen = seen;
    now.has_triangle = 0;
    for (int i = 0; seen != NULL && i < seen->width * seen->height; i++) {
        seen->ways[i] = WAY_NONE;
        if (seen->owners != NULL)
            seen->owners[i] = -1;
    }
}
