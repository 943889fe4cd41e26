/* SPDX-License-Identifier: MIT */
/*
 * Pieces: a triangle cut in four by the middles of its edges, each piece drawn by polynomials through six nodes, those
 * on its edges shared with its neighbours.
 */
#include "../light/evaluation.h"
#include "../raster/found.h"
#include "shapes.h"

/* Twice the area, 28.4 squared, times two more than the lights, below which pieces take more than fragments: measured,
 * of 400 pixels. */
#define PIECES_AREA (400 * 512)

/* Nodes lie at quarters of the second and the third corner's barycentric coordinates. */
#define PLACES 5

/* ---- Nodes ---- */

/* A triangle on its way. */
typedef struct pieces {
    const glint_frame *frame;
    const glint_draw *draw;
    const glint_triangle *triangle;
    int32_t w[3];      /* 1/w of the corners, the largest with 15 bits */
    uint32_t is_there; /* bit i: node i is lit */
    glint_node nodes[PLACES * (PLACES + 1) / 2];
} pieces;

/* The number of the node at j and k quarters. */
static inline uint32_t number_of(int32_t j, int32_t k) {
    return (uint32_t)(j + k * (2 * PLACES + 1 - k) / 2);
}

/* Weights of the corners there, in quarters. */
static inline void weigh(int32_t j, int32_t k, int32_t weight[3]) {
    weight[0] = PLACES - 1 - j - k;
    weight[1] = j;
    weight[2] = k;
}

static int32_t mean_of(const int32_t weight[3], int32_t a, int32_t b, int32_t c) {
    return weight[0] * a + weight[1] * b + weight[2] * c;
}

/* Gathers a node as a fragment: normals are linear over w, and so are the surface's colours, Q14. */
static void gather_piece(const pieces *p, int32_t j, int32_t k, glint_fragments *to) {
    const glint_vertex *const *v = p->triangle->corners;
    const int32_t *const w = p->w;
    const uint32_t i = to->count++;
    int32_t weight[3], normal[3], over = 0;
    weigh(j, k, weight);
    to->ray[i][0] = p->frame->config.width * 4096 - mean_of(weight, v[0]->x, v[1]->x, v[2]->x) * 128;
    to->ray[i][1] = mean_of(weight, v[0]->y, v[1]->y, v[2]->y) * 128 - p->frame->config.height * 4096;
    to->ray[i][2] = p->frame->view->focal;
    to->inverse_w[i] = mean_of(weight, v[0]->inverse_w >> 2, v[1]->inverse_w >> 2, v[2]->inverse_w >> 2);
    for (int c = 0; c < 3; c++) {
        normal[c] = 0;
        for (int n = 0; n < 3; n++)
            normal[c] += weight[n] * glint_shift_right(v[n]->attribute[c] * w[n], 2);
    }
    glint_unit_each(normal[0], normal[1], normal[2], to->normal[i]);
    if (!p->draw->extra)
        return;
    for (int n = 0; n < 3; n++)
        over += weight[n] * w[n];
    for (int c = 0; c < 3; c++) {
        int32_t colour = 0;
        for (int n = 0; n < 3; n++)
            colour += weight[n] * ((p->triangle->extra[n][c] + 1) * w[n] >> 3);
        to->surface[i][c] = (int16_t)(colour / (over >> 2));
    }
}

/* Nodes of a piece: its corners, and the middles of its edges, as steps from its first corner. */
static const uint8_t steps[6][2] = {{0, 0}, {2, 0}, {0, 2}, {1, 0}, {1, 1}, {0, 1}};

/* Lights those nodes of a piece that are not. */
static void light_piece(pieces *p, const glint_shape *shape, glint_node *nodes[6]) {
    glint_fragments at;
    glint_node *to[6];
    at.count = 0;
    for (int i = 0; i < 6; i++) {
        const int32_t from = shape->turned < 0 ? 2 : 0;
        const int32_t j = from + 2 * (from ? 0 : shape->first[0]) + shape->turned * steps[i][0],
                      k = from + 2 * (from ? 0 : shape->first[1]) + shape->turned * steps[i][1];
        const uint32_t number = number_of(j, k);
        nodes[i] = &p->nodes[number];
        if (p->is_there >> number & 1)
            continue;
        p->is_there |= 1u << number;
        to[at.count] = nodes[i];
        gather_piece(p, j, k, &at);
    }
    glint_nodes_light(p->frame, p->draw->shading, &at, p->draw->shading->lights & ~p->triangle->away, shape->lobes, 1,
                      to);
    for (uint32_t i = 0; i < at.count; i++) {
        glint_node_leave(to[i], p->triangle->away);
        to[i]->inverse_w = at.inverse_w[i];
        for (int c = 0; c < 3; c++) {
            to[i]->normal[c] = at.normal[i][c];
            to[i]->surface[c] = p->draw->extra ? at.surface[i][c] : 0;
        }
    }
}

/* ---- Polynomials ---- */

/* What a piece's second differences, and its steps, may be: those of the whole triangle's form have their bits then. */
#define PIECE_BULGE (1 << 12)
#define MOST_STEP (3 << 15) /* of both together */

static inline int is_beyond_piece(int32_t x, int32_t most) {
    return x >= most || x <= -most;
}

/*
 * With a piece's own coordinates m1 = s (2 l1 - c1) and m2 = s (2 l2 - c2), s and c its `turned` and `first`, what is
 * a + d1 m1 + d2 m2 - b1 m1^2 - b2 m2^2 + both m1 m2 is a form of l1 and l2.
 */
static int fit_piece(const glint_shape *shape, const int32_t n[], int unit, glint_quadratic *to) {
    const int32_t s = shape->turned, c1 = shape->first[0], c2 = shape->first[1];
    const int32_t b1 = 4 * n[3] - 2 * (n[0] + n[1]), across = 4 * n[4] - 2 * (n[1] + n[2]),
                  b2 = 4 * n[5] - 2 * (n[0] + n[2]), both = across - b1 - b2;
    const int32_t d1 = s * (n[1] - n[0] + b1), d2 = s * (n[2] - n[0] + b2);
    const glint_form f = {n[0] - d1 * c1 - d2 * c2 - b1 * c1 - b2 * c2 + both * c1 * c2,
                          2 * (d1 + 2 * b1 * c1 - both * c2),
                          2 * (d2 + 2 * b2 * c2 - both * c1),
                          4 * b1,
                          4 * b2,
                          4 * both};
    if (is_beyond_piece(b1, PIECE_BULGE) || is_beyond_piece(b2, PIECE_BULGE) ||
        is_beyond_piece(both, 2 * PIECE_BULGE) || is_beyond_piece(f.d1 + f.d2, MOST_STEP) ||
        is_beyond_piece(f.d1 - f.d2, MOST_STEP))
        return 0;
    if (shape->barycentric->unit != (uint32_t)unit)
        glint_barycentric_begin(shape->barycentric, &shape->part->gradients, unit);
    glint_form_begin(to, shape->barycentric, &f);
    return 1;
}

/* ---- Spans ---- */

/* Cuts a part's spans: a corner's piece has its pixels whose coordinate is 1/2 or more, the last what is left. */
static void cut_spans(const glint_part *part, glint_span spans[4][GLINT_TILE_MAX]) {
    const int32_t one = 1 << 28;
    for (uint32_t y = part->top; y < part->bottom; y++)
        spans[3][y] = part->spans[y];
    for (int i = 0; i < 3; i++) {
        glint_plane plane;
        int32_t before = 0;
        glint_plane_begin(&plane, &part->gradients, i == 0 ? one : 0, i == 1 ? one : 0, i == 2 ? one : 0);
        for (uint32_t y = part->top; y < part->bottom; y++) {
            glint_span *const rest = &spans[3][y];
            const int32_t row = part->y + (int32_t)y;
            spans[i][y] = *rest;
            if (rest->left >= rest->right) /* nowhere near the triangle, perhaps, where its plane may wrap */
                continue;
            /* the first column beyond the piece, or in it, near where it was a row above */
            int32_t column = glint_least(glint_most(before, rest->left), rest->right);
            int32_t here = glint_plane_at(&plane, part->x + column, row) - one / 2;
            while (column > rest->left && (here - plane.dx < 0) == (plane.dx < 0))
                column--, here -= plane.dx;
            while (column < rest->right && (here < 0) != (plane.dx < 0))
                column++, here += plane.dx;
            before = column;
            spans[i][y] =
                plane.dx < 0 ? (glint_span){rest->left, (uint8_t)column} : (glint_span){(uint8_t)column, rest->right};
            *rest =
                plane.dx < 0 ? (glint_span){(uint8_t)column, rest->right} : (glint_span){rest->left, (uint8_t)column};
        }
    }
}

/* ---- Triangles ---- */

/* What polynomials piece i has, found here unless another tile did. @param own room for it */
static const glint_found_terms *find_piece(pieces *p, glint_workspace *workspace, const glint_shape *shape, uint32_t i,
                                           const glint_part *part, glint_found_terms *own) {
    glint_node *nodes[6];
    const glint_found_terms *const before = glint_found_find(workspace, p->triangle, part, 1 + i);
    if (before)
        return before;
    light_piece(p, shape, nodes);
    glint_found_terms *const kept = glint_found_begin(workspace, p->triangle, part, sizeof *kept);
    glint_found_terms *const found = kept ? kept : own;
    found->fits = (uint32_t)glint_shape_begin(p->frame, p->draw, shape, nodes, &found->terms, &found->polynomials);
    if (kept)
        glint_found_keep(workspace, p->triangle, 1 + i, glint_found_terms_size(kept));
    return found;
}

/* Draws the piece that a part holds. */
static void draw_piece(pieces *p, glint_workspace *workspace, const glint_shape *shape, uint32_t i,
                       const glint_part *part) {
    glint_found_terms own;
    const glint_found_terms *const found = find_piece(p, workspace, shape, i, part, &own);
    if (!found->fits) {
        glint_draw_any(p->frame, workspace, p->draw, p->triangle, part);
        return;
    }
    glint_terms_draw_part(p->frame, workspace, p->draw, p->triangle, part, &found->terms, &found->polynomials);
    glint_count(workspace, GLINT_KERNEL_CHANNELS, workspace->drawn ? glint_covered_by(part) : 0);
}

static void begin_pieces(pieces *p, glint_shape *shape) {
    const glint_vertex *const *v = p->triangle->corners;
    const unsigned up = glint_find_room(v);
    for (int i = 0; i < 3; i++)
        p->w[i] = (int32_t)((uint32_t)v[i]->inverse_w << up >> 16);
    p->is_there = 0;
    shape->longest = glint_find_longest(v) / 2 + 1;
}

int glint_draw_pieces(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                      const glint_triangle *triangle, uint32_t lobes, const glint_part *part) {
    static const int32_t kinds[4][3] = {{1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {-1, 1, 1}};
    pieces p; /* no node is lit yet */
    glint_barycentric barycentric = {.unit = 0};
    glint_shape shape = {.count = 6,
                         .corners = {0, 1, 2, 2},
                         .lobes = lobes & ~triangle->away,
                         .fit = fit_piece,
                         .part = part,
                         .barycentric = &barycentric};
    glint_span spans[4][GLINT_TILE_MAX];
    glint_part cut = *part;
    if (triangle->area * (int32_t)(draw->shading->terms->shown + 2) < PIECES_AREA ||
        glint_slenderness(&part->gradients, triangle->area) > GLINT_SLENDER)
        return 0;
    p.frame = frame;
    p.draw = draw;
    p.triangle = triangle;
    begin_pieces(&p, &shape);
    cut_spans(part, spans);
    for (int i = 0; i < 4; i++) {
        for (uint32_t y = part->top; y < part->bottom; y++)
            cut.spans[y] = spans[i][y];
        if (!glint_covered_by(&cut))
            continue;
        shape.turned = kinds[i][0];
        shape.first[0] = kinds[i][1];
        shape.first[1] = kinds[i][2];
        draw_piece(&p, workspace, &shape, (uint32_t)i, &cut);
    }
    return 1;
}
