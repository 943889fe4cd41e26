/* SPDX-License-Identifier: MIT */
/* A triangle under suns: its plane and quadratics, from what its corners keep. suns.h */
#include "../raster/small.h"
#include "suns.h"

static inline int32_t dot16(const int32_t a[3], const int16_t b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ---- Quadratics ---- */

/* Returns the leading zeros of a triangle's slopes, at least 19. */
static inline unsigned slope_zeros(const glint_slopes *o) {
    return glint_leading_zeros(glint_magnitude_bits(o->x1) | glint_magnitude_bits(o->x2) | glint_magnitude_bits(o->y1) |
                               glint_magnitude_bits(o->y2) | 1);
}

/*
 * Returns the bits beyond 16 that a second order keeps while it is brought to the screen, so that products with slopes
 * have 31 bits: errors of it grow with the square of a triangle's size.
 */
static inline unsigned fine_bits(int32_t s, int32_t t, int32_t u, unsigned zeros) {
    const int32_t most = (int32_t)(zeros + glint_leading_zeros(glint_magnitude_bits(s) | glint_magnitude_bits(t) |
                                                               glint_magnitude_bits(u) | 1)) -
                         22;
    return (unsigned)glint_most(glint_least(most, 6), 0);
}

/*
 * Brings a quadratic of barycentric coordinates to the screen; `up` of one whose values have 32 bits, else they have
 * 28. Of second order are s, t, u, below 2^27, 2^28 of 1; slopes are below 2^13. Those that are cut off have 31 bits.
 */
static GLINT_SPECIAL void set_quadratic(glint_quadratic *q, uint32_t value, int32_t of1, int32_t of2, int32_t s,
                                        int32_t t, int32_t u, const glint_slopes *o, unsigned zeros, const int up) {
    const int32_t half = 1 << 13;
    const unsigned fine = fine_bits(s, t, u, zeros);
    const int32_t s_fine = glint_shift_right(s, 12 - fine), t_fine = glint_shift_right(t, 12 - fine),
                  u_fine = glint_shift_right(u, 12 - fine);
    const int32_t u1 = glint_shift_right((int32_t)glint_weigh(s_fine, o->x1, u_fine, o->x2) + half, 14),
                  u2 = glint_shift_right((int32_t)glint_weigh(u_fine, o->x1, t_fine, o->x2) + half, 14);
    const int32_t v1 = glint_shift_right((int32_t)glint_weigh(s_fine, o->y1, u_fine, o->y2) + half, 14),
                  v2 = glint_shift_right((int32_t)glint_weigh(u_fine, o->y1, t_fine, o->y2) + half, 14);
    const int32_t xx = (int32_t)glint_weigh(u1, o->x1, u2, o->x2), xy = (int32_t)glint_weigh(u1, o->y1, u2, o->y2),
                  yy = (int32_t)glint_weigh(v1, o->y1, v2, o->y2); /* 2^(30 + fine) */
    s = glint_shift_right(s, 12), t = glint_shift_right(t, 12), u = glint_shift_right(u, 12);
    const int32_t b = of1 + glint_shift_right((int32_t)glint_weigh(s, o->start1, u, o->start2), 13),
                  c = of2 + glint_shift_right((int32_t)glint_weigh(u, o->start1, t, o->start2), 13);
    const uint32_t x = glint_weigh(b, o->x1, c, o->x2), y = glint_weigh(b, o->y1, c, o->y2);
    const uint32_t m = glint_weigh(of1 + b, o->start1, of2 + c, o->start2);
    if (up) {
        q->xx = (uint32_t)glint_shift_right(xx, fine) << 2;
        q->xy = (uint32_t)glint_shift_right(xy, fine) << 3;
        q->yy = (uint32_t)glint_shift_right(yy, fine) << 2;
        q->x = x << 2, q->y = y << 2;
        q->value = value + (m << 1);
    } else {
        q->xx = (uint32_t)glint_shift_right(xx, 2 + fine);
        q->xy = (uint32_t)glint_shift_right(xy, 1 + fine);
        q->yy = (uint32_t)glint_shift_right(yy, 2 + fine);
        q->x = (uint32_t)glint_shift_right((int32_t)x, 2);
        q->y = (uint32_t)glint_shift_right((int32_t)y, 2);
        q->value = value + (uint32_t)glint_shift_right((int32_t)m, 3);
    }
}

/* Returns products of 2^28 in 2^16. */
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

/* Largest square of a difference of normals, 1 = 2^28. */
#define MOST_TURN (1u << 27)

/* Sets N' at a corner. @return N'.N' */
static GLINT_SPECIAL uint32_t set_normal(int32_t n[3], const int16_t *normal, int32_t over_w) {
    const int32_t half = 1 << 15, x = glint_shift_right(normal[0] * over_w + half, 16),
                  y = glint_shift_right(normal[1] * over_w + half, 16),
                  z = glint_shift_right(normal[2] * over_w + half, 16);
    n[0] = x, n[1] = y, n[2] = z;
    return (uint32_t)(x * x + y * y + z * z);
}

/* Sets N' at corners, and N'.N'. @return 0 where normals turn too far, or 1/w changes too much */
int glint_begin_sun_normals(const glint_row_walk *walk, glint_sun_triangle *t) {
    const glint_vertex *a = t->corners[0], *b = t->corners[1], *c = t->corners[2];
    const int32_t wa = a->inverse_w, wb = b->inverse_w, wc = c->inverse_w;
    const uint32_t nearest = (uint32_t)glint_most_of(wa, wb, wc), up = glint_leading_zeros(nearest) - 1;
    /* 2^30 over the nearest, of 15 bits; the top bit is always set */
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
    t->turn = most_of((uint32_t)s, (uint32_t)q, (uint32_t)(s + q - 2 * u));
    t->least = least_of(at_a, at_b, at_c);
    if (t->turn > MOST_TURN || t->least < GLINT_LEAST_NORMAL + t->turn / 2) /* between corners by a third of it less */
        return 0;
    set_quadratic(&t->normal, at_a << 4, to_q16((int32_t)(at_b - at_a) - s), to_q16((int32_t)(at_c - at_a) - q), s, q,
                  u, &walk->slopes, t->zeros, 1);
    return 1;
}

/* The square of a difference of normals is 2/3 or more of that of their angle where N' are no shorter. */
#define LEAST_TURNED (9u << 24)

/*
 * Do all fragments lie outside the highlight, given the least of what corners are outside by? A point of a triangle is
 * nearer to some corner than 3^-1/2 of the longest side; so are its normal and half vector.
 */
static inline int is_gloss_outside(const glint_suns *suns, uint32_t turn, uint32_t bend, uint32_t outside) {
    const uint32_t large = turn > bend ? turn : bend,
                   both = large + large / 2 + 3 * (turn + bend - large); /* (a + b)^2 <= 3/2 a^2 + 3 b^2 */
    return outside > suns->far + ((both >> 12) * suns->far_turned >> 10);
}

/* Products of differences of H or V, from the first corner. */
typedef struct bends {
    int32_t square1, square2, both;
} bends;

static inline void add_bends(bends *of, int32_t a, int32_t b, int32_t c) {
    const int32_t e1 = b - a, e2 = c - a;
    of->square1 += e1 * e1;
    of->square2 += e2 * e2;
    of->both += e1 * e2;
}

/* Finds the bends of a light's terms. @return the largest square of a difference */
static GLINT_INLINE uint32_t find_bends(bends *of, const glint_sun_term *a, const glint_sun_term *b,
                                        const glint_sun_term *c) {
    *of = (bends){0, 0, 0};
    add_bends(of, a->v[0], b->v[0], c->v[0]);
    add_bends(of, a->v[1], b->v[1], c->v[1]);
    add_bends(of, a->v[2], b->v[2], c->v[2]);
    return most_of((uint32_t)of->square1, (uint32_t)of->square2, (uint32_t)(of->square1 + of->square2 - 2 * of->both));
}

/* Products of differences of N' and those of H or V. */
typedef struct turns {
    int32_t s, q, u;
} turns;

static inline void add_turns(turns *of, int32_t x1, int32_t x2, int32_t a, int32_t b, int32_t c) {
    const int32_t e1 = b - a, e2 = c - a;
    of->s += x1 * e1;
    of->q += x2 * e2;
    of->u += x1 * e2 + x2 * e1;
}

/*
 * Returns what linear vectors lack of unit ones along another vector, whose products with them at corners are given,
 * 1 = 2^14: along each side half of the square of its bend, times the mean of both ends. Times 2^28.
 */
static inline turns weigh_bends(const bends *of, int32_t a, int32_t b, int32_t c) {
    const int32_t across = of->square1 + of->square2 - 2 * of->both;
    const int32_t s = glint_shift_right(of->square1, 14) * glint_shift_right(a + b, 1),
                  q = glint_shift_right(of->square2, 14) * glint_shift_right(a + c, 1),
                  r = glint_shift_right(across, 14) * glint_shift_right(b + c, 1);
    return (turns){glint_shift_right(s, 1), glint_shift_right(q, 1), glint_shift_right(s + q - r, 1)};
}

/* Returns a.b, 1 = 2^28, where b, 1 = 2^14, is to be unit: rounding makes it up to 2^-14 longer or shorter. */
static inline int32_t along_unit(const int32_t a[3], const int16_t b[3]) {
    const int32_t dot = dot16(a, b), lacking = (1 << 28) - b[0] * b[0] - b[1] * b[1] - b[2] * b[2];
    return dot + glint_shift_right(glint_shift_right(dot, 14) * lacking, 15);
}

/*
 * Sets whether a highlight may be visible, given N'.H at corners, some of them below 0: not where all are. @return 0
 * where the one around -H would show, which sin^2 does not tell from that around H
 */
static int is_told(const glint_sun_triangle *t, glint_lit_sun *lit, int32_t a, int32_t b, int32_t c) {
    const int32_t least = glint_shift_right(glint_least_of(a, b, c), 14);
    lit->gloss = glint_most_of(a, b, c) > 0;
    return !lit->gloss || (uint32_t)(least * least) <= (t->least >> 14) * (((1u << 30) - t->suns->end) >> 16);
}

/* Sets N'.H, H being unit between corners: less half of N'.H times the squares of its differences. @return 0 where it
 * does not fit */
static GLINT_NOINLINE int set_half(const glint_row_walk *walk, const glint_sun_triangle *t, const bends *bent, turns of,
                                   const int16_t *a, const int16_t *b, const int16_t *c, glint_lit_sun *lit) {
    const int32_t at_a = along_unit(t->n[0], a), at_b = along_unit(t->n[1], b), at_c = along_unit(t->n[2], c);
    const turns lacking =
        weigh_bends(bent, glint_shift_right(at_a, 14), glint_shift_right(at_b, 14), glint_shift_right(at_c, 14));
    add_turns(&of, t->d1[0], t->d2[0], a[0], b[0], c[0]);
    add_turns(&of, t->d1[1], t->d2[1], a[1], b[1], c[1]);
    add_turns(&of, t->d1[2], t->d2[2], a[2], b[2], c[2]);
    of.s -= lacking.s, of.q -= lacking.q, of.u -= lacking.u;
    set_quadratic(&lit->half, (uint32_t)at_a + (1 << 11), to_q16(at_b - at_a - of.s), to_q16(at_c - at_a - of.q), of.s,
                  of.q, glint_shift_right(of.u, 1), &walk->slopes, t->zeros, 0);
    return (at_a | at_b | at_c) >= 0 || t->suns->is_mirror || is_told(t, lit, at_a, at_b, at_c);
}

/* Returns (1 + L.V) / 2, 1 = 2^28: two steps of a fragment's at least, so that rounding makes none of them negative. */
static inline int32_t find_along(const glint_drawn_sun *sun, const int16_t v[3]) {
    return glint_most((1 << 27) + glint_shift_right(dot16(sun->light, v), 2), 1 << 13);
}

/* Returns L.V, 1 = 2^14, given (1 + L.V) / 2. */
static inline int32_t find_cosine(int32_t along) {
    return glint_shift_right(along, 13) - (1 << 14);
}

/* Returns what V, between corners of which one is farther from the eye, is nearer to that one by; times 2^28. */
static inline turns lean(int32_t k1, int32_t k2, int32_t change1, int32_t change2) {
    change1 = glint_shift_right(change1, 14);
    change2 = glint_shift_right(change2, 14);
    return (turns){-k1 * change1, -k2 * change2, -k1 * change2 - k2 * change1};
}

/*
 * Sets N'.V and (1 + L.V) / 2. What is linear on the screen is V over its z: unit V of corners count by 1 / z, which
 * adds to what is of second order.
 */
static GLINT_NOINLINE void begin_mirror(const glint_row_walk *walk, const glint_sun_triangle *t, const bends *bent,
                                        const int16_t *a, const int16_t *b, const int16_t *c, glint_lit_sun *lit) {
    const int32_t at_a = find_along(lit->sun, a), at_b = find_along(lit->sun, b), at_c = find_along(lit->sun, c),
                  k1 = (a[2] - b[2]) * (1 << 14) / b[2], k2 = (a[2] - c[2]) * (1 << 14) / c[2],
                  first = dot16(t->n[0], a);
    (void)set_half(walk, t, bent, lean(k1, k2, dot16(t->n[0], b) - first, dot16(t->n[0], c) - first), a, b, c, lit);
    const turns of = lean(k1, k2, at_b - at_a, at_c - at_a),
                lacking = weigh_bends(bent, find_cosine(at_a), find_cosine(at_b), find_cosine(at_c));
    const int32_t s = glint_shift_right(of.s - glint_shift_right(lacking.s, 1), 12),
                  q = glint_shift_right(of.q - glint_shift_right(lacking.q, 1), 12),
                  u = glint_shift_right(of.u - glint_shift_right(lacking.u, 1), 13);
    set_quadratic(&lit->along, (uint32_t)at_a + (1 << 11), to_q16(at_b - at_a) - s, to_q16(at_c - at_a) - q,
                  glint_shift_left(s, 12), glint_shift_left(q, 12), glint_shift_left(u, 12), &walk->slopes, t->zeros,
                  0);
}

/* Sets the highlight of a light, given its terms at corners. @return 0 where it does not fit */
static inline int begin_gloss(const glint_row_walk *walk, const glint_sun_triangle *t, glint_lit_sun *lit,
                              const glint_sun_term *a, const glint_sun_term *b, const glint_sun_term *c) {
    const glint_suns *suns = t->suns;
    bends of;
    const uint32_t bend = find_bends(&of, a, b, c);
    if (t->least >= LEAST_TURNED && is_gloss_outside(suns, t->turn, bend, least_of(a->outside, b->outside, c->outside)))
        return 1;
    if (bend > suns->bend || !(a->v[0] | a->v[1] | a->v[2]) || !suns->bend)
        return 0;
    lit->gloss = 1;
    if (!suns->is_mirror)
        return set_half(walk, t, &of, (turns){0, 0, 0}, a->v, b->v, c->v, lit);
    begin_mirror(walk, t, &of, a->v, b->v, c->v, lit);
    return 1;
}

/* Sets a light. @return 0 where the triangle does not fit; without effect where no corner faces the light */
static GLINT_NOINLINE int begin_sun(const glint_row_walk *walk, glint_sun_triangle *t, const glint_drawn_sun *sun,
                                    const glint_sun_term *at_a, const glint_sun_term *at_b,
                                    const glint_sun_term *at_c) {
    glint_lit_sun *lit = &t->lit[t->count];
    const glint_slopes *o = &walk->slopes;
    const int32_t gate = t->suns->gate, a = glint_dot32(t->n[0], sun->light), d1 = glint_dot32(t->d1, sun->light),
                  d2 = glint_dot32(t->d2, sun->light);
    if (a <= gate && a + d1 <= gate && a + d2 <= gate)
        return 1;
    const int32_t l1 = glint_shift_right(d1 + (1 << 12), 13), l2 = glint_shift_right(d2 + (1 << 12), 13);
    t->count++;
    lit->sun = sun;
    lit->gloss = 0;
    lit->is_plain = t->suns->is_plain && (!gate || (a > 0 && a + d1 > 0 && a + d2 > 0));
    lit->light.x = (uint32_t)glint_shift_right((int32_t)glint_weigh(l1, o->x1, l2, o->x2), 1);
    lit->light.y = (uint32_t)glint_shift_right((int32_t)glint_weigh(l1, o->y1, l2, o->y2), 1);
    lit->light.value = (uint32_t)a + (uint32_t)glint_shift_right((int32_t)glint_weigh(l1, o->start1, l2, o->start2), 1);
    return !sun->shines || begin_gloss(walk, t, lit, at_a, at_b, at_c);
}

/* Sets all lights. */
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

/* Is a triangle's highlight of a light out of sight, its normals being one? */
static int is_matt(const glint_row_walk *walk, const glint_suns *suns, size_t term) {
    const glint_draw *draw = walk->draw;
    const glint_sun_term *at[3];
    bends of;
    for (int k = 0; k < 3; k++)
        at[k] = draw->terms + (size_t)(walk->triangle.corners[k] - draw->vertices) * suns->terms + term;
    const uint32_t bend = find_bends(&of, at[0], at[1], at[2]);
    return is_gloss_outside(suns, 0, bend, least_of(at[0]->outside, at[1]->outside, at[2]->outside));
}

/* Of one normal, N.L is one number, and it alone tells the colour where no highlight is visible. */
GLINT_NOINLINE int glint_find_one_word(const glint_row_walk *walk, uint32_t *word) {
    const glint_suns *suns = walk->draw->shading->suns;
    const int16_t *n = walk->triangle.corners[0]->attribute;
    glint_spread p = {0, suns->first, 0, 1u << 14};
    size_t term = 0;
    for (const glint_drawn_sun *sun = suns->suns, *end = sun + suns->count; sun != end; sun++) {
        const int32_t along = dot16(sun->light, n), light = walk->triangle.back ? -along : along;
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
