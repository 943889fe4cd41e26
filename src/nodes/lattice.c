/* SPDX-License-Identifier: MIT */
/*
 * Lattice: the visible pixels of a triangle by cells of the screen, each drawn by polynomials where those are close
 * enough, or else in quarters, and in the end one by one.
 */
#include "../light/colour.h"
#include "../light/fragments.h"
#include "terms.h"

/* Pixels of a cell across, and their power of two; cells are halved once. */
#define CELL 16

/* Twice the area, 28.4 squared, from which on triangles have cells: of 256 pixels. */
#define CELL_AREA (256 * 512)

/* A triangle on its way to pixels. */
typedef struct lattice_walk {
    glint_gathering gathering;
    int is_deep, largest;   /* cells have at most so many pixels across */
    int32_t x, y;           /* of a cell's first pixel, in the tile */
    uint16_t visible[CELL]; /* its pixels that are nearer than what was there, by rows and bits */
} lattice_walk;

/* Pixels of a row of a square of a cell. */
static inline uint32_t row_of_nodes(const lattice_walk *w, int32_t x, int32_t y, int32_t size) {
    return (uint32_t)w->visible[y] >> x & ((1u << size) - 1);
}

/* Draws pixels of a square of a cell one by one. */
static void draw_one_by_one(const lattice_walk *w, int32_t x, int32_t y, int32_t size) {
    for (int32_t j = y; j < y + size; j++)
        for (uint32_t row = row_of_nodes(w, x, j, size), i = 0; row >> i; i++)
            if (row >> i & 1)
                glint_gather_lit(&w->gathering, w->x + x + (int32_t)i, w->y + j);
    glint_gathering_store(&w->gathering);
}

/* ---- Cells ---- */

/* Finds the runs of a square's row. @return where the next goes */
static glint_run *find_runs(uint32_t visible, uint32_t y, uint32_t *pixels, glint_run *run) {
    for (uint32_t x = 0; visible >> x;) {
        uint32_t count = 0;
        while (!(visible >> x & 1))
            x++;
        while (visible >> (x + count) & 1)
            count++;
        *run++ = (glint_run){(uint8_t)x, (uint8_t)y, (uint8_t)count};
        x += count;
        *pixels += count;
    }
    return run;
}

/* Draws pixels that terms do not tell of runs from x, y of the tile on. */
static void draw_edges(const glint_gathering *gathering, const glint_terms *terms, const glint_descent *polynomials,
                       const glint_run *runs, uint32_t count, int32_t x, int32_t y) {
    uint8_t columns[GLINT_TILE_MAX];
    for (const glint_run *run = runs; run != runs + count; run++) {
        const uint32_t found = glint_terms_find_edge(terms, polynomials, run, columns);
        for (uint32_t i = 0; i < found; i++)
            glint_gather_lit(gathering, x + columns[i], y + run->y);
    }
    glint_gathering_store(gathering);
}

/* Draws a square of a cell by polynomials through nodes 2^shift pixels apart. @return 0 where they are not close enough
 */
static int draw_square(const lattice_walk *w, int32_t x, int32_t y, unsigned shift, glint_node *const nodes[]) {
    glint_descent polynomials[GLINT_POLYNOMIALS_MAX];
    glint_terms terms;
    glint_shape shape;
    const int32_t size = 2 << shift;
    if (size > w->largest)
        return 0;
    glint_shape_cell(shift, &shape);
    const int fits = glint_shape_begin(w->gathering.frame, w->gathering.draw, &shape, nodes, &terms, polynomials);
    glint_run runs[CELL], *next = runs;
    const uint32_t offset = ((uint32_t)(w->y + y) << w->gathering.frame->tile_shift_x) + (uint32_t)(w->x + x);
    uint32_t pixels = 0;
    for (int32_t j = 0; j < size && fits; j++) {
        next = find_runs(row_of_nodes(w, x, y + j, size), (uint32_t)j, &pixels, next);
        if (next > runs + CELL / 2 || pixels > w->gathering.frame->config.tile_width || j == size - 1) {
            glint_terms_draw(w->gathering.frame, w->gathering.workspace, &terms, polynomials, runs,
                             (uint32_t)(next - runs), offset);
            if (terms.margin)
                draw_edges(&w->gathering, &terms, polynomials, runs, (uint32_t)(next - runs), w->x + x, w->y + y);
            next = runs;
            pixels = 0;
        }
    }
    return fits;
}

/* ---- Nodes ---- */

/* Nodes on their way: where they go. */
typedef struct batch {
    const glint_gathering *from;
    glint_node *to[GLINT_FRAGMENTS_MAX];
} batch;

/* Lights nodes, but for lights that are `away` from them. */
static void light_batch(const batch *b, uint32_t away) {
    const glint_draw *draw = b->from->draw;
    const glint_shading *shading = draw->shading;
    glint_fragments *at = b->from->fragments;
    glint_find_rays(b->from->frame, at);
    glint_find_surface(at, draw, glint_extend_colour);
    glint_nodes_light(b->from->frame, shading, at, shading->lights & ~away, shading->terms->lobes & ~away, b->to);
    for (uint32_t i = 0; i < at->count; i++) {
        glint_node *node = b->to[i];
        node->inverse_w = at->inverse_w[i];
        for (int c = 0; c < 3; c++) {
            node->normal[c] = at->normal[i][c];
            node->surface[c] = draw->extra ? at->surface[i][c] : 0;
        }
        glint_node_leave(node, away);
    }
    at->count = 0;
}

/* Adds the node at a pixel of the tile. */
static void add_node(batch *b, int32_t x, int32_t y, glint_node *node) {
    const glint_part *part = b->from->part;
    b->to[b->from->fragments->count] = node;
    glint_gather(b->from, x, y, glint_plane_at(&part->depth, part->x + x, part->y + y));
}

/* A square of a cell, whose first pixel is x, y there; those of its nodes that are not another's. */
typedef struct square {
    glint_node own[5];
    glint_node *nodes[GLINT_CELL_NODES];
    int32_t x, y;
} square;

/* Is a node a corner of its square? */
static inline int is_corner(int i) {
    return i == 0 || i == 2 || i == 6 || i == 8;
}

/* Lights the nodes of a square but for its corners, which are; they are 2^shift pixels apart. */
static void light_square(const lattice_walk *w, unsigned shift, square *to) {
    batch b = {&w->gathering, {0}};
    glint_shape shape;
    int own = 0;
    for (int i = 0; i < GLINT_CELL_NODES; i++) {
        if (is_corner(i))
            continue;
        to->nodes[i] = &to->own[own++];
        add_node(&b, w->x + to->x + i % 3 * (1 << shift), w->y + to->y + i / 3 * (1 << shift), to->nodes[i]);
    }
    glint_shape_cell(shift, &shape);
    light_batch(&b, glint_shape_away(w->gathering.draw, &shape, to->nodes));
}

/* Finds the nodes of quarter i of a square; they are 2^shift pixels apart. */
static void begin_quarter(const lattice_walk *w, const square *of, int i, unsigned shift, square *to) {
    const int first = i % 2 + 3 * (i / 2);
    to->x = of->x + (i % 2 << (shift + 1));
    to->y = of->y + (i / 2 << (shift + 1));
    to->nodes[0] = of->nodes[first];
    to->nodes[2] = of->nodes[first + 1];
    to->nodes[6] = of->nodes[first + 3];
    to->nodes[8] = of->nodes[first + 4];
    light_square(w, shift, to);
}

/* ---- Squares ---- */

/* Does a square of a cell show? */
static int is_visible(const lattice_walk *w, int32_t x, int32_t y, int32_t size) {
    uint32_t any = 0;
    for (int32_t j = y; j < y + size; j++)
        any |= row_of_nodes(w, x, j, size);
    return any != 0;
}

/* Draws a square of eight pixels: as one, as four, or one by one. */
static void draw_eight(const lattice_walk *w, const square *eight) {
    square four;
    if (draw_square(w, eight->x, eight->y, 2, eight->nodes))
        return;
    for (int i = 0; i < 4; i++) {
        if (!is_visible(w, eight->x + i % 2 * 4, eight->y + i / 2 * 4, 4))
            continue;
        begin_quarter(w, eight, i, 1, &four);
        if (!draw_square(w, four.x, four.y, 1, four.nodes))
            draw_one_by_one(w, four.x, four.y, 4);
    }
}

/* Draws a cell: as one, or as four squares. */
static void draw_cell(const lattice_walk *w) {
    glint_node corners[4];
    square whole = {.x = 0, .y = 0}, eight;
    batch b = {&w->gathering, {0}};
    for (int i = 0; i < 4; i++) {
        whole.nodes[i % 2 * 2 + i / 2 * 6] = &corners[i];
        add_node(&b, w->x + i % 2 * CELL, w->y + i / 2 * CELL, &corners[i]);
    }
    light_batch(&b, 0);
    light_square(w, 3, &whole);
    if (draw_square(w, 0, 0, 3, whole.nodes))
        return;
    for (int i = 0; i < 4; i++) {
        if (!is_visible(w, i % 2 * 8, i / 2 * 8, 8))
            continue;
        begin_quarter(w, &whole, i, 2, &eight);
        draw_eight(w, &eight);
    }
}

/* Tests the depth of a row of a cell, and stores what is nearer. @return pixels that are, by bits */
static uint32_t test_row(const lattice_walk *w, int32_t y, uint32_t *covered) {
    const glint_part *part = w->gathering.part;
    const glint_span span = part->spans[y];
    const int32_t left = glint_most(span.left, w->x), right = glint_least(span.right, w->x + CELL);
    uint16_t *const depth = w->gathering.workspace->depth + ((uint32_t)y << w->gathering.frame->tile_shift_x);
    uint32_t z = (uint32_t)glint_plane_at(&part->depth, part->x + left, part->y + y) + GLINT_DEPTH_BIAS;
    uint32_t visible = 0;
    for (int32_t x = left; x < right; x++, z += (uint32_t)part->depth.dx) {
        const uint32_t here = (w->is_deep ? (uint32_t)glint_most((int32_t)z, GLINT_DEPTH_BIAS) : z) >> 15;
        if (here <= depth[x])
            continue;
        depth[x] = (uint16_t)here;
        visible |= 1u << (x - w->x);
    }
    *covered += (uint32_t)glint_most(right - left, 0);
    return visible;
}

/* Tests the depth of a cell. @return does any of it show? */
static int test_cell(lattice_walk *w, uint32_t *covered) {
    uint32_t any = 0;
    for (int32_t j = 0; j < CELL; j++) {
        const int32_t y = w->y + j;
        w->visible[j] = (uint16_t)(y >= (int32_t)w->gathering.part->top && y < (int32_t)w->gathering.part->bottom
                                       ? test_row(w, y, covered)
                                       : 0);
        any |= w->visible[j];
    }
    return any != 0;
}

/* The largest cells of a triangle whose planes keep their sign and size across one. */
static int find_largest(const glint_part *part, const glint_attributes *attributes, int has_surface) {
    int size = CELL;
    for (int i = has_surface ? 0 : 3; i < 7; i++) {
        const glint_plane *p = i < 3 ? &attributes->extra[i] : i < 6 ? &attributes->main[i - 3] : &part->depth;
        const uint32_t across = glint_magnitude_bits(p->dx), down = glint_magnitude_bits(p->dy);
        while (size && (across >= (1u << 29) / (uint32_t)size || down >= (1u << 29) / (uint32_t)size))
            size /= 2;
    }
    return size;
}

/* The normals of a triangle's corners. */
#define NORMALS(triangle) \
    { (triangle)->corners[0]->attribute, (triangle)->corners[1]->attribute, (triangle)->corners[2]->attribute }

int glint_draw_lattice(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                       const glint_triangle *triangle, const glint_part *part) {
    const int16_t *const normals[3] = NORMALS(triangle);
    glint_attributes attributes;
    glint_fragments fragments;
    uint32_t covered = 0;
    lattice_walk w = {.gathering = {frame, workspace, part, draw, glint_shade, &fragments}};
    if (triangle->area < CELL_AREA)
        return 0;
    glint_gathering_begin(&w.gathering, triangle, normals, triangle->back, &attributes);
    w.is_deep = glint_is_deep(triangle);
    w.largest = find_largest(part, &attributes, draw->extra != 0);
    if (!w.largest)
        return 0;
    const int32_t column = part->window.left >> 4 & (CELL - 1), row = part->window.top >> 4 & (CELL - 1);
    for (w.y = -row; w.y < (int32_t)part->bottom; w.y += CELL)
        for (w.x = -column; w.x < (int32_t)frame->config.tile_width; w.x += CELL)
            if (test_cell(&w, &covered))
                draw_cell(&w);
    glint_count(workspace, GLINT_KERNEL_GENERAL, covered);
    return 1;
}

void glint_draw_edges(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                      const glint_triangle *triangle, const glint_part *part, const glint_terms *terms,
                      const glint_descent *polynomials, const glint_run *runs, uint32_t count) {
    const int16_t *const normals[3] = NORMALS(triangle);
    glint_attributes attributes;
    glint_fragments fragments;
    const glint_gathering gathering = {frame, workspace, part, draw, glint_shade, &fragments};
    glint_gathering_begin(&gathering, triangle, normals, triangle->back, &attributes);
    draw_edges(&gathering, terms, polynomials, runs, count, 0, 0);
}
