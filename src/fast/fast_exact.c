/* SPDX-License-Identifier: MIT */
/*
 * Exact lighting of fragments under one directional light, by quadratics.
 * With M = N/w, which is linear on the screen, N.L = M.L / |M|, and the deviation of N from the half vector H
 * (fast_vertices.c) is that of M, which is linear in M, over |M|. So quadratics give a fragment's light: M.M exactly;
 * and the deviation, for the infinite viewer exactly, for the local one with H linear around a point of the triangle.
 */
#include "fast_exact.h"

#include "../math/division.h"
#include "../raster/setup.h"

/* N.L, Q15, that is above 0 at every pixel (LIT in fast_vertices.c). */
#define SURELY_LIT 300

/* N.L at which rounding cannot light what faces away (fast_vertices.c). */
#define SURELY_UNLIT (-16)

/* M.M stays above 0.3 of its largest. */
#define LEAST_EXACT_SQUARE ((6u << 27) / 10 * 3)

/* ---- Triangle ---- */

static inline int32_t dot(const int32_t a[3], const int32_t b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* x 2^n modulo 2^32, rounded down; n below 32. */
static inline uint32_t scale_to_bits(int32_t x, int32_t n) {
    return n >= 0 ? (uint32_t)x << n : (uint32_t)glint_shift_right(x, (unsigned)(n < -31 ? 31 : -n));
}

static inline int32_t square_of_sum(int32_t a, int32_t b, int32_t c) {
    const int32_t sum = glint_shift_right(a + b + c, 2);
    return sum * sum;
}

/*
 * 1/w of the corners, the largest 32256: |M| then stays below 1 with all errors of its planes. Where the normals are
 * the same they need no weights.
 * @return 0 where M.M gets too small: by the turn of the normals, an edge's middle has it 1 - turn / 6. Corners that
 * clipping makes may be short: what N.N lacks of 1 there counts three times in `turn`, and M.M is above 1 - turn / 3
 */
static int find_weights(const glint_triangle *triangle, int32_t weight[3]) {
    const glint_vertex *const *v = triangle->corners;
    const int16_t *a = v[0]->attribute, *b = v[1]->attribute, *c = v[2]->attribute;
    const int32_t turn = 9 * (GLINT_UNIT / 4 * (GLINT_UNIT / 4)) - square_of_sum(a[0], b[0], c[0]) -
                         square_of_sum(a[1], b[1], c[1]) - square_of_sum(a[2], b[2], c[2]); /* Q26 */
    uint32_t w0 = (uint32_t)v[0]->inverse_w, w1 = (uint32_t)v[1]->inverse_w, w2 = (uint32_t)v[2]->inverse_w;
    const unsigned zeros = glint_leading_zeros(w0 | w1 | w2);
    w0 = w0 << zeros >> 16, w1 = w1 << zeros >> 16, w2 = w2 << zeros >> 16;
    uint32_t reciprocal = (uint32_t)glint_reciprocal16((uint32_t)glint_most_of((int32_t)w0, (int32_t)w1, (int32_t)w2));
    reciprocal -= reciprocal >> 6;
    weight[0] = (int32_t)(w0 * reciprocal >> 16);
    weight[1] = (int32_t)(w1 * reciprocal >> 16);
    weight[2] = (int32_t)(w2 * reciprocal >> 16);
    if (turn < 64 && a[0] == b[0] && a[1] == b[1] && a[2] == b[2] && a[0] == c[0] && a[1] == c[1] && a[2] == c[2])
        weight[0] = weight[1] = weight[2] = 32256;
    const unsigned is_made = v[0]->flags & GLINT_VERTEX_LIT ? 0 : 1;
    const int32_t smallest = glint_least_of(weight[0], weight[1], weight[2]),
                  left = (6 << 12) - glint_shift_right(turn, 14 - is_made);
    return left > 0 && (uint32_t)(smallest * smallest >> 15) * (uint32_t)left > LEAST_EXACT_SQUARE;
}

/* Does a narrow triangle's plane, Q30, of corners that are d1 and d2 apart, have slopes that 32 bits cannot hold? */
static inline int wraps(const glint_gradients *g, int32_t area, int32_t d1, int32_t d2) {
    d1 = glint_shift_right(d1, 16), d2 = glint_shift_right(d2, 16);
    const uint32_t slopes =
        glint_magnitude_bits(d1 * g->x1 + d2 * g->x2) | glint_magnitude_bits(d1 * g->y1 + d2 * g->y2);
    return slopes >> 11 >= (uint32_t)area; /* areas are 28.4 squared, and sides 28.4 */
}

/*
 * Planes of M.L and M. @return 0 for slivers, and where M changes too much from pixel to pixel. Of the slivers that are
 * left, only narrow triangles may have slopes of 2^32.
 */
static int find_planes(const glint_triangle *triangle, const glint_gradients *g, const int32_t cosine[3],
                       glint_exact_light *light) {
    const int16_t *a = triangle->corners[0]->attribute, *b = triangle->corners[1]->attribute,
                  *c = triangle->corners[2]->attribute;
    int32_t w[3];
    uint32_t bits = 0;
    if (glint_slenderness(g, triangle->area) > GLINT_SLENDER || !find_weights(triangle, w))
        return 0;
    glint_plane_begin(&light->cosine, g, cosine[0] * w[0], cosine[1] * w[1], cosine[2] * w[2]);
    for (int i = 0; i < 3; i++) {
        glint_plane *plane = &light->normal[i];
        const int32_t m0 = a[i] * w[0], m1 = b[i] * w[1], m2 = c[i] * w[2];
        if (g->reciprocal && wraps(g, triangle->area, m1 - m0, m2 - m0))
            return 0;
        glint_plane_begin(plane, g, m0, m1, m2);
        bits |= glint_magnitude_bits(plane->dx) | glint_magnitude_bits(plane->dy);
    }
    const int32_t size = 18 - (int32_t)glint_leading_zeros(bits);
    light->size = size < 0 ? 0 : size;
    return size <= 15;
}

/* M at the anchor, Q15, and its steps, 14 bits and a sign. */
typedef struct exact_steps {
    int32_t m[3], x[3], y[3];
} exact_steps;

static void find_steps(const glint_exact_light *light, exact_steps *s) {
    const unsigned size = (unsigned)light->size;
    const int32_t half = glint_shift_right(glint_shift_left(1, size), 1);
    for (int c = 0; c < 3; c++) {
        s->m[c] = glint_shift_right(light->normal[c].start + 0x4000, 15);
        s->x[c] = glint_shift_right(light->normal[c].dx + half, size);
        s->y[c] = glint_shift_right(light->normal[c].dy + half, size);
    }
}

static void find_square(glint_quadratic *q, const exact_steps *s, int32_t size) {
    const int32_t *m = s->m, *x = s->x, *y = s->y;
    const uint32_t square =
        (uint32_t)m[0] * (uint32_t)m[0] + (uint32_t)m[1] * (uint32_t)m[1] + (uint32_t)m[2] * (uint32_t)m[2];
    q->start = (square - (1 << 28)) << 2;
    q->dx = scale_to_bits(dot(m, x), size - 12);
    q->dy = scale_to_bits(dot(m, y), size - 12);
    q->dxx = scale_to_bits(dot(x, x), 2 * size - 28);
    q->dxy = scale_to_bits(dot(x, y), 2 * size - 27);
    q->dyy = scale_to_bits(dot(y, y), 2 * size - 28);
}

/* Can none of three deviations and what lies between them be in the highlight? Q14. */
static int is_outside_exactly(int32_t cut, int32_t diagonal, int32_t e[3][2]) {
    const int32_t x0 = e[0][0], x1 = e[1][0], x2 = e[2][0], y0 = e[0][1], y1 = e[1][1], y2 = e[2][1];
    return glint_least_of(x0, x1, x2) >= cut || glint_most_of(x0, x1, x2) <= -cut ||
           glint_least_of(y0, y1, y2) >= cut || glint_most_of(y0, y1, y2) <= -cut ||
           glint_least_of(x0 + y0, x1 + y1, x2 + y2) >= diagonal ||
           glint_most_of(x0 + y0, x1 + y1, x2 + y2) <= -diagonal ||
           glint_least_of(x0 - y0, x1 - y1, x2 - y2) >= diagonal ||
           glint_most_of(x0 - y0, x1 - y1, x2 - y2) <= -diagonal;
}

/* Does the highlight of the infinite viewer show? */
static glint_exact_kind find_infinite(const glint_fast_terms *fast, const glint_triangle *triangle) {
    const glint_exact_limits *limits = &fast->exact;
    int32_t e[3][2], behind = 0;
    for (int i = 0; i < 3; i++) {
        const int16_t *normal = triangle->corners[i]->attribute;
        e[i][0] = glint_shift_right(glint_dot(limits->across[0], normal), 16);
        e[i][1] = glint_shift_right(glint_dot(limits->across[1], normal), 16);
        behind |= glint_dot(fast->half_vector, normal) < limits->behind * (1 << 15);
    }
    if (is_outside_exactly(limits->cut + 8, limits->cut_diagonal + 8, e))
        return GLINT_EXACT_DIFFUSE;
    return behind ? GLINT_EXACT_UNFIT : GLINT_EXACT_SPECULAR;
}

/* What a row of `across` makes of a change of M, from the planes' own: from the anchor steps of a few bits lead astray.
 */
static uint32_t change_across(const int16_t across[3], int32_t x, int32_t y, int32_t z) {
    const int64_t sum = glint_product(across[0], x) + glint_product(across[1], y) + glint_product(across[2], z);
    return (uint32_t)glint_shift_right64(sum, 15);
}

static void find_linear(glint_quadratic *q, const int32_t m[3], const glint_plane normal[3], const int16_t across[3]) {
    const int32_t t[3] = {across[0], across[1], across[2]};
    *q = (glint_quadratic){(uint32_t)dot(t, m),
                           change_across(across, normal[0].dx, normal[1].dx, normal[2].dx),
                           change_across(across, normal[0].dy, normal[1].dy, normal[2].dy),
                           0,
                           0,
                           0};
}

glint_exact_kind glint_exact_begin(const glint_draw *draw, const glint_triangle *triangle, const glint_part *part,
                                   glint_exact_light *light) {
    const glint_fast_terms *fast = draw->shading->fast;
    const glint_exact_limits *limits = &fast->exact;
    glint_exact_kind kind = GLINT_EXACT_DIFFUSE;
    int32_t cosine[3];
    exact_steps s;
    if (glint_is_deep(triangle))
        return GLINT_EXACT_UNFIT;
    for (int i = 0; i < 3; i++)
        cosine[i] = glint_shift_right(glint_dot(fast->light, triangle->corners[i]->attribute) + 0x4000, 15);
    if (glint_most_of(cosine[0], cosine[1], cosine[2]) <= SURELY_UNLIT && fast->unlit > INT16_MIN)
        return GLINT_EXACT_AMBIENT;
    if (triangle->corners[0]->flags & triangle->corners[1]->flags & triangle->corners[2]->flags & GLINT_VERTEX_UNFIT)
        return GLINT_EXACT_UNFIT; /* nowhere is there a half vector */
    if (fast->specular_end) {
        kind = fast->local_viewer ? GLINT_EXACT_SPECULAR : find_infinite(fast, triangle);
        if (!limits->limit)
            return GLINT_EXACT_UNFIT;
    }
    light->is_dim = glint_least_of(cosine[0], cosine[1], cosine[2]) < fast->lit_exactly;
    if (kind == GLINT_EXACT_UNFIT || (kind == GLINT_EXACT_SPECULAR && !fast->local_viewer && light->is_dim) ||
        !find_planes(triangle, &part->gradients, cosine, light))
        return GLINT_EXACT_UNFIT;
    find_steps(light, &s);
    find_square(&light->square, &s, light->size);
    if (kind == GLINT_EXACT_SPECULAR && !fast->local_viewer) {
        find_linear(&light->x, s.m, light->normal, limits->across[0]);
        find_linear(&light->y, s.m, light->normal, limits->across[1]);
    }
    return kind;
}

/* ---- Half vectors of the local viewer ---- */

/* A half vector, what it is made of, and 1 / (1 + hz). */
typedef struct view_and_half {
    glint_view_vector view;
    int32_t h[3], inverse;
} view_and_half;

/* At a point of the screen, 28.4. @return 0 where there is none */
static int find_half_vector(const glint_fast_terms *fast, int32_t x, int32_t y, view_and_half *at) {
    int16_t h[3];
    if (!glint_fast_half_vector(fast, x, y, h, &at->view))
        return 0;
    at->h[0] = h[0];
    at->h[1] = h[1];
    at->h[2] = h[2];
    at->inverse = glint_inverse_of_one_and(h[2]);
    return 1;
}

/*
 * Its change from pixel to pixel, 14 bits and a sign, 2^-pixel_shift: with V's change u k, u = -x + V vx or y - V vy,
 * that of H is (u - H (H.u)) k / |L + V|.
 */
static void find_change(const glint_exact_limits *limits, const view_and_half *at, int axis, int32_t change[3]) {
    const int32_t *v = at->view.v, *h = at->h;
    const uint32_t length = (uint32_t)at->view.root * (uint32_t)at->view.half_root >> 17; /* k / |L + V|, Q15 */
    const int32_t factor = glint_shift_right(limits->pixel * (int32_t)length, 15);
    const int32_t along = axis ? -v[1] : v[0];
    int32_t u[3];
    for (int c = 0; c < 3; c++)
        u[c] = glint_shift_right(v[c] * along, 15);
    u[axis] += axis ? 1 << 15 : -(1 << 15);
    const int32_t h_u = glint_shift_right(dot(h, u), 15);
    for (int c = 0; c < 3; c++)
        change[c] = glint_shift_right((u[c] - glint_shift_right(h[c] * h_u, 15)) * factor, 15);
}

/* What is left of m along H and z: (m.H + mz) / (1 + hz); UNIT is short of 2^15 by a part in 2^13. */
static int32_t find_along(const view_and_half *at, const int32_t m[3]) {
    int32_t along = dot(at->h, m);
    along = glint_shift_right(along + glint_shift_right(along, 13) + 0x4000, 15) + m[2];
    along = glint_shift_right(along * at->inverse + 0x4000, 15);
    return along + glint_shift_right(along + 0x1000, 13);
}

/* The change of m's deviation with H. */
static void find_exact_turn(const view_and_half *at, const int32_t m[3], int32_t along, const int32_t change[3],
                            int32_t e[2]) {
    const int32_t rest = glint_shift_right(dot(m, change) - along * change[2], 15);
    const int32_t back = glint_shift_right(rest * at->inverse, 15);
    e[0] = -(change[0] * along + at->h[0] * back);
    e[1] = -(change[1] * along + at->h[1] * back);
}

/* Does the highlight of the local viewer show in a square, by its middle's half vector? */
static glint_exact_kind find_local(const glint_fast_terms *fast, const glint_triangle *triangle,
                                   const view_and_half *at, int32_t margin) {
    int32_t e[3][2], behind = 0;
    for (int i = 0; i < 3; i++) {
        const int16_t *normal = triangle->corners[i]->attribute;
        const int32_t m[3] = {normal[0], normal[1], normal[2]};
        const int32_t along = find_along(at, m);
        e[i][0] = glint_shift_right(m[0] * (1 << 15) - at->h[0] * along, 16);
        e[i][1] = glint_shift_right(m[1] * (1 << 15) - at->h[1] * along, 16);
        behind |= glint_shift_right(dot(at->h, m), 15) - 2 * margin < fast->exact.behind;
    }
    if (is_outside_exactly(fast->cut + margin, fast->cut_diagonal + margin, e))
        return GLINT_EXACT_DIFFUSE;
    return behind ? GLINT_EXACT_UNFIT : GLINT_EXACT_SPECULAR;
}

/* The polynomial with its own anchor at (x, y), seen from the triangle's. */
static void move_anchor(glint_quadratic *q, int32_t x, int32_t y) {
    const uint32_t left = 0u - (uint32_t)x, up = 0u - (uint32_t)y;
    q->start += (q->dx + q->dxx * left) * left + (q->dy + q->dyy * up) * up + q->dxy * left * up;
    q->dx += 2 * q->dxx * left + q->dxy * up;
    q->dy += 2 * q->dyy * up + q->dxy * left;
}

/* The triangle's deviation around (x, y) from its anchor, whose half vector is known. */
static void find_bent(const glint_exact_limits *limits, const view_and_half *at, int32_t x, int32_t y,
                      glint_exact_light *light) {
    const int32_t size = light->size, shift = (int32_t)limits->pixel_shift;
    int32_t m[3], mx[3], my[3], hx[3], hy[3];
    for (int c = 0; c < 3; c++) {
        const glint_plane *plane = &light->normal[c];
        m[c] = glint_shift_right(glint_shift_right(glint_plane_at(plane, x, y), 15) * limits->scale + 0x8000, 16);
        mx[c] = glint_shift_right(glint_shift_right(plane->dx, (unsigned)size) * limits->scale, 15);
        my[c] = glint_shift_right(glint_shift_right(plane->dy, (unsigned)size) * limits->scale, 15);
    }
    find_change(limits, at, 0, hx);
    find_change(limits, at, 1, hy);
    const int32_t along = find_along(at, m), along_x = find_along(at, mx), along_y = find_along(at, my);
    int32_t ex[2], ey[2], exx[2], exy[2], eyx[2], eyy[2];
    find_exact_turn(at, m, along, hx, ex);
    find_exact_turn(at, m, along, hy, ey);
    find_exact_turn(at, mx, along_x, hx, exx);
    find_exact_turn(at, mx, along_x, hy, exy);
    find_exact_turn(at, my, along_y, hx, eyx);
    find_exact_turn(at, my, along_y, hy, eyy);
    for (int row = 0; row < 2; row++) {
        glint_quadratic *q = row ? &light->y : &light->x;
        q->dxx = scale_to_bits(exx[row], size - shift);
        q->dxy = scale_to_bits(exy[row] + eyx[row], size - shift);
        q->dyy = scale_to_bits(eyy[row], size - shift);
        q->start = (uint32_t)(m[row] * (1 << 15) - at->h[row] * along) << 1;
        q->dx =
            scale_to_bits(mx[row] * (1 << 15) - at->h[row] * along_x, size - 15) + scale_to_bits(ex[row], 16 - shift);
        q->dy =
            scale_to_bits(my[row] * (1 << 15) - at->h[row] * along_y, size - 15) + scale_to_bits(ey[row], 16 - shift);
        move_anchor(q, x, y);
    }
}

glint_exact_kind glint_exact_bend(const glint_fast_terms *fast, const glint_triangle *triangle, const glint_part *part,
                                  glint_square *square, glint_exact_light *light) {
    const glint_exact_limits *limits = &fast->exact;
    /* |dH| is at most that of the ray, in units of the focal length */
    const int32_t margin =
        (int32_t)scale_to_bits(square->extent * limits->pixel, 10 - (int32_t)limits->pixel_shift) + limits->error + 8;
    view_and_half at;
    if (!find_half_vector(fast, 16 * square->x + 8, 16 * square->y + 8, &at))
        return GLINT_EXACT_UNFIT;
    /* 2 / |L + V| is Q15, and 1 straight before the light */
    square->is_small = (uint32_t)square->extent * (uint32_t)at.view.half_root >> 15 <= (uint32_t)limits->extent;
    const glint_exact_kind kind = find_local(fast, triangle, &at, margin);
    if (kind == GLINT_EXACT_SPECULAR && light->is_dim)
        return GLINT_EXACT_UNFIT;
    if (kind == GLINT_EXACT_SPECULAR)
        find_bent(limits, &at, square->x - glint_shift_right(part->window.left, 4) + part->x,
                  square->y - glint_shift_right(part->window.top, 4) + part->y, light);
    return kind;
}

void glint_exact_square(const glint_fast_terms *fast, const glint_triangle *triangle, glint_square *square) {
    const glint_vertex *const *v = triangle->corners;
    const int32_t x0 = v[0]->x, x1 = v[1]->x, x2 = v[2]->x, y0 = v[0]->y, y1 = v[1]->y, y2 = v[2]->y;
    const int32_t width = glint_most_of(x0, x1, x2) - glint_least_of(x0, x1, x2),
                  height = glint_most_of(y0, y1, y2) - glint_least_of(y0, y1, y2);
    square->extent = width > height ? width : height;
    square->x = glint_shift_right((x0 + x1 + x2) * 1365, 16);
    square->y = glint_shift_right((y0 + y1 + y2) * 1365, 16);
    square->is_small = square->extent <= fast->exact.extent;
}
