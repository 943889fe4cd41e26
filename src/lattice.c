/* SPDX-License-Identifier: MIT */
/*
 * Lattice: the visible pixels of a triangle by cells of the screen, each drawn by polynomials where those are close
 * enough, or else in quarters, and in the end one by one.
 */
#include "colour.h"
#include "fragments.h"
#include "light.h"
#include "terms.h"

/* Pixels of a cell across, and their power of two; cells are halved once. */
#define CELL 16

/* Twice the area, 28.4 squared, from which on triangles have cells: of 256 pixels. */
#define CELL_AREA (256 * 512)

/* A triangle on its way to pixels. */
typedef struct walk {
    glint_gathering gathering;
    int is_deep, largest;   /* cells have at most so many pixels across */
    int32_t x, y;           /* of a cell's first pixel, in the tile */
    uint16_t visible[CELL]; /* its pixels that are nearer than what was there, by rows and bits */
} walk;

/* Pixels of a row of a square of a cell. */
static inline uint32_t row_of(const walk *w, int32_t x, int32_t y, int32_t size) {
    return (uint32_t)w->visible[y] >> x & ((1u << size) - 1);
}

/* Draws pixels of a square of a cell one by one. */
static void draw_one_by_one(const walk *w, int32_t x, int32_t y, int32_t size) {
    for (int32_t j = y; j < y + size; j++)
        for (uint32_t row = row_of(w, x, j, size), i = 0; row >> i; i++)
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
static int draw_square(const walk *w, int32_t x, int32_t y, unsigned shift, glint_node *const nodes[]) {
    glint_descent polynomials[GLINT_POLYNOMIALS_MAX];
    glint_terms terms;
    const int32_t size = 2 << shift;
    if (size > w->largest)
        return 0;
    const int fits = glint_cell_begin(w->gathering.frame, w->gathering.draw, nodes, shift, &terms, polynomials);
    glint_run runs[CELL], *next = runs;
    const uint32_t offset = ((uint32_t)(w->y + y) << w->gathering.frame->tile_shift_x) + (uint32_t)(w->x + x);
    uint32_t pixels = 0;
    for (int32_t j = 0; j < size && fits; j++) {
        next = find_runs(row_of(w, x, y + j, size), (uint32_t)j, &pixels, next);
        if (next > runs + CELL / 2 || pixels > w->gathering.frame->config.tile_width || j == size - 1) {
            glint_terms_draw(w->gathering.frame, w->gathering.workspace, &terms, polynomials, runs, (uint32_t)(next - runs), offset);
            if (terms.margin)
                draw_edges(&w->gathering, &terms, polynomials, runs, (uint32_t)(next - runs), w->x + x, w->y + y);
            next = runs;
            pixels = 0;
        }
    }
    return fits;
}

/* ---- Nodes ---- */

/* Nodes of a square on their way: where they are, from the cell's first pixel. */
typedef struct batch {
    const walk *w;
    int32_t x, y;
    glint_node *to[GLINT_FRAGMENTS_MAX];
} batch;

static void light_batch(batch *b) {
    const walk *w = b->w;
    glint_fragments *at = w->gathering.fragments;
    if (!at->count)
        return;
    glint_find_rays(w->gathering.frame, at);
    glint_find_surface(at, w->gathering.draw, glint_extend_colour);
    glint_nodes_light(w->gathering.frame, w->gathering.draw->shading, at, w->gathering.draw->shading->lights, w->gathering.draw->shading->terms->lobes, b->to);
    for (uint32_t i = 0; i < at->count; i++) {
        b->to[i]->inverse_w = at->inverse_w[i];
        for (int c = 0; c < 3; c++) {
            b->to[i]->normal[c] = at->normal[i][c];
            b->to[i]->surface[c] = w->gathering.draw->extra ? at->surface[i][c] : 0;
        }
    }
    at->count = 0;
}

static void add_node(batch *b, int32_t x, int32_t y, glint_node *node) {
    const glint_gathering *gathering = &b->w->gathering;
    const glint_part *part = gathering->part;
    const int32_t column = b->w->x + b->x + x, row = b->w->y + b->y + y;
    b->to[gathering->fragments->count] = node;
    glint_gather(gathering, column, row, glint_plane_at(&part->depth, part->x + column, part->y + row));
    if (gathering->fragments->count == GLINT_FRAGMENTS_MAX)
        light_batch(b);
}

/* Nodes of a square of eight pixels: five by five, two pixels apart. */
typedef struct fine_nodes {
    glint_node node[5][5];
} fine_nodes;

/* The nodes of a square of them, `step` apart. */
static void take_nodes(fine_nodes *of, int column, int row, int step, glint_node *nodes[GLINT_CELL_NODES]) {
    for (int j = 0; j < 3; j++)
        for (int i = 0; i < 3; i++)
            nodes[3 * j + i] = &of->node[row + j * step][column + i * step];
}

/* Does a square of a cell show? */
static int is_visible(const walk *w, int32_t x, int32_t y, int32_t size) {
    uint32_t any = 0;
    for (int32_t j = y; j < y + size; j++)
        any |= row_of(w, x, j, size);
    return any != 0;
}

/* Draws a square of eight pixels whose corners' nodes are known: as one, as four, or by fragments. */
static void draw_eight(const walk *w, int32_t x, int32_t y, fine_nodes *of) {
    batch b = {w, x, y, {0}};
    glint_node *nodes[GLINT_CELL_NODES];
    for (int i = 1; i < 8; i++)
        if (i != 2 && i != 6)
            add_node(&b, i % 3 * 4, i / 3 * 4, &of->node[i / 3 * 2][i % 3 * 2]);
    light_batch(&b);
    take_nodes(of, 0, 0, 2, nodes);
    if (draw_square(w, x, y, 2, nodes))
        return;
    for (int j = 0; j < 5; j++)
        for (int i = 0; i < 5; i++)
            if ((i | j) & 1)
                add_node(&b, i * 2, j * 2, &of->node[j][i]);
    light_batch(&b);
    for (int i = 0; i < 4; i++) {
        const int column = i % 2 * 2, row = i / 2 * 2;
        take_nodes(of, column, row, 1, nodes);
        if (is_visible(w, x + 2 * column, y + 2 * row, 4) && !draw_square(w, x + 2 * column, y + 2 * row, 1, nodes))
            draw_one_by_one(w, x + 2 * column, y + 2 * row, 4);
    }
}

/* Draws a cell: as one, or as four squares. */
static void draw_visible(const walk *w) {
    glint_node node[GLINT_CELL_NODES], *nodes[GLINT_CELL_NODES];
    fine_nodes fine;
    batch b = {w, 0, 0, {0}};
    for (int i = 0; i < GLINT_CELL_NODES; i++) {
        nodes[i] = &node[i];
        add_node(&b, i % 3 * 8, i / 3 * 8, nodes[i]);
    }
    light_batch(&b);
    if (draw_square(w, 0, 0, 3, nodes))
        return;
    for (int i = 0; i < 4; i++) {
        const int column = i % 2, row = i / 2;
        if (!is_visible(w, column * 8, row * 8, 8))
            continue;
        fine.node[0][0] = *nodes[3 * row + column];
        fine.node[0][4] = *nodes[3 * row + column + 1];
        fine.node[4][0] = *nodes[3 * row + column + 3];
        fine.node[4][4] = *nodes[3 * row + column + 4];
        draw_eight(w, column * 8, row * 8, &fine);
    }
}

/* Tests the depth of a row of a cell, and stores what is nearer. @return pixels that are, by bits */
static uint32_t test_row(const walk *w, int32_t y, uint32_t *covered) {
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
static int test_cell(walk *w, uint32_t *covered) {
    uint32_t any = 0;
    for (int32_t j = 0; j < CELL; j++) {
        const int32_t y = w->y + j;
        w->visible[j] =
            (uint16_t)(y >= (int32_t)w->gathering.part->top && y < (int32_t)w->gathering.part->bottom ? test_row(w, y, covered) : 0);
        any |= w->visible[j];
    }
    return any != 0;
}

/* The largest cells of a triangle whose planes keep their sign and size across one. */
static int find_largest(const glint_part *part, const glint_attributes *attributes,
                        int has_surface) {
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
    walk w = {.gathering = {frame, workspace, part, draw, glint_shade, &fragments}};
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
                draw_visible(&w);
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
