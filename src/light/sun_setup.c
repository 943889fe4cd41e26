/* SPDX-License-Identifier: MIT */
/* Sets up a triangle under suns: its planes and quadratics, from the normals and terms of its corners. suns.h */
#include "../raster/small.h"
#include "suns.h"

static inline int32_t dot16(const int32_t a[3], const int16_t b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ---- Quadratics ---- */

/* Returns the leading zeros of a triangle's slopes, at least 19. */
static inline unsigned slope_zeros(const glint_slopes *slopes) {
    return glint_leading_zeros(glint_magnitude_bits(slopes->x1) | glint_magnitude_bits(slopes->x2) |
                               glint_magnitude_bits(slopes->y1) | glint_magnitude_bits(slopes->y2) | 1);
}

/*
 * Returns how many bits beyond 16 the coefficients of second order keep while a quadratic is brought to the screen, so
 * that their products with slopes have 31 bits. Their errors grow with the square of the triangle's size.
 */
static inline unsigned fine_bits(int32_t bb, int32_t cc, int32_t bc, unsigned zeros) {
    const int32_t most = (int32_t)(zeros + glint_leading_zeros(glint_magnitude_bits(bb) | glint_magnitude_bits(cc) |
                                                               glint_magnitude_bits(bc) | 1)) -
                         22;
    return (unsigned)glint_most(glint_least(most, 6), 0);
}

/*
 * Brings a quadratic to the screen: value + of_b b + of_c c + bb b^2 + 2 bc b c + cc c^2, where b and c are the
 * barycentric coordinates of the second and the third corner. `value` and the result are 1 = 2^32 if `is_fine`, else
 * 1 = 2^28; of_b and of_c are 1 = 2^16; bb, cc and bc are 1 = 2^28, below 2^27. Slopes are below 2^13. Products have up
 * to 31 bits.
 */
static GLINT_SPECIAL void set_quadratic(glint_quadratic *q, uint32_t value, int32_t of_b, int32_t of_c, int32_t bb,
                                        int32_t cc, int32_t bc, const glint_slopes *slopes, unsigned zeros,
                                        const int is_fine) {
    const int32_t half = 1 << 13;
    const unsigned fine = fine_bits(bb, cc, bc, zeros);
    const int32_t bb_fine = glint_shift_right(bb, 12 - fine), cc_fine = glint_shift_right(cc, 12 - fine),
                  bc_fine = glint_shift_right(bc, 12 - fine);
    const int32_t x1 = slopes->x1, x2 = slopes->x2, y1 = slopes->y1, y2 = slopes->y2;
    const int32_t bx = glint_shift_right((int32_t)glint_weigh(bb_fine, x1, bc_fine, x2) + half, 14),
                  cx = glint_shift_right((int32_t)glint_weigh(bc_fine, x1, cc_fine, x2) + half, 14);
    const int32_t by = glint_shift_right((int32_t)glint_weigh(bb_fine, y1, bc_fine, y2) + half, 14),
                  cy = glint_shift_right((int32_t)glint_weigh(bc_fine, y1, cc_fine, y2) + half, 14);
    const int32_t xx = (int32_t)glint_weigh(bx, x1, cx, x2), xy = (int32_t)glint_weigh(bx, y1, cx, y2),
                  yy = (int32_t)glint_weigh(by, y1, cy, y2); /* 1 = 2^(30 + fine) */
    bb = glint_shift_right(bb, 12), cc = glint_shift_right(cc, 12), bc = glint_shift_right(bc, 12);
    /* the derivatives by b and c at the first pixel */
    const int32_t by_b = of_b + glint_shift_right((int32_t)glint_weigh(bb, slopes->start1, bc, slopes->start2), 13),
                  by_c = of_c + glint_shift_right((int32_t)glint_weigh(bc, slopes->start1, cc, slopes->start2), 13);
    const uint32_t x = glint_weigh(by_b, x1, by_c, x2), y = glint_weigh(by_b, y1, by_c, y2);
    const uint32_t twice_start = glint_weigh(of_b + by_b, slopes->start1, of_c + by_c, slopes->start2);
    if (is_fine) {
        q->xx = (uint32_t)glint_shift_right(xx, fine) << 2;
        q->xy = (uint32_t)glint_shift_right(xy, fine) << 3;
        q->yy = (uint32_t)glint_shift_right(yy, fine) << 2;
        q->x = x << 2, q->y = y << 2;
        q->value = value + (twice_start << 1);
    } else {
        q->xx = (uint32_t)glint_shift_right(xx, 2 + fine);
        q->xy = (uint32_t)glint_shift_right(xy, 1 + fine);
        q->yy = (uint32_t)glint_shift_right(yy, 2 + fine);
        q->x = (uint32_t)glint_shift_right((int32_t)x, 2);
        q->y = (uint32_t)glint_shift_right((int32_t)y, 2);
        q->value = value + (uint32_t)glint_shift_right((int32_t)twice_start, 3);
    }
}

/* Converts products from 1 = 2^28 to 1 = 2^16, rounded. */
static inline int32_t to_q16(int32_t x) {
    return glint_shift_right(x + (1 << 11), 12);
}

/* ---- Triangles ---- */

static inline uint32_t most_of(uint32_t a, uint32_t b, uint32_t c) {
    const uint32_t most = a > b ? a : b;
    return most > c ? most : c;
}

static inline uint32_t least_of(uint32_t a, uint32_t b, uint32_t c) {
    const uint32_t least = a < b ? a : b;
    return least < c ? least : c;
}

/* The largest square of a difference between normals, 1 = 2^28, for which scalars serve. */
#define MOST_CHANGE (1u << 27)

/* Sets N' at a corner, 1 = 2^14, given its normal and its 1/w, both 1 = 2^15. @return N'.N', 1 = 2^28 */
static GLINT_SPECIAL uint32_t set_normal(int32_t n[3], const int16_t *normal, int32_t over_w) {
    const int32_t half = 1 << 15, x = glint_shift_right(normal[0] * over_w + half, 16),
                  y = glint_shift_right(normal[1] * over_w + half, 16),
                  z = glint_shift_right(normal[2] * over_w + half, 16);
    n[0] = x, n[1] = y, n[2] = z;
    return (uint32_t)(x * x + y * y + z * z);
}

int glint_begin_sun_normals(const glint_row_walk *walk, glint_sun_triangle *t) {
    const glint_vertex *a = t->corners[0], *b = t->corners[1], *c = t->corners[2];
    const int32_t wa = a->inverse_w, wb = b->inverse_w, wc = c->inverse_w;
    const uint32_t nearest = (uint32_t)glint_most_of(wa, wb, wc), up = glint_leading_zeros(nearest) - 1;
    /* 2^31 over 16 bits of the largest 1/w, whose top bit is set anyway: the nearest corner's N' is nearly 1 long */
    int32_t inverse = glint_reciprocal16(nearest << up >> 15 | 1u << 15);
    inverse -= inverse >> 9; /* N'.N' stays below 1 */
    if (walk->triangle.back)
        inverse = -inverse;
    const uint32_t at_a = set_normal(t->n[0], a->attribute, glint_shift_right((wa << up >> 16) * inverse, 15)),
                   at_b = set_normal(t->n[1], b->attribute, glint_shift_right((wb << up >> 16) * inverse, 15)),
                   at_c = set_normal(t->n[2], c->attribute, glint_shift_right((wc << up >> 16) * inverse, 15));
    const int32_t x = t->n[0][0], y = t->n[0][1], z = t->n[0][2], x1 = t->n[1][0] - x, y1 = t->n[1][1] - y,
                  z1 = t->n[1][2] - z, x2 = t->n[2][0] - x, y2 = t->n[2][1] - y, z2 = t->n[2][2] - z;
    t->d1[0] = x1, t->d1[1] = y1, t->d1[2] = z1;
    t->d2[0] = x2, t->d2[1] = y2, t->d2[2] = z2;
    const int32_t s = x1 * x1 + y1 * y1 + z1 * z1, q = x2 * x2 + y2 * y2 + z2 * z2, u = x1 * x2 + y1 * y2 + z1 * z2;
    t->zeros = slope_zeros(&walk->slopes);
    t->change = most_of((uint32_t)s, (uint32_t)q, (uint32_t)(s + q - 2 * u));
    t->least = least_of(at_a, at_b, at_c);
    /* between corners N'.N' may be less than at corners by a third of `change` */
    if (t->change > MOST_CHANGE || t->least < GLINT_LEAST_NORMAL + t->change / 2)
        return 0;
    set_quadratic(&t->normal, at_a << 4, to_q16((int32_t)(at_b - at_a) - s), to_q16((int32_t)(at_c - at_a) - q), s, q,
                  u, &walk->slopes, t->zeros, 1);
    return 1;
}

/* If N'.N' is at least this, the square of a difference of N' is at least 2/3 of the square of the normals' angle. */
#define LEAST_WITH_ANGLE (9u << 24)

/*
 * Returns whether all fragments lie outside of the highlight, given the largest squares of changes of N' and of H, 1 =
 * 2^28, and the least `outside` of the corners. The distance from any point of a triangle to the nearest corner is at
 * most 3^-1/2 of the longest side; so it is for normals and half vectors.
 */
static inline int is_gloss_outside(const glint_suns *suns, uint32_t change, uint32_t bend, uint32_t outside) {
    const uint32_t large = change > bend ? change : bend,
                   both = large + large / 2 + 3 * (change + bend - large); /* (a + b)^2 <= 3/2 a^2 + 3 b^2 */
    return outside > suns->far + ((both >> 12) * suns->far_slope >> 10);
}

/* Scalar products of the differences E1 and E2 of H or V between the first corner and the others: E1.E1, E2.E2 and
 * E1.E2, 1 = 2^28. */
typedef struct bend_products {
    int32_t bb, cc, bc;
} bend_products;

/* Adds the products of one component, which is a, b, c at the corners. */
static inline void add_bends(bend_products *bends, int32_t a, int32_t b, int32_t c) {
    const int32_t e1 = b - a, e2 = c - a;
    bends->bb += e1 * e1;
    bends->cc += e2 * e2;
    bends->bc += e1 * e2;
}

/* Finds the bends of a light's terms. @return the largest square of a difference between two corners */
static GLINT_INLINE uint32_t find_bends(bend_products *bends, const glint_sun_term *a, const glint_sun_term *b,
                                        const glint_sun_term *c) {
    *bends = (bend_products){0, 0, 0};
    add_bends(bends, a->v[0], b->v[0], c->v[0]);
    add_bends(bends, a->v[1], b->v[1], c->v[1]);
    add_bends(bends, a->v[2], b->v[2], c->v[2]);
    return most_of((uint32_t)bends->bb, (uint32_t)bends->cc, (uint32_t)(bends->bb + bends->cc - 2 * bends->bc));
}

/* Coefficients of second order of a product of two values that are linear between corners, of b^2, c^2 and b c; of N'
 * with the differences D1 and D2, and H or V, they are D1.E1, D2.E2 and D1.E2 + D2.E1. */
typedef struct second_order {
    int32_t bb, cc, bc;
} second_order;

/* Adds the coefficients of one component: x1, x2 are its D1 and D2, and its H or V is a, b, c at the corners. */
static inline void add_second_order(second_order *sum, int32_t x1, int32_t x2, int32_t a, int32_t b, int32_t c) {
    const int32_t e1 = b - a, e2 = c - a;
    sum->bb += x1 * e1;
    sum->cc += x2 * e2;
    sum->bc += x1 * e2 + x2 * e1;
}

/*
 * Returns by how much the product of a vector and of one that is linear between corners is less than that of a unit
 * one, in second order, 1 = 2^28; a, b, c are the products at the corners, 1 = 2^14. Along each side this is half of
 * the square of its bend, times the mean of both ends.
 */
static inline second_order find_lacking(const bend_products *bends, int32_t a, int32_t b, int32_t c) {
    const int32_t across = bends->bb + bends->cc - 2 * bends->bc;
    const int32_t bb = glint_shift_right(bends->bb, 14) * glint_shift_right(a + b, 1),
                  cc = glint_shift_right(bends->cc, 14) * glint_shift_right(a + c, 1),
                  opposite = glint_shift_right(across, 14) * glint_shift_right(b + c, 1);
    return (second_order){glint_shift_right(bb, 1), glint_shift_right(cc, 1), glint_shift_right(bb + cc - opposite, 1)};
}

/* Returns a.b, 1 = 2^28, as if b, 1 = 2^14, were unit: rounding has made b up to 2^-14 longer or shorter. */
static inline int32_t along_unit(const int32_t a[3], const int16_t b[3]) {
    const int32_t dot = dot16(a, b), lacking = (1 << 28) - b[0] * b[0] - b[1] * b[1] - b[2] * b[2];
    return dot + glint_shift_right(glint_shift_right(dot, 14) * lacking, 15);
}

/*
 * Sets whether a highlight may be visible, given N'.H at corners, one of them below 0: it is not if all are.
 * @return 0 if the highlight around -H would be visible, as sin^2 is the same there as around H
 */
static int is_unambiguous(const glint_sun_triangle *t, glint_lit_sun *lit, int32_t a, int32_t b, int32_t c) {
    const int32_t least = glint_shift_right(glint_least_of(a, b, c), 14);
    lit->gloss = glint_most_of(a, b, c) > 0;
    return !lit->gloss || (uint32_t)(least * least) <= (t->least >> 14) * (((1u << 30) - t->suns->end) >> 16);
}

/* Sets N'.H, given H at the corners; or N'.V likewise. H is made unit between corners by taking what it lacks of that
 * from the second order; `sum` is to be added to the second order. @return 0 if scalars do not serve */
static GLINT_NOINLINE int set_half(const glint_row_walk *walk, const glint_sun_triangle *t, const bend_products *bends,
                                   second_order sum, const int16_t *a, const int16_t *b, const int16_t *c,
                                   glint_lit_sun *lit) {
    const int32_t at_a = along_unit(t->n[0], a), at_b = along_unit(t->n[1], b), at_c = along_unit(t->n[2], c);
    const second_order lacking =
        find_lacking(bends, glint_shift_right(at_a, 14), glint_shift_right(at_b, 14), glint_shift_right(at_c, 14));
    add_second_order(&sum, t->d1[0], t->d2[0], a[0], b[0], c[0]);
    add_second_order(&sum, t->d1[1], t->d2[1], a[1], b[1], c[1]);
    add_second_order(&sum, t->d1[2], t->d2[2], a[2], b[2], c[2]);
    sum.bb -= lacking.bb, sum.cc -= lacking.cc, sum.bc -= lacking.bc;
    set_quadratic(&lit->half, (uint32_t)at_a + (1 << 11), to_q16(at_b - at_a - sum.bb), to_q16(at_c - at_a - sum.cc),
                  sum.bb, sum.cc, glint_shift_right(sum.bc, 1), &walk->slopes, t->zeros, 0);
    return (at_a | at_b | at_c) >= 0 || t->suns->is_mirror || is_unambiguous(t, lit, at_a, at_b, at_c);
}

/* Returns (1 + L.V) / 2, 1 = 2^28: at least two steps of 2^16, so that rounding makes no fragment's negative. */
static inline int32_t find_light_view(const glint_drawn_sun *sun, const int16_t v[3]) {
    return glint_most((1 << 27) + glint_shift_right(dot16(sun->light, v), 2), 1 << 13);
}

/* Returns L.V, 1 = 2^14, given (1 + L.V) / 2. */
static inline int32_t find_cosine(int32_t light_view) {
    return glint_shift_right(light_view, 13) - (1 << 14);
}

/* Returns the second order, 1 = 2^28, that weights of 1 / z add to a scalar product of V. z at the first corner over z
 * at the second and the third is 1 + k1 and 1 + k2, 1 = 2^14; the product there differs by change1 and change2 from
 * that at the first corner. */
static inline second_order second_order_of_depth(int32_t k1, int32_t k2, int32_t change1, int32_t change2) {
    change1 = glint_shift_right(change1, 14);
    change2 = glint_shift_right(change2, 14);
    return (second_order){-k1 * change1, -k2 * change2, -k1 * change2 - k2 * change1};
}

/*
 * Sets N'.V and (1 + L.V) / 2. Not V but V over its z is linear on the screen, so that the unit V of corners have
 * weights of 1 / z, which adds to the second order.
 */
static GLINT_NOINLINE void begin_mirror(const glint_row_walk *walk, const glint_sun_triangle *t,
                                        const bend_products *bends, const int16_t *a, const int16_t *b,
                                        const int16_t *c, glint_lit_sun *lit) {
    const int32_t at_a = find_light_view(lit->sun, a), at_b = find_light_view(lit->sun, b),
                  at_c = find_light_view(lit->sun, c), k1 = (a[2] - b[2]) * (1 << 14) / b[2],
                  k2 = (a[2] - c[2]) * (1 << 14) / c[2], first = dot16(t->n[0], a);
    const second_order of_normal = second_order_of_depth(k1, k2, dot16(t->n[0], b) - first, dot16(t->n[0], c) - first);
    (void)set_half(walk, t, bends, of_normal, a, b, c, lit);
    const second_order of_light = second_order_of_depth(k1, k2, at_b - at_a, at_c - at_a),
                       lacking = find_lacking(bends, find_cosine(at_a), find_cosine(at_b), find_cosine(at_c));
    const int32_t bb = glint_shift_right(of_light.bb - glint_shift_right(lacking.bb, 1), 12),
                  cc = glint_shift_right(of_light.cc - glint_shift_right(lacking.cc, 1), 12),
                  bc = glint_shift_right(of_light.bc - glint_shift_right(lacking.bc, 1), 13);
    set_quadratic(&lit->light_view, (uint32_t)at_a + (1 << 11), to_q16(at_b - at_a) - bb, to_q16(at_c - at_a) - cc,
                  glint_shift_left(bb, 12), glint_shift_left(cc, 12), glint_shift_left(bc, 12), &walk->slopes, t->zeros,
                  0);
}

/* A V, 1 = 2^14, with less along z has too few bits of it for weights of 1 / z. */
#define LEAST_VIEW_Z 64

/* Sets the highlight of a light, given its terms at corners. @return 0 if scalars do not serve */
static inline int begin_gloss(const glint_row_walk *walk, const glint_sun_triangle *t, glint_lit_sun *lit,
                              const glint_sun_term *a, const glint_sun_term *b, const glint_sun_term *c) {
    const glint_suns *suns = t->suns;
    bend_products bends;
    const uint32_t bend = find_bends(&bends, a, b, c);
    if (t->least >= LEAST_WITH_ANGLE &&
        is_gloss_outside(suns, t->change, bend, least_of(a->outside, b->outside, c->outside)))
        return 1;
    if (bend > suns->bend || !(a->v[0] | a->v[1] | a->v[2]) || !suns->bend)
        return 0;
    lit->gloss = 1;
    if (!suns->is_mirror)
        return set_half(walk, t, &bends, (second_order){0, 0, 0}, a->v, b->v, c->v, lit);
    if (glint_least_of(a->v[2], b->v[2], c->v[2]) < LEAST_VIEW_Z)
        return 0;
    begin_mirror(walk, t, &bends, a->v, b->v, c->v, lit);
    return 1;
}

/* Sets a light, unless no corner faces it. @return 0 if scalars do not serve */
static GLINT_NOINLINE int begin_sun(const glint_row_walk *walk, glint_sun_triangle *t, const glint_drawn_sun *sun,
                                    const glint_sun_term *at_a, const glint_sun_term *at_b,
                                    const glint_sun_term *at_c) {
    glint_lit_sun *lit = &t->lit[t->count];
    const glint_slopes *slopes = &walk->slopes;
    const int32_t gate = t->suns->gate, a = glint_dot32(t->n[0], sun->light), d1 = glint_dot32(t->d1, sun->light),
                  d2 = glint_dot32(t->d2, sun->light);
    if (a <= gate && a + d1 <= gate && a + d2 <= gate)
        return 1;
    const int32_t l1 = glint_shift_right(d1 + (1 << 12), 13), l2 = glint_shift_right(d2 + (1 << 12), 13);
    t->count++;
    lit->sun = sun;
    lit->gloss = 0;
    lit->is_plain = t->suns->is_plain && (!gate || (a > 0 && a + d1 > 0 && a + d2 > 0));
    lit->light.x = (uint32_t)glint_shift_right((int32_t)glint_weigh(l1, slopes->x1, l2, slopes->x2), 1);
    lit->light.y = (uint32_t)glint_shift_right((int32_t)glint_weigh(l1, slopes->y1, l2, slopes->y2), 1);
    lit->light.value =
        (uint32_t)a + (uint32_t)glint_shift_right((int32_t)glint_weigh(l1, slopes->start1, l2, slopes->start2), 1);
    return !sun->shines || begin_gloss(walk, t, lit, at_a, at_b, at_c);
}

int glint_begin_suns(const glint_row_walk *walk, glint_sun_triangle *t) {
    const glint_sun_term *a = t->terms[0], *b = t->terms[1], *c = t->terms[2];
    for (const glint_drawn_sun *sun = t->suns->suns, *end = sun + t->suns->count; sun != end; sun++) {
        if (!begin_sun(walk, t, sun, a, b, c))
            return 0;
        a += sun->shines, b += sun->shines, c += sun->shines;
    }
    return 1;
}

/* ---- Triangles of one colour ---- */

/* Returns whether a light's highlight is not visible on a triangle whose normals are the same. */
static int is_matt(const glint_row_walk *walk, const glint_suns *suns, size_t term) {
    const glint_draw *draw = walk->draw;
    const glint_sun_term *terms[3];
    bend_products bends;
    for (int k = 0; k < 3; k++)
        terms[k] = draw->terms + (size_t)(walk->triangle.corners[k] - draw->vertices) * suns->terms + term;
    const uint32_t bend = find_bends(&bends, terms[0], terms[1], terms[2]);
    return is_gloss_outside(suns, 0, bend, least_of(terms[0]->outside, terms[1]->outside, terms[2]->outside));
}

GLINT_NOINLINE int glint_find_one_word(const glint_row_walk *walk, uint32_t *word) {
    const glint_suns *suns = walk->draw->shading->suns;
    const int16_t *n = walk->triangle.corners[0]->attribute;
    glint_spread p = {0, suns->first, 0, 1u << 14};
    size_t term = 0;
    for (const glint_drawn_sun *sun = suns->suns, *end = sun + suns->count; sun != end; sun++) {
        const int32_t dot = dot16(sun->light, n), light = walk->triangle.back ? -dot : dot;
        if (light > suns->gate && sun->shines && !is_matt(walk, suns, term))
            return 0;
        if (light > 0)
            glint_add_sun(walk, sun, &p, glint_shift_right(light, 1), GLINT_GLOSS_ENTRIES);
        term += sun->shines;
    }
    if (suns->takes_most)
        glint_take_larger(suns->dark, &p, &p + 1);
    *word = p.colour;
    return 1;
}
