/* SPDX-License-Identifier: MIT */
/*
 * Quadratic interpolation of lighting (after Seiler, 1998): N.L and the deviation at a triangle's corners and at the
 * middles of its edges make quadratics over the screen. They are off by the cube of the turn of the normals, where
 * planes are off by its square.
 */
#include "../math/division.h"
#include "../raster/found.h"
#include "../raster/setup.h"
#include "fast_exact.h"

/* The change of 1/w is below this, Q15. */
#define MOST_CHANGE 4096

/* Leading zeros that the largest 1/w has at most: planes of less may fall below 0, by a step for each pixel. */
#define DEEP_ZEROS 14

/* Bulges of a deviation are below this. */
#define MOST_BULGE 8192

/* Binary logarithm of how much less than |a - b| turn an edge's ends are moved. */
#define SPREAD 6

/* More than a quadratic errs by set-up's rounding: 2^-12 of a deviation's range. */
#define MARGIN 16

typedef glint_interpolation_edge interpolated_edge;

/* The weights are 1/w, Q15, the largest a little below 1. 1 / (wa + wb) is (1 + u + u^2) / 2, u = 1 - (wa + wb) / 2. */
static inline void begin_edge(interpolated_edge *e, const int16_t a[3], const int16_t b[3], int32_t wa, int32_t wb) {
    const int32_t u = (1 << 15) - ((wa + wb) >> 1);
    e->across = glint_shift_right((wa - wb) * ((1 << 15) + u + (u * u >> 15)), 17);
    e->turn = glint_shift_right(GLINT_UNIT * GLINT_UNIT - glint_dot(a, b), 14);
}

/* |M|^2 = 1 - r, and 1 / sqrt(1 - r) is 1 + r / 2 + 3 r^2 / 8 + 5 r^3 / 16. */
static inline void shorten_edge(interpolated_edge *e) {
    const int32_t r = glint_shift_right((8192 - (e->across * e->across >> 15)) * e->turn, 15);
    const int32_t tail = glint_shift_right(r * (12288 + glint_shift_right(r * 10240, 15)), 15);
    e->shorter = glint_shift_right(r * (16384 + tail), 15);
}

/* Four times what a term at the middle of an edge is more than the mean of its corners. */
static inline int32_t find_bulge(const interpolated_edge *e, int32_t a, int32_t b) {
    const int32_t skew = glint_shift_right(e->across * (a - b), 13);
    return skew + glint_shift_right((skew + 2 * (a + b)) * e->shorter, 15);
}

static inline void find_bulges(const interpolated_edge e[3], const int32_t a[3], int32_t b[3]) {
    b[0] = find_bulge(&e[0], a[0], a[1]);
    b[1] = find_bulge(&e[1], a[1], a[2]);
    b[2] = find_bulge(&e[2], a[0], a[2]);
}

/* A triangle's edges: from corner 0 to 1, from 1 to 2, from 0 to 2. */
static int find_edges(const glint_triangle *triangle, interpolated_edge e[3], int32_t *turn, int32_t *change) {
    const glint_vertex *const *v = triangle->corners;
    const int16_t *a = v[0]->attribute, *b = v[1]->attribute, *c = v[2]->attribute;
    uint32_t w0 = (uint32_t)v[0]->inverse_w, w1 = (uint32_t)v[1]->inverse_w, w2 = (uint32_t)v[2]->inverse_w;
    const unsigned zeros = glint_leading_zeros(w0 | w1 | w2);
    if (zeros > DEEP_ZEROS)
        return 0;
    w0 = w0 << zeros >> 16, w1 = w1 << zeros >> 16, w2 = w2 << zeros >> 16;
    const int32_t largest = glint_most_of((int32_t)w0, (int32_t)w1, (int32_t)w2);
    const uint32_t reciprocal = (uint32_t)glint_reciprocal16((uint32_t)largest) - 1;
    w0 = w0 * reciprocal >> 16, w1 = w1 * reciprocal >> 16, w2 = w2 * reciprocal >> 16;
    *change = (1 << 15) - glint_least_of((int32_t)w0, (int32_t)w1, (int32_t)w2);
    if (*change > MOST_CHANGE)
        return 0;
    begin_edge(&e[0], a, b, (int32_t)w0, (int32_t)w1);
    begin_edge(&e[1], b, c, (int32_t)w1, (int32_t)w2);
    begin_edge(&e[2], a, c, (int32_t)w0, (int32_t)w2);
    *turn = glint_most_of(e[0].turn, e[1].turn, e[2].turn);
    if (*turn > GLINT_INTERPOLATE_TURN)
        return 0;
    shorten_edge(&e[0]);
    shorten_edge(&e[1]);
    shorten_edge(&e[2]);
    return 1;
}

/* How far a term at corner a is moved away from that at b. */
static inline int32_t find_spread(const interpolated_edge *e, int32_t a, int32_t b) {
    return glint_shift_right((a - b) * e->turn, 15 + SPREAD);
}

/*
 * Between its three nodes an edge's error is a cubic, x - x^3 for x from -1 to 1. Moving both ends outwards by a
 * quarter of that one's factor, which is |a - b| turn / 64, makes the largest error least.
 */
static inline void spread(const interpolated_edge e[3], int32_t a[3], int32_t b[3]) {
    const int32_t s0 = find_spread(&e[0], a[0], a[1]), s1 = find_spread(&e[1], a[1], a[2]),
                  s2 = find_spread(&e[2], a[0], a[2]);
    a[0] += s0 + s2;
    a[1] += s1 - s0;
    a[2] -= s1 + s2;
    b[0] -= 2 * (s1 + s2);
    b[1] += 2 * (s0 + s2);
    b[2] -= 2 * (s0 - s1);
}

/* A deviation at the corners, with the bulges of the edges. */
typedef struct bulged_deviation {
    int32_t x[3], y[3], bulge_x[3], bulge_y[3];
} bulged_deviation;

/* A component of the normal at the middle of an edge. */
static inline int32_t find_normal(const interpolated_edge *e, int32_t a, int32_t b) {
    const int32_t mean = glint_shift_right(a + b, 1) + glint_shift_right(e->across * (a - b), 15);
    return mean + glint_shift_right(mean * e->shorter, 15);
}

/* Four times a deviation, Q15 and rounded down, on the scale of planes, less the sum of its edge's ends, twice. */
static inline int32_t find_local_bulge(const glint_fast_terms *fast, int32_t middle, int32_t ends) {
    return glint_shift_right(middle * fast->scale + fast->scaled_half, 15) - 2 * ends;
}

static inline int is_bulge(int32_t bulge) {
    return (uint32_t)(bulge + MOST_BULGE) <= 2 * MOST_BULGE;
}

/* The bulges of edge i by the local viewer's half vector. @return 0 where they cannot be told, or are too large */
static inline int find_local_bulges(const glint_fast_terms *fast, const glint_triangle *triangle,
                                    const interpolated_edge *e, int i, bulged_deviation *n) {
    const int from = i == 1, to = i ? 2 : 1;
    const glint_vertex *const a = triangle->corners[from], *const b = triangle->corners[to];
    int16_t h[3];
    glint_view_vector view;
    if (!glint_half_vector_inline(fast, a->x + b->x, a->y + b->y, h, &view))
        return 0;
    const int32_t nx = find_normal(e, a->attribute[0], b->attribute[0]);
    const int32_t ny = find_normal(e, a->attribute[1], b->attribute[1]);
    const int32_t nz = find_normal(e, a->attribute[2], b->attribute[2]);
    const int32_t cosine = glint_shift_right(nx * h[0] + ny * h[1] + nz * h[2], 15);
    const int32_t along = glint_shift_right((cosine + nz) * glint_inverse_of_one_and(h[2]), 16); /* Q14 */
    const int32_t x = glint_shift_right(nx * (1 << 14) - h[0] * along, 14);
    const int32_t y = glint_shift_right(ny * (1 << 14) - h[1] * along, 14), most = 2 * fast->reach;
    if (x > most || x < -most || y > most || y < -most)
        return 0;
    const int32_t bulge_x = find_local_bulge(fast, x, n->x[from] + n->x[to]);
    const int32_t bulge_y = find_local_bulge(fast, y, n->y[from] + n->y[to]);
    n->bulge_x[i] = bulge_x;
    n->bulge_y[i] = bulge_y;
    return is_bulge(bulge_x) && is_bulge(bulge_y);
}

/* All else of the nodes. @return 0 where they do not fit */
static int find_edge_middles(const glint_fast_terms *fast, const glint_triangle *triangle, const interpolated_edge *e,
                             bulged_deviation *n) {
    if (fast->local_viewer) {
        for (int i = 0; i < 3; i++)
            if (!find_local_bulges(fast, triangle, &e[i], i, n))
                return 0;
    } else {
        find_bulges(e, n->x, n->bulge_x);
        find_bulges(e, n->y, n->bulge_y);
    }
    spread(e, n->x, n->bulge_x);
    spread(e, n->y, n->bulge_y);
    return 1;
}

static void begin_highlight(glint_interpolation *to, const bulged_deviation *n) {
    glint_polynomial_begin(&to->x, &to->gradients, n->x, n->bulge_x);
    glint_polynomial_begin(&to->y, &to->gradients, n->y, n->bulge_y);
}

int glint_interpolate_highlight(const glint_draw *draw, const glint_triangle *triangle, glint_interpolation *to) {
    bulged_deviation n;
    for (int i = 0; i < 3; i++) {
        const int16_t *terms = glint_fast_terms_of(draw, triangle->corners[i]);
        n.x[i] = terms[1], n.y[i] = terms[2];
    }
    if (!find_edge_middles(draw->shading->fast, triangle, to->edges, &n))
        return 0;
    begin_highlight(to, &n);
    return 1;
}

/* Are all corners beyond the same side of the highlight's octagon, moved outwards by a margin? They are beyond `sides`
 * of it as it is. */
static int is_outside_octagon(const glint_fast_terms *fast, uint32_t sides, const bulged_deviation *n, int32_t margin) {
    const int32_t cut = fast->side + margin, diagonal = fast->side_diagonal + margin + (margin >> 1);
    const int32_t x0 = n->x[0], x1 = n->x[1], x2 = n->x[2], y0 = n->y[0], y1 = n->y[1], y2 = n->y[2];
    return (sides & GLINT_VERTEX_OUTSIDE << 7 && glint_least_of(x0, x1, x2) >= cut) ||
           (sides & GLINT_VERTEX_OUTSIDE << 6 && glint_most_of(x0, x1, x2) <= -cut) ||
           (sides & GLINT_VERTEX_OUTSIDE << 5 && glint_least_of(x0 + y0, x1 + y1, x2 + y2) >= diagonal) ||
           (sides & GLINT_VERTEX_OUTSIDE << 4 && glint_most_of(x0 + y0, x1 + y1, x2 + y2) <= -diagonal) ||
           (sides & GLINT_VERTEX_OUTSIDE << 3 && glint_least_of(y0, y1, y2) >= cut) ||
           (sides & GLINT_VERTEX_OUTSIDE << 2 && glint_most_of(y0, y1, y2) <= -cut) ||
           (sides & GLINT_VERTEX_OUTSIDE << 1 && glint_least_of(x0 - y0, x1 - y1, x2 - y2) >= diagonal) ||
           (sides & GLINT_VERTEX_OUTSIDE && glint_most_of(x0 - y0, x1 - y1, x2 - y2) <= -diagonal);
}

/* The larger side of what is around a triangle, over the focal length, Q14. */
static int32_t find_extent(const glint_fast_terms *fast, const glint_vertex *const v[3]) {
    const int32_t width = glint_most_of(v[0]->x, v[1]->x, v[2]->x) - glint_least_of(v[0]->x, v[1]->x, v[2]->x);
    const int32_t height = glint_most_of(v[0]->y, v[1]->y, v[2]->y) - glint_least_of(v[0]->y, v[1]->y, v[2]->y);
    const int32_t extent = width > height ? width : height;
    return extent > fast->ray_limit ? 1 << 14 : glint_shift_right(extent * fast->ray_scale, 16);
}

/* A deviation, Q14, as planes hold it. */
static inline int32_t scale_margin(const glint_fast_terms *fast, int32_t margin) {
    return (int32_t)glint_shift_right64(glint_product(margin, fast->scale >> 4), 12);
}

static inline int32_t square_of(int32_t x, int32_t y) {
    return x * x + y * y;
}

/* Do a triangle's control points lie beyond a line across the direction (x, y), a radius away? */
static int is_beyond_line(const bulged_deviation *n, int32_t x, int32_t y, uint32_t radius) {
    const int32_t a = x * n->x[0] + y * n->y[0], b = x * n->x[1] + y * n->y[1], c = x * n->x[2] + y * n->y[2];
    const int32_t middles =
        glint_least_of(a + b + x * n->bulge_x[0] + y * n->bulge_y[0], b + c + x * n->bulge_x[1] + y * n->bulge_y[1],
                       a + c + x * n->bulge_x[2] + y * n->bulge_y[2]);
    const int32_t corners = 2 * glint_least_of(a, b, c);
    const int32_t nearest = glint_shift_right(corners < middles ? corners : middles, 7);
    return nearest > 0 && (uint32_t)(nearest * nearest) > ((radius * radius >> 12) + 1) * (uint32_t)(x * x + y * y);
}

/*
 * Is all between these nodes outside the highlight? A triangle's quadratic lies between its control points (Bezier
 * triangles, Farin, 1986): here all of these must lie beyond a line across the direction of the corners' sum, or of the
 * nearest corner.
 */
static int is_beyond(const glint_fast_terms *fast, const bulged_deviation *n, int32_t margin) {
    const int32_t *x = n->x, *y = n->y;
    const uint32_t radius = (uint32_t)(fast->side + margin);
    if (is_beyond_line(n, glint_shift_right(x[0] + x[1] + x[2], 10), glint_shift_right(y[0] + y[1] + y[2], 10), radius))
        return 1;
    const int32_t s0 = square_of(x[0], y[0]), s1 = square_of(x[1], y[1]), s2 = square_of(x[2], y[2]);
    const int i = s0 <= s1 && s0 <= s2 ? 0 : s1 <= s2 ? 1 : 2;
    return is_beyond_line(n, glint_shift_right(x[i], 8), glint_shift_right(y[i], 8), radius);
}

/* No less than a term anywhere in its triangle: the largest of its control points (Bezier triangles, Farin, 1986). */
static int32_t find_most(const int32_t a[3], const int32_t b[3]) {
    const int32_t corners = glint_most_of(a[0], a[1], a[2]);
    const int32_t middles = glint_most_of(a[0] + a[1] + b[0], a[1] + a[2] + b[1], a[0] + a[2] + b[2]);
    return 2 * corners > middles ? corners : (middles + 1) >> 1;
}

/*
 * Does a highlight show, as far as corners tell? Sets whether one of them lies in it; and where it would err too much,
 * or may pass the horizon, by how much it may reach further than it is drawn: there it must not show.
 * @return GLINT_EXACT_UNFIT where it cannot be interpolated
 */
static inline glint_exact_kind find_kind(const glint_fast_terms *fast, const glint_triangle *triangle,
                                         const bulged_deviation *n, int32_t turn, int32_t change, int *inside,
                                         int32_t *error) {
    const glint_vertex *const *v = triangle->corners;
    const glint_exact_limits *limits = &fast->exact;
    const uint32_t all = v[0]->flags & v[1]->flags & v[2]->flags, any = v[0]->flags | v[1]->flags | v[2]->flags;
    const int32_t extent = fast->local_viewer ? find_extent(fast, v) : 0;
    const int32_t bend =
        extent > GLINT_NEAR_EXTENT ? extent : extent * limits->bend >> 15; /* of the half vector, Q14 */
    const int32_t s0 = square_of(n->x[0], n->y[0]), s1 = square_of(n->x[1], n->y[1]), s2 = square_of(n->x[2], n->y[2]);
    const int is_front = (uint32_t)glint_most_of(s0, s1, s2) <= limits->front;
    *inside = (uint32_t)glint_least_of(s0, s1, s2) < fast->specular_end;
    if (!*inside && all & GLINT_VERTEX_ANY_OUTSIDE) {
        /*
         * Between corners, by the half vectors' turn and by 1/w, Q14; the normals' own takes what lies between corners
         * that face the half vector outwards, but for what spreading takes back.
         */
        const int32_t margin = (is_front ? turn >> 6 : turn * 5 >> 5) + (bend * 9 >> 4) + (change * 7 >> 5);
        if (is_outside_octagon(fast, all, n, scale_margin(fast, margin)))
            return GLINT_EXACT_DIFFUSE;
    }
    if (!is_front || any & GLINT_VERTEX_FAR)
        return GLINT_EXACT_UNFIT;
    const int32_t whole = turn + (change * change >> 14) + (bend * 3 >> 2) + (bend * bend >> 13);
    if (whole <= limits->turn_specular >> (triangle->area > limits->large) && !(any & GLINT_VERTEX_DIM))
        return GLINT_EXACT_SPECULAR;
    /* of random triangles no more than 0.031 d^3, which is below d^2 / 32 up to GLINT_INTERPOLATE_TURN */
    *error = scale_margin(fast, whole >> 6) + 1;
    return *inside || whole > GLINT_INTERPOLATE_TURN || *error > MOST_BULGE ? GLINT_EXACT_UNFIT : GLINT_EXACT_SPECULAR;
}

glint_exact_kind glint_interpolate_begin(const glint_draw *draw, const glint_triangle *triangle, const glint_part *part,
                                         glint_interpolation *to) {
    const glint_fast_terms *fast = draw->shading->fast;
    const glint_vertex *const *v = triangle->corners;
    const uint32_t all = v[0]->flags & v[1]->flags & v[2]->flags, any = v[0]->flags | v[1]->flags | v[2]->flags;
    int32_t turn, change;
    if (!(all & GLINT_VERTEX_LIT) || any & GLINT_VERTEX_UNFIT || triangle->area < GLINT_POLYNOMIAL_LEAST_AREA ||
        glint_slenderness(&part->gradients, triangle->area) > GLINT_SLENDER ||
        !find_edges(triangle, to->edges, &turn, &change) ||
        turn + (change * change >> 14) > fast->exact.turn >> (triangle->area > fast->exact.large))
        return GLINT_EXACT_UNFIT;
    const int16_t *const t0 = glint_fast_terms_of(draw, v[0]), *const t1 = glint_fast_terms_of(draw, v[1]),
                         *const t2 = glint_fast_terms_of(draw, v[2]);
    const int32_t a[3] = {t0[0], t1[0], t2[0]};
    int32_t b[3];
    bulged_deviation n;
    glint_exact_kind kind = GLINT_EXACT_DIFFUSE;
    if (fast->specular_end) {
        int inside;
        int32_t error = 0;
        n.x[0] = t0[1], n.x[1] = t1[1], n.x[2] = t2[1];
        n.y[0] = t0[2], n.y[1] = t1[2], n.y[2] = t2[2];
        kind = find_kind(fast, triangle, &n, turn, change, &inside, &error);
        if (kind == GLINT_EXACT_UNFIT)
            return kind;
        if (kind == GLINT_EXACT_SPECULAR) {
            if (!find_edge_middles(fast, triangle, to->edges, &n))
                return GLINT_EXACT_UNFIT;
            if (!inside && is_beyond(fast, &n, MARGIN + error))
                kind = GLINT_EXACT_DIFFUSE;
            else if (error)
                return GLINT_EXACT_UNFIT;
        }
    }
    find_bulges(to->edges, a, b);
    to->gated = (any & GLINT_VERTEX_DIM) != 0;
    glint_barycentric_begin(&to->gradients, &part->gradients, 16);
    glint_polynomial_begin(&to->cosine, &to->gradients, a, b);
    if (kind == GLINT_EXACT_SPECULAR) {
        to->clamped = find_most(a, b) > fast->exact.full;
        begin_highlight(to, &n);
    }
    return kind;
}

const glint_interpolation *glint_interpolation_find(glint_workspace *workspace, const glint_draw *draw,
                                                    const glint_triangle *triangle, const glint_part *part,
                                                    glint_interpolation *own) {
    const glint_interpolation *const before = glint_found_find(workspace, triangle, part, 0);
    if (before)
        return before;
    glint_interpolation *const kept = glint_found_begin(workspace, triangle, part, sizeof *kept);
    glint_interpolation *const found = kept ? kept : own;
    found->kind = glint_interpolate_begin(draw, triangle, part, found);
    if (kept)
        glint_found_keep(workspace, triangle, 0,
                         found->kind == GLINT_EXACT_UNFIT     ? offsetof(glint_interpolation, gated)
                         : found->kind == GLINT_EXACT_DIFFUSE ? offsetof(glint_interpolation, x)
                                                              : offsetof(glint_interpolation, edges));
    return found;
}
