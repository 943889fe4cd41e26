/* SPDX-License-Identifier: MIT */
/*
 * Lattice: the visible pixels of a triangle by cells of the screen, each drawn by polynomials where those are close
 * enough, or else in quarters, and in the end one by one.
 */
#include "../light/colour.h"
#include "../light/fragments.h"
#include "shapes.h"

/* Pixels of a cell across; cells are halved twice. */
#define CELL 16

/* Twice the area, 28.4 squared, from which on triangles have cells: of 256 pixels. */
#define CELL_AREA (256 * 512)

/* A triangle on its way to pixels. */
typedef struct lattice_walk {
    glint_gathering gathering; /* of nodes, and of pixels one by one */
    const glint_triangle *triangle;
    glint_attributes attributes;
    int32_t largest; /* squares have at most so many pixels across */
    uint32_t lobes;  /* highlights that may show */
    int has_cones;   /* its lights have */
    glint_part cut;  /* what of the triangle's part a square holds */
} lattice_walk;

/* ---- Nodes ---- */

/* Nodes on their way: where they go. */
typedef struct batch {
    const lattice_walk *walk;
    const glint_gathering *from;
    glint_node *to[GLINT_FRAGMENTS_MAX];
} batch;

/* Lights nodes, but for lights that are away from the triangle, or whose cones they lie outside of. */
static void light_batch(const batch *b, uint32_t outside) {
    const uint32_t away = b->walk->triangle->away | outside;
    const glint_draw *draw = b->from->draw;
    const glint_shading *shading = draw->shading;
    glint_fragments *at = b->from->fragments;
    if (!at->count)
        return;
    glint_find_rays(b->from->frame, at);
    glint_find_surface(at, draw, glint_extend_colour);
    glint_nodes_light(b->from->frame, shading, at, shading->lights & ~away, b->walk->lobes & ~away, 1, b->to);
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

/* A square whose first pixel is x, y of the tile; those of its nodes that are not another's. */
typedef struct lattice_square {
    glint_node own[5];
    glint_node *nodes[GLINT_CELL_NODES];
    int32_t x, y;
    int is_lit; /* it shows: its nodes are lit */
} lattice_square;

/*
 * Squares are walked so that each borders the last one, whose nodes it has on that side: a side, by the node in its
 * middle, 8 less which is the last one's.
 */
enum { NO_SIDE = 0, TOP_SIDE = 1, LEFT_SIDE = 3, RIGHT_SIDE = 5 };

/* Is a node a corner of its square? */
static inline int is_corner(int i) {
    return i == 0 || i == 2 || i == 6 || i == 8;
}

/* Begins nodes; rows of colours have the fragments' place, and end what is there. */
static void begin_batch(const lattice_walk *w, batch *b) {
    glint_fragments *at = w->gathering.fragments;
    b->walk = w;
    b->from = &w->gathering;
    at->count = 0;
    at->part = w->gathering.part;
    at->attributes = &w->attributes;
    at->scale = glint_find_room(w->triangle->corners);
    at->away = w->triangle->away;
}

/* Begins a square that nothing borders yet; its corners are another's. */
static void begin_square(lattice_square *of) {
    for (int i = 0; i < 5; i++)
        of->nodes[i == 0 ? 1 : i == 4 ? 7 : i + 2] = &of->own[i];
    of->is_lit = 0;
}

static void swap_nodes(lattice_square *of, int a, int b) {
    glint_node *const node = of->nodes[a];
    of->nodes[a] = of->nodes[b];
    of->nodes[b] = node;
}

/* Lights the nodes of a square, 2^shift pixels apart; of its corners those that are in the batch. */
static void light_square(const lattice_walk *w, unsigned shift, int side, lattice_square *to, batch *b) {
    uint32_t outside = 0;
    if (w->has_cones) {
        glint_shape shape;
        light_batch(b, 0);
        glint_shape_cell(w->gathering.part, w->lobes, to->x, to->y, shift, &shape);
        outside = glint_shape_away(w->gathering.draw, &shape, to->nodes);
    }
    const int is_there =
        side && to->nodes[8 - side]->left == (w->triangle->away | outside); /* lit as it would be here */
    if (is_there)
        swap_nodes(to, side, 8 - side);
    for (int i = 0; i < GLINT_CELL_NODES; i++)
        if (!is_corner(i) && (!is_there || i != side))
            add_node(b, to->x + i % 3 * (1 << shift), to->y + i / 3 * (1 << shift), to->nodes[i]);
    light_batch(b, outside);
}

/* ---- Squares ---- */

/* Cuts the triangle's part to a square so many pixels across. @return does any of it show? */
static int cut_square(lattice_walk *w, const lattice_square *to, int32_t size) {
    const glint_part *part = w->gathering.part;
    glint_part *cut = &w->cut;
    cut->top = (uint32_t)glint_most((int32_t)part->top, to->y);
    cut->bottom = (uint32_t)glint_most(glint_least((int32_t)part->bottom, to->y + size), 0);
    for (uint32_t y = cut->top; y < cut->bottom; y++) {
        const glint_span span = part->spans[y];
        const int32_t left = glint_most(span.left, to->x), right = glint_least(span.right, to->x + size);
        cut->spans[y] = (glint_span){(uint8_t)left, (uint8_t)glint_most(left, right)};
    }
    return glint_is_visible(w->gathering.frame, w->gathering.workspace, cut);
}

/* Begins a cell that borders the last one. @return does any of it show? */
static int begin_cell(lattice_walk *w, int32_t x, int32_t y, int side, lattice_square *to) {
    const int from = to->is_lit ? side : NO_SIDE;
    batch b;
    to->x = x;
    to->y = y;
    to->is_lit = cut_square(w, to, CELL);
    if (!to->is_lit)
        return 0;
    if (from) {
        swap_nodes(to, 0, from == TOP_SIDE ? 6 : 2);
        swap_nodes(to, from == TOP_SIDE ? 2 : 6, 8);
    }
    begin_batch(w, &b);
    for (int i = 0; i < 4; i++)
        if ((from != TOP_SIDE || i >= 2) && (from != LEFT_SIDE || i % 2) && (from != RIGHT_SIDE || i % 2 == 0))
            add_node(&b, x + i % 2 * CELL, y + i / 2 * CELL, to->nodes[i % 2 * 2 + i / 2 * 6]);
    light_square(w, 3, from, to, &b);
    return 1;
}

/* Begins quarter i of a square, round its centre, with nodes 2^shift pixels apart. @return does any of it show? */
static int begin_quarter(lattice_walk *w, const lattice_square *of, int i, unsigned shift, lattice_square *to) {
    static const uint8_t sides[4] = {NO_SIDE, LEFT_SIDE, TOP_SIDE, RIGHT_SIDE};
    const int side = to->is_lit ? sides[i] : NO_SIDE, column = i == 1 || i == 2, row = i / 2, first = column + 3 * row;
    batch b;
    to->x = of->x + column * (2 << shift);
    to->y = of->y + row * (2 << shift);
    to->is_lit = cut_square(w, to, 2 << shift);
    if (!to->is_lit)
        return 0;
    to->nodes[0] = of->nodes[first];
    to->nodes[2] = of->nodes[first + 1];
    to->nodes[6] = of->nodes[first + 3];
    to->nodes[8] = of->nodes[first + 4];
    begin_batch(w, &b);
    light_square(w, shift, side, to, &b);
    return 1;
}

/* Draws what is cut by polynomials through nodes 2^shift pixels apart. @return 0 where they are not close enough */
static int draw_square(const lattice_walk *w, unsigned shift, const lattice_square *of) {
    const glint_gathering *from = &w->gathering;
    glint_polynomials polynomials;
    glint_terms terms;
    glint_shape shape;
    glint_shape_cell(from->part, w->lobes, of->x, of->y, shift, &shape);
    if (2 << shift > w->largest || !glint_shape_begin(from->frame, from->draw, &shape, of->nodes, &terms, &polynomials))
        return 0;
    glint_terms_draw_part(from->frame, from->workspace, from->draw, w->triangle, &w->cut, &terms, &polynomials);
    return 1;
}

/* Draws what is cut of a square of four pixels one by one, by the shorter of both searches for runs. */
static void draw_one_by_one(const lattice_walk *w) {
    glint_run runs[2];
    for (uint32_t y = w->cut.top; y < w->cut.bottom; y++) {
        const glint_run *const end = glint_find_runs(w->gathering.frame, w->gathering.workspace, &w->cut, 1, y, runs);
        for (const glint_run *run = runs; run != end; run++)
            for (uint32_t i = 0; i < run->count; i++)
                glint_gather_lit(&w->gathering, (int32_t)(run->x + i), run->y);
    }
    glint_gathering_store(&w->gathering);
}

/* Draws a square of eight pixels: as one, as four, or one by one. */
static void draw_eight(lattice_walk *w, const lattice_square *eight) {
    lattice_square four;
    if (draw_square(w, 2, eight))
        return;
    begin_square(&four);
    for (int i = 0; i < 4; i++)
        if (begin_quarter(w, eight, i, 1, &four) && !draw_square(w, 1, &four))
            draw_one_by_one(w);
}

/* Draws a cell: as one, or as four squares. */
static void draw_cell(lattice_walk *w, const lattice_square *whole) {
    lattice_square eight;
    if (draw_square(w, 3, whole))
        return;
    begin_square(&eight);
    for (int i = 0; i < 4; i++)
        if (begin_quarter(w, whole, i, 2, &eight))
            draw_eight(w, &eight);
}

/* Draws the cells of a tile, every other row from right to left. */
static void draw_cells(lattice_walk *w) {
    const glint_part *part = w->gathering.part;
    const int32_t left = -(part->window.left >> 4 & (CELL - 1)), top = -(part->window.top >> 4 & (CELL - 1));
    const int32_t last = (w->gathering.frame->config.tile_width - 1 - left) / CELL * CELL;
    glint_node corners[4];
    lattice_square whole;
    begin_square(&whole);
    for (int i = 0; i < 4; i++)
        whole.nodes[i % 2 * 2 + i / 2 * 6] = &corners[i];
    for (int32_t y = 0; y < (int32_t)part->bottom - top; y += CELL)
        for (int32_t x = 0; x <= last; x += CELL) {
            const int is_back = y / CELL & 1, side = is_back ? RIGHT_SIDE : LEFT_SIDE;
            if (begin_cell(w, left + (is_back ? last - x : x), top + y, x ? side : TOP_SIDE, &whole))
                draw_cell(w, &whole);
        }
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
                       const glint_triangle *triangle, uint32_t lobes, const glint_part *part) {
    const int16_t *const normals[3] = NORMALS(triangle);
    lattice_walk w;
    if (triangle->area < CELL_AREA)
        return 0;
    w.gathering = (glint_gathering){frame, workspace, part, draw, glint_shade, &workspace->gathered->fragments};
    w.triangle = triangle;
    glint_gathering_begin(&w.gathering, triangle, normals, &w.attributes);
    w.largest = find_largest(part, &w.attributes, draw->extra != 0);
    if (!w.largest)
        return 0;
    w.cut = *part;
    w.lobes = lobes;
    w.has_cones = 0;
    const uint32_t lights = draw->shading->lights & ~triangle->away;
    for (uint32_t i = 0; lights >> i; i++)
        w.has_cones |= lights >> i & 1 && frame->view->lights[i].type->has_cone;
    draw_cells(&w);
    glint_count(workspace, GLINT_KERNEL_GENERAL, workspace->drawn ? glint_covered_by(part) : 0);
    return 1;
}

void glint_draw_edges(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                      const glint_triangle *triangle, const glint_part *part, const glint_terms *terms,
                      const glint_quadratic *polynomials, const glint_run *runs, const glint_run *end) {
    const int16_t *const normals[3] = NORMALS(triangle);
    const glint_gathering gathering = {frame, workspace, part, draw, glint_shade, &workspace->gathered->fragments};
    uint8_t columns[GLINT_TILE_MAX];
    int has_begun = 0;
    for (const glint_run *run = runs; run != end; run++) {
        const uint32_t found = glint_terms_find_edge(terms, polynomials, part, run, columns);
        if (found && !has_begun) {
            glint_gathering_begin(&gathering, triangle, normals, &workspace->gathered->attributes);
            gathering.fragments->away = ~(uint32_t)terms->shown;
        }
        has_begun |= found != 0;
        for (uint32_t i = 0; i < found; i++)
            glint_gather_lit(&gathering, columns[i], run->y);
    }
    if (has_begun)
        glint_gathering_store(&gathering);
}
