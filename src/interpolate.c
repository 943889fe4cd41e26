/* SPDX-License-Identifier: MIT */
/*
 * Quadratic interpolation of lighting (after Seiler, 1998): N.L and the deviation at a triangle's corners and at the
 * middles of its edges make quadratics over the screen. They are off by the cube of the turn of the normals, where
 * planes are off by its square.
 */
#include "division.h"
#include "quadratic.h"
#include "setup.h"

/* Slenderness of triangles, as bits, up to which sums over a row keep what a plane has (quadratic.c). */
#define SLENDER 7

/* Twice the least area, 28.4 squared: sides have at most 2 bits more, which keeps gradients' squares in 32. */
#define LEAST_AREA 8

/* Errors of N.L and of the highlight that interpolation may make at the worst place, levels in Q12. */
#define COSINE_LIMIT 1536
#define HIGHLIGHT_LIMIT 2560

/* Of an error budget, levels in Q12: what exact lighting errs, and from where on fast lighting shares it. */
#define KEPT 512
#define SHARED 2048

/* Turns are below this whatever it costs, Q15: the series below, and differences in 15 bits, are made for it. */
#define MOST_TURN 19661

/* The change of 1/w is below this, Q15. */
#define MOST_CHANGE 4096

/* Bulges of a deviation are below this. */
#define MOST_BULGE 8192

/* Binary logarithm of how much less than |a - b| turn an edge's ends are moved. */
#define SPREAD 6

/* sin^2 of the angle from the half vector, Q30, up to which corners are taken to face it: those behind it are beyond.
 */
#define FRONT 869730877

/* ---- Frame ---- */

static uint32_t largest_level(const uint32_t weight[3]) {
    uint32_t largest = weight[0] > weight[2] ? weight[0] : weight[2];
    largest *= 31;
    largest = largest > weight[1] * 63 ? largest : weight[1] * 63;
    return largest ? largest : 1;
}

/*
 * For normals that turn by d = |Na - Nb| along a triangle's longest turn, a normal is off by at most 0.0245 d^3.
 * @return d^2, Q15, at which this makes `limit` of a level, Q12, given what turning by 1 makes, levels in Q12
 */
static int32_t find_turn(uint64_t limit, uint64_t levels) {
    const uint64_t cube = (limit << 19) / ((levels * 803 >> 15) + 1); /* d^3, Q19: 0.0245 is 803 2^-15 */
    const uint64_t square = cube < 1 << 19 ? cube * cube << 7 : UINT64_MAX;
    uint64_t turn = 0;
    for (uint64_t bit = 1 << 14; bit; bit >>= 1)
        if ((turn | bit) * (turn | bit) * (turn | bit) <= square)
            turn |= bit;
    return turn < MOST_TURN ? (int32_t)turn : MOST_TURN;
}

/* N.L, Q14, at which all light together, with all of a highlight, comes to 1 in some channel. */
static int32_t find_full(const glint_shading *shading) {
    int32_t full = INT16_MAX;
    for (int c = 0; c < 3; c++) {
        const uint32_t diffuse = shading->weights[0].diffuse[c]; /* Q12 */
        const int64_t left =
            (1 << 12) - (int64_t)((shading->ambient[c] + 2047) >> 11) - shading->weights[0].specular[c];
        if (left < 0)
            return 0;
        if (diffuse && left * (1 << 14) < (int64_t)full * diffuse)
            full = (int32_t)(left * (1 << 14) / diffuse);
    }
    return full;
}

/*
 * What an error budget leaves for triangles that are lit exactly without one: all but what the highlight's edge takes,
 * a quarter of what is shared. Those that are interpolated anyway stay as they are.
 */
static uint64_t find_limit(const glint_shading *shading, uint32_t least_limit) {
    const uint32_t levels = shading->spare * 63, shared = levels > SHARED ? (levels - SHARED) / 4 : 0;
    return levels > least_limit + shared + KEPT ? levels - shared - KEPT : least_limit;
}

void glint_interpolate_prepare(glint_deviation *deviation, const glint_shading *shading) {
    glint_quadratic_limits *limits = &deviation->quadratic;
    const uint32_t diffuse = largest_level(shading->weights[0].diffuse);
    const uint32_t specular = largest_level(shading->weights[0].specular);
    const uint32_t root = glint_square_root((uint64_t)(uint32_t)shading->material->shininess); /* Q8 */
    const uint32_t scale = (uint32_t)deviation->scale >> 4;                                    /* Q12 */
    limits->full = find_full(shading);
    limits->turn = find_turn(find_limit(shading, COSINE_LIMIT), diffuse);
    /* a highlight's slope is at most 0.61 sqrt(p) weight */
    limits->turn_specular =
        find_turn(find_limit(shading, HIGHLIGHT_LIMIT), diffuse / 2 + ((uint64_t)specular * root * 156 >> 16));
    const uint64_t front = (uint64_t)FRONT * scale * scale >> 26;
    limits->front = front < UINT32_MAX ? (uint32_t)front : UINT32_MAX;
}

/* ---- Triangle ---- */

static int32_t least(int32_t a, int32_t b, int32_t c) {
    const int32_t m = a < b ? a : b;
    return m < c ? m : c;
}

static int32_t most(int32_t a, int32_t b, int32_t c) {
    const int32_t m = a > b ? a : b;
    return m > c ? m : c;
}

/* x 2^n modulo 2^32, rounded down; |n| below 32. */
static inline uint32_t scale(int32_t x, int32_t n) {
    return n >= 0 ? (uint32_t)x << n : (uint32_t)glint_shift_right(x, (unsigned)-n);
}

typedef glint_interpolation_edge edge;

/* The weights are 1/w, Q15, the largest a little below 1. 1 / (wa + wb) is (1 + u + u^2) / 2, u = 1 - (wa + wb) / 2. */
static inline void begin_edge(edge *e, const int16_t a[3], const int16_t b[3], int32_t wa, int32_t wb) {
    const int32_t u = (1 << 15) - ((wa + wb) >> 1);
    e->across = glint_shift_right((wa - wb) * ((1 << 15) + u + (u * u >> 15)), 17);
    e->turn = glint_shift_right(GLINT_UNIT * GLINT_UNIT - glint_dot(a, b), 14);
}

/* |M|^2 = 1 - r, and 1 / sqrt(1 - r) is 1 + r / 2 + 3 r^2 / 8 + 5 r^3 / 16. */
static inline void shorten_edge(edge *e) {
    const int32_t r = glint_shift_right((8192 - (e->across * e->across >> 15)) * e->turn, 15);
    const int32_t tail = glint_shift_right(r * (12288 + glint_shift_right(r * 10240, 15)), 15);
    e->shorter = glint_shift_right(r * (16384 + tail), 15);
}

/* Four times what a term at the middle of an edge is more than the mean of its corners. */
static inline int32_t find_bulge(const edge *e, int32_t a, int32_t b) {
    const int32_t skew = glint_shift_right(e->across * (a - b), 13);
    return skew + glint_shift_right((skew + 2 * (a + b)) * e->shorter, 15);
}

/* A triangle's edges: from corner 0 to 1, from 1 to 2, from 0 to 2. */
static int find_edges(const glint_triangle *triangle, edge e[3], int32_t *turn, int32_t *change) {
    const glint_vertex *const *v = triangle->corners;
    const int16_t *a = v[0]->attribute, *b = v[1]->attribute, *c = v[2]->attribute;
    uint32_t w0 = (uint32_t)v[0]->inverse_w, w1 = (uint32_t)v[1]->inverse_w, w2 = (uint32_t)v[2]->inverse_w;
    const unsigned zeros = glint_leading_zeros(w0 | w1 | w2 | 1);
    w0 = w0 << zeros >> 16, w1 = w1 << zeros >> 16, w2 = w2 << zeros >> 16;
    const int32_t largest = most((int32_t)w0, (int32_t)w1, (int32_t)w2);
    const uint32_t reciprocal = (uint32_t)glint_reciprocal16((uint32_t)largest) - 1;
    w0 = w0 * reciprocal >> 16, w1 = w1 * reciprocal >> 16, w2 = w2 * reciprocal >> 16;
    *change = (1 << 15) - least((int32_t)w0, (int32_t)w1, (int32_t)w2);
    if (*change > MOST_CHANGE)
        return 0;
    begin_edge(&e[0], a, b, (int32_t)w0, (int32_t)w1);
    begin_edge(&e[1], b, c, (int32_t)w1, (int32_t)w2);
    begin_edge(&e[2], a, c, (int32_t)w0, (int32_t)w2);
    *turn = most(e[0].turn, e[1].turn, e[2].turn);
    if (*turn > MOST_TURN)
        return 0;
    shorten_edge(&e[0]);
    shorten_edge(&e[1]);
    shorten_edge(&e[2]);
    return 1;
}

typedef glint_interpolation_gradients gradients;

/* A side of at most `size` bits, up to 10, times 1/area: 15 bits. */
static inline int32_t to_15_bits(int32_t side, int32_t reciprocal, int32_t size) {
    return glint_shift_right(side * reciprocal + (1 << size), (unsigned)size + 1);
}

static void begin_gradients(gradients *s, const glint_gradients *g) {
    s->g = g;
    if (!g->reciprocal) {
        s->x1 = glint_shift_right(g->x1, 15), s->y1 = glint_shift_right(g->y1, 15);
        s->x2 = glint_shift_right(g->x2, 15), s->y2 = glint_shift_right(g->y2, 15);
        s->shift = g->shift;
        return;
    }
    const int32_t size = 32 - (int32_t)glint_leading_zeros(g->reach + 1);
    s->x1 = to_15_bits(g->x1, g->reciprocal, size), s->y1 = to_15_bits(g->y1, g->reciprocal, size);
    s->x2 = to_15_bits(g->x2, g->reciprocal, size), s->y2 = to_15_bits(g->y2, g->reciprocal, size);
    s->shift = 11 + g->shift - size;
}

/* a b 2^-15 of 30 and 15 bits and signs, all of them used: slender triangles need it. */
static inline int32_t product(int32_t a, int32_t b) {
    return glint_shift_right(a, 15) * b + glint_shift_right((a & 0x7fff) * b, 15);
}

/* What slopes in x and y make from the first corner to the anchor's centre, half of it. */
static inline int32_t to_anchor(int32_t x, int32_t y, const glint_gradients *g) {
    return glint_shift_right(x, 5) * g->to_center_x + glint_shift_right(y, 5) * g->to_center_y;
}

/* A plane that is 0 at the first corner, d1 and d2 at the others, its value in the high half. */
static inline void begin_slope(glint_quadratic *q, const glint_gradients *g, int32_t d1, int32_t d2) {
    glint_plane plane; /* of a quarter: differences have 17 bits */
    glint_plane_begin(&plane, g, 0, d1 * (1 << 14), d2 * (1 << 14));
    q->start = (uint32_t)plane.start << 2;
    q->dx = (uint32_t)plane.dx << 2;
    q->dy = (uint32_t)plane.dy << 2;
}

/*
 * The quadratic of a term that is a at the corners, with the bulges b of edges; its value in the high half. With the
 * barycentric coordinates l1 and l2,
 * a0 + (a1 - a0 + b0) l1 + (a2 - a0 + b2) l2 - b0 l1^2 - b2 l2^2 + (b1 - b0 - b2) l1 l2.
 */
static void begin_term(glint_quadratic *q, const gradients *s, const int32_t a[3], const int32_t b[3]) {
    const glint_gradients *g = s->g;
    const int32_t twice = 32 - 2 * s->shift, both = b[1] - b[0] - b[2];
    const int32_t x1 = s->x1, y1 = s->y1, x2 = s->x2, y2 = s->y2;
    /* half the form's gradients along l1 and l2, each along x and y */
    const int32_t u_x = glint_shift_right(both * x2, 1) - b[0] * x1, v_x = glint_shift_right(both * x1, 1) - b[2] * x2;
    const int32_t u_y = glint_shift_right(both * y2, 1) - b[0] * y1, v_y = glint_shift_right(both * y1, 1) - b[2] * y2;
    const int32_t xx = product(u_x, x1) + product(v_x, x2), yy = product(u_y, y1) + product(v_y, y2);
    const int32_t xy = product(u_x, y1) + product(v_x, y2);
    const uint32_t half_xx = scale(xx, twice - 1), half_yy = scale(yy, twice - 1);
    begin_slope(q, g, a[1] - a[0] + b[0], a[2] - a[0] + b[2]);
    q->dxx = 2 * half_xx;
    q->dxy = scale(xy, twice);
    q->dyy = 2 * half_yy;
    /* the polynomial is the corner's, the anchor's centre lies beside it */
    const int32_t x = to_anchor(xx, xy, g), y = to_anchor(xy, yy, g);
    q->start += (uint32_t)a[0] * (1 << 16) + scale(to_anchor(x, y, g), twice + 1);
    q->dx += half_xx + scale(x, twice + 1);
    q->dy += half_yy + scale(y, twice + 1);
}

/* The deviation of the local viewer at the middle of an edge, scaled. @return 0 where it cannot be told */
static int find_middle(const glint_deviation *deviation, const edge *e, const glint_vertex *a, const glint_vertex *b,
                       int32_t middle[2]) {
    int16_t h[3];
    int32_t n[3];
    glint_view_vector view;
    if (!glint_deviation_half_vector(deviation, (a->x + b->x) >> 1, (a->y + b->y) >> 1, h, &view))
        return 0;
    for (int c = 0; c < 3; c++) {
        const int32_t mean = glint_shift_right(a->attribute[c] + b->attribute[c], 1) +
                             glint_shift_right(e->across * (a->attribute[c] - b->attribute[c]), 15);
        n[c] = mean + glint_shift_right(mean * e->shorter, 15);
    }
    const int32_t cosine = glint_shift_right(n[0] * h[0] + n[1] * h[1] + n[2] * h[2], 15);
    const int32_t along = glint_shift_right(
        (cosine + glint_shift_right(cosine, 13) + n[2]) * glint_inverse_of_one_and(h[2]), 16); /* Q14 */
    for (int c = 0; c < 2; c++) {
        const int32_t deviated = glint_shift_right(n[c] * (1 << 14) - h[c] * along + 0x2000, 14); /* Q15 */
        if (deviated > 2 * deviation->reach || deviated < -2 * deviation->reach)
            return 0;
        middle[c] = glint_shift_right(deviated * deviation->scale + (1 << 16), 17);
    }
    return 1;
}

/* Those of the deviation, where it is the local viewer's. @return 0 where they cannot be told, or are too large */
static int find_local_bulges(const glint_deviation *deviation, const edge *e, const glint_vertex *a,
                             const glint_vertex *b, const int16_t *terms_a, const int16_t *terms_b, int32_t *x,
                             int32_t *y) {
    int32_t middle[2];
    if (!find_middle(deviation, e, a, b, middle))
        return 0;
    *x = 4 * middle[0] - 2 * (terms_a[1] + terms_b[1]);
    *y = 4 * middle[1] - 2 * (terms_a[2] + terms_b[2]);
    return (uint32_t)(*x + MOST_BULGE) <= 2 * MOST_BULGE && (uint32_t)(*y + MOST_BULGE) <= 2 * MOST_BULGE;
}

/* How far a term at corner a is moved away from that at b. */
static inline int32_t find_spread(const edge *e, int32_t a, int32_t b) {
    return glint_shift_right((a - b) * e->turn, 15 + SPREAD);
}

/*
 * Between its three nodes an edge's error is a cubic, x - x^3 for x from -1 to 1. Moving both ends outwards by a
 * quarter of that one's factor, which is |a - b| turn / 64, makes the largest error least.
 */
static inline void spread(const edge e[3], int32_t a[3], int32_t b[3]) {
    const int32_t s0 = find_spread(&e[0], a[0], a[1]), s1 = find_spread(&e[1], a[1], a[2]),
                  s2 = find_spread(&e[2], a[0], a[2]);
    a[0] += s0 + s2;
    a[1] += s1 - s0;
    a[2] -= s1 + s2;
    b[0] -= 2 * (s1 + s2);
    b[1] += 2 * (s0 + s2);
    b[2] -= 2 * (s0 - s1);
}

int glint_interpolate_highlight(const glint_draw *draw, const glint_triangle *triangle, glint_interpolation *to) {
    const glint_deviation *deviation = draw->shading->deviation;
    const glint_vertex *const *v = triangle->corners;
    const int16_t *const *terms = to->terms;
    const edge *e = to->edges;
    int32_t x[3] = {terms[0][1], terms[1][1], terms[2][1]}, y[3] = {terms[0][2], terms[1][2], terms[2][2]};
    int32_t bx[3], by[3];
    if (deviation->local_viewer) {
        if (!find_local_bulges(deviation, &e[0], v[0], v[1], terms[0], terms[1], &bx[0], &by[0]) ||
            !find_local_bulges(deviation, &e[1], v[1], v[2], terms[1], terms[2], &bx[1], &by[1]) ||
            !find_local_bulges(deviation, &e[2], v[0], v[2], terms[0], terms[2], &bx[2], &by[2]))
            return 0;
    } else {
        bx[0] = find_bulge(&e[0], x[0], x[1]);
        bx[1] = find_bulge(&e[1], x[1], x[2]);
        bx[2] = find_bulge(&e[2], x[0], x[2]);
        by[0] = find_bulge(&e[0], y[0], y[1]);
        by[1] = find_bulge(&e[1], y[1], y[2]);
        by[2] = find_bulge(&e[2], y[0], y[2]);
    }
    spread(e, x, bx);
    spread(e, y, by);
    begin_term(&to->x, &to->gradients, x, bx);
    begin_term(&to->y, &to->gradients, y, by);
    return 1;
}

/* Are all corners beyond the same side of the highlight's octagon, moved outwards by a margin? */
static int is_outside(const glint_deviation *deviation, const int16_t *const terms[3], int32_t margin) {
    const int32_t cut = deviation->side + margin, diagonal = deviation->side_diagonal + margin + (margin >> 1);
    const int32_t x0 = terms[0][1], x1 = terms[1][1], x2 = terms[2][1];
    const int32_t y0 = terms[0][2], y1 = terms[1][2], y2 = terms[2][2];
    return least(x0, x1, x2) >= cut || most(x0, x1, x2) <= -cut || least(y0, y1, y2) >= cut ||
           most(y0, y1, y2) <= -cut || least(x0 + y0, x1 + y1, x2 + y2) >= diagonal ||
           most(x0 + y0, x1 + y1, x2 + y2) <= -diagonal || least(x0 - y0, x1 - y1, x2 - y2) >= diagonal ||
           most(x0 - y0, x1 - y1, x2 - y2) <= -diagonal;
}

/* The larger side of what is around a triangle, over the focal length, Q14. */
static int32_t find_extent(const glint_deviation *deviation, const glint_vertex *const v[3]) {
    const int32_t width = most(v[0]->x, v[1]->x, v[2]->x) - least(v[0]->x, v[1]->x, v[2]->x);
    const int32_t height = most(v[0]->y, v[1]->y, v[2]->y) - least(v[0]->y, v[1]->y, v[2]->y);
    const int32_t extent = width > height ? width : height;
    return extent > deviation->ray_limit ? 1 << 14 : glint_shift_right(extent * deviation->ray_scale, 16);
}

/* Do all corners face the half vector? */
static int is_front(const int16_t *const terms[3], uint32_t limit) {
    for (int i = 0; i < 3; i++)
        if ((uint32_t)(terms[i][1] * terms[i][1] + terms[i][2] * terms[i][2]) > limit)
            return 0;
    return 1;
}

/* No less than a term anywhere in its triangle: the largest of its control points (Bezier triangles, Farin, 1986). */
static int32_t find_most(const int32_t a[3], const int32_t b[3]) {
    const int32_t corners = most(a[0], a[1], a[2]);
    const int32_t middles = most(a[0] + a[1] + b[0], a[1] + a[2] + b[1], a[0] + a[2] + b[2]);
    return 2 * corners > middles ? corners : (middles + 1) >> 1;
}

glint_quadratic_kind glint_interpolate_begin(const glint_draw *draw, const glint_triangle *triangle,
                                             const glint_part *part, glint_interpolation *to) {
    const glint_deviation *deviation = draw->shading->deviation;
    const glint_quadratic_limits *limits = &deviation->quadratic;
    const glint_vertex *const *v = triangle->corners;
    const uint32_t all = v[0]->flags & v[1]->flags & v[2]->flags, any = v[0]->flags | v[1]->flags | v[2]->flags;
    const int32_t slender = glint_slenderness(&part->gradients, triangle->area);
    int32_t turn, change, shows = 0;
    if (!(all & GLINT_VERTEX_LIT) || any & GLINT_TERMS_UNFIT || triangle->back || slender > SLENDER ||
        triangle->area < LEAST_AREA || !find_edges(triangle, to->edges, &turn, &change))
        return GLINT_QUADRATIC_UNFIT;
    for (int i = 0; i < 3; i++)
        to->terms[i] = draw->terms[v[i] - draw->vertices];
    const int32_t extent = deviation->local_viewer ? find_extent(deviation, v) : 0;
    const int32_t skewed = turn + (change * change >> 14);
    if (deviation->specular_end) {
        /* between corners, by the turn of normals and of half vectors, and by 1/w; Q14 */
        const int32_t margin = (turn * 5 >> 5) + (extent * 9 >> 4) + (change * 7 >> 5);
        shows = !(all & GLINT_TERMS_ANY_OUTSIDE) ||
                !is_outside(deviation, to->terms,
                            (int32_t)glint_shift_right64((int64_t)margin * (deviation->scale >> 4), 12));
    }
    if (shows && (any & (GLINT_TERMS_DIM | GLINT_TERMS_FAR) ||
                  skewed + (extent >> 1) + (extent * extent >> 13) > limits->turn_specular ||
                  !is_front(to->terms, limits->front)))
        return GLINT_QUADRATIC_UNFIT;
    if (skewed > limits->turn)
        return GLINT_QUADRATIC_UNFIT;
    const int32_t a[3] = {to->terms[0][0], to->terms[1][0], to->terms[2][0]};
    const int32_t b[3] = {find_bulge(&to->edges[0], a[0], a[1]), find_bulge(&to->edges[1], a[1], a[2]),
                          find_bulge(&to->edges[2], a[0], a[2])};
    to->gated = (any & GLINT_TERMS_DIM) != 0;
    begin_gradients(&to->gradients, &part->gradients);
    begin_term(&to->cosine, &to->gradients, a, b);
    if (!shows)
        return GLINT_QUADRATIC_DIFFUSE;
    to->clamped = find_most(a, b) > limits->full;
    return glint_interpolate_highlight(draw, triangle, to) ? GLINT_QUADRATIC_SPECULAR : GLINT_QUADRATIC_UNFIT;
}
