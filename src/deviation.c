/* SPDX-License-Identifier: MIT */
/*
 * Fast lighting of fragments under one directional light: vertices and triangles.
 *
 * With unit normal N and half vector H, k = (N.H + nz) / (1 + hz) and e = (nx - hx k, ny - hy k) are the coordinates of
 * N in the plane across H, turned so that H points along z: |e|^2 = sin^2 of the angle between them. Over a small
 * triangle e and N.L are linear; the half vector is found at vertices only.
 */
#include "deviation.h"
#include "light.h"
#include "setup.h"

/* N.L, Q14, that is above 0 at every pixel: planes are off by at most 2^-7 of their corners' difference. */
#define LIT 150

/* N.L, Q14, at which rounding cannot light what faces away. */
#define UNLIT (-8)

/* ---- Vertices ---- */

int glint_deviation_half_vector(const glint_deviation *deviation, int32_t x, int32_t y, int16_t half_vector[3],
                                glint_view_vector *view) {
    return glint_half_vector_inline(deviation, x, y, half_vector, view);
}

/* N.L, N.H of unit vectors in steps of UNIT: products are short of 2^30 by a part in 2^12. */
static int32_t cosine_of(const int16_t a[3], const int16_t b[3]) {
    int32_t cosine = glint_dot(a, b);
    return glint_shift_right(cosine + glint_shift_right(cosine, 13) + 0x4000, 15);
}

/* A deviation, Q14. */
typedef struct offset {
    int32_t x, y;
} offset;

/* e. Where N.H < 0, |e| falls again: there it is stretched, so that the back of H stays outside the highlight. */
static inline offset find_deviation(const int16_t n[3], const int16_t h[3]) {
    const int32_t cosine = cosine_of(n, h);
    const int32_t k = glint_shift_right((cosine + n[2]) * glint_inverse_of_one_and(h[2]), 16); /* Q14 */
    offset e = {glint_shift_right(n[0] * (1 << 14) - h[0] * k + 0x4000, 15),
                glint_shift_right(n[1] * (1 << 14) - h[1] * k + 0x4000, 15)};
    if (cosine < 0) {
        e.x += glint_shift_right(e.x * -cosine, 14);
        e.y += glint_shift_right(e.y * -cosine, 14);
    }
    if (cosine < -GLINT_UNIT / 2)
        e.x = INT16_MAX;
    return e;
}

/* A deviation on the scale of planes, cut off where it is beyond their reach, which sets flags. */
static inline int16_t scale_deviation(const glint_deviation *deviation, int32_t e, uint32_t *flags) {
    const int32_t reach = deviation->reach;
    if (e > reach || e < -reach) {
        *flags |= GLINT_TERMS_FAR;
        e = e > 0 ? reach : -reach;
    }
    return (int16_t)glint_shift_right(e * deviation->scale + (1 << 15), 16);
}

/* The sides of the octagon around the highlight that a deviation lies beyond. */
static uint32_t find_sides(const glint_deviation *deviation, int32_t x, int32_t y) {
    const int32_t cut = deviation->side, diagonal = deviation->side_diagonal;
    uint32_t flags = 0;
    if (x >= cut)
        flags |= GLINT_TERMS_OUTSIDE;
    if (x <= -cut)
        flags |= GLINT_TERMS_OUTSIDE << 1;
    if (y >= cut)
        flags |= GLINT_TERMS_OUTSIDE << 2;
    if (y <= -cut)
        flags |= GLINT_TERMS_OUTSIDE << 3;
    if (x + y >= diagonal)
        flags |= GLINT_TERMS_OUTSIDE << 4;
    if (x + y <= -diagonal)
        flags |= GLINT_TERMS_OUTSIDE << 5;
    if (x - y >= diagonal)
        flags |= GLINT_TERMS_OUTSIDE << 6;
    if (x - y <= -diagonal)
        flags |= GLINT_TERMS_OUTSIDE << 7;
    return flags;
}

/* Finds a vertex's terms: N.L, Q14, and its scaled deviation. @return flags */
static uint32_t light_vertex(const glint_deviation *deviation, const glint_vertex *vertex, int16_t terms[3]) {
    int16_t found[3];
    glint_view_vector view;
    const int16_t *half_vector = deviation->half_vector;
    const int32_t cosine = glint_shift_right(cosine_of(vertex->attribute, deviation->light) + 1, 1);
    uint32_t flags = cosine >= LIT ? 0 : cosine > UNLIT ? GLINT_TERMS_DIM : GLINT_TERMS_DIM | GLINT_TERMS_DARK;
    terms[0] = (int16_t)(cosine > GLINT_UNIT / 2 ? GLINT_UNIT / 2 : cosine);
    if (!deviation->specular_end) {
        terms[1] = 0;
        terms[2] = 0;
        return flags | GLINT_TERMS_ANY_OUTSIDE;
    }
    if (deviation->local_viewer) {
        half_vector = found;
        if (!glint_half_vector_inline(deviation, vertex->x, vertex->y, found, &view))
            return GLINT_TERMS_UNFIT;
    }
    const offset e = find_deviation(vertex->attribute, half_vector);
    terms[1] = scale_deviation(deviation, e.x, &flags);
    terms[2] = scale_deviation(deviation, e.y, &flags);
    return flags | find_sides(deviation, terms[1], terms[2]);
}

void glint_deviation_light(const glint_frame *frame, glint_draw *draw, const glint_transform *transform, uint32_t i) {
    (void)frame;
    (void)transform;
    for (int corner = 0; corner < 3; corner++) {
        const uint32_t index = draw->triangles[i][corner];
        glint_vertex *vertex = &draw->vertices[index];
        if (vertex->flags & (GLINT_VERTEX_CLIP | GLINT_VERTEX_LIT))
            continue;
        const uint32_t flags = light_vertex(draw->shading->deviation, vertex, draw->terms[index]);
        vertex->flags = (uint16_t)(vertex->flags | GLINT_VERTEX_LIT | flags);
    }
}

/* ---- Triangles ---- */

static inline int32_t square_of_sum(int32_t a, int32_t b, int32_t c) {
    const int32_t sum = glint_shift_right(a + b + c, 2);
    return sum * sum;
}

/* Sum of the squares of the normals' differences, Q26: 9 less the square of their sum. */
static inline int32_t turn_of(const glint_vertex *const v[3]) {
    const int16_t *a = v[0]->attribute, *b = v[1]->attribute, *c = v[2]->attribute;
    return 9 * (GLINT_UNIT / 4 * (GLINT_UNIT / 4)) - square_of_sum(a[0], b[0], c[0]) - square_of_sum(a[1], b[1], c[1]) -
           square_of_sum(a[2], b[2], c[2]);
}

/* How 1/w changes across a triangle, Q16. */
typedef struct w_range {
    uint32_t least, change;
} w_range;

static w_range find_w_range(const glint_vertex *const v[3]) {
    const int32_t a = v[0]->inverse_w, b = v[1]->inverse_w, c = v[2]->inverse_w;
    const uint32_t low = (uint32_t)glint_least_of(a, b, c) >> 15, high = (uint32_t)glint_most_of(a, b, c) >> 15;
    return (w_range){low, high - low + 1};
}

/* Is the error of linear lighting small: `turn`, of the normal, Q26, and the change of 1/w across the triangle? */
static int fits(int32_t limit, int32_t turn, w_range w) {
    if (turn > limit || w.change > w.least >> 2)
        return 0;
    return (w.change * w.change >> 2) <= (uint32_t)((limit - turn) >> 16) * (w.least * w.least >> 16);
}

/* x 2^n modulo 2^32, rounded down; |n| below 32. */
static inline int32_t scale(int32_t x, int32_t n) {
    return n < 0 ? glint_shift_right(x, (unsigned)-n) : glint_shift_left(x, (unsigned)n);
}

/* Half of what chords fall short by, of 2^15: turn / 32. */
static inline int32_t find_longer(int32_t turn) {
    return glint_shift_right(turn > 0 ? turn : 0, 16);
}

/* The plane of a term, its value in the high half; it is made longer. */
static inline void begin_term(glint_plane *p, const glint_gradients *g, int32_t longer, int32_t a0, int32_t a1,
                              int32_t a2) {
    const int32_t length = (1 << 16) + 2 * longer, d1 = a1 - a0, d2 = a2 - a0, up = 16 - g->shift;
    if (!g->reciprocal) {
        glint_plane_begin(p, g, a0 * length, a1 * length, a2 * length);
        return;
    }
    int32_t reciprocal = g->reciprocal + glint_shift_right(g->reciprocal * longer, 15);
    GLINT_OPAQUE(reciprocal); /* of 32 bits to all slopes */
    const int32_t dx = glint_slope_of(d1 * g->x1 + d2 * g->x2, reciprocal);
    const int32_t dy = glint_slope_of(d1 * g->y1 + d2 * g->y2, reciprocal);
    const int32_t to_center = glint_shift_right(dx, 5) * g->to_center_x + glint_shift_right(dy, 5) * g->to_center_y;
    p->dx = scale(dx, up);
    p->dy = scale(dy, up);
    p->start = glint_add_wrap(a0 * length, scale(to_center, up + 1));
}

static inline int32_t magnitude(int32_t x) {
    return x < 0 ? -x : x;
}

/* From the least to the most of three numbers: half the sum of their differences. */
static inline int32_t apart(int32_t a, int32_t b, int32_t c) {
    return (magnitude(b - a) + magnitude(c - a) + magnitude(c - b)) / 2;
}

/* Across the screen, as |dx| + |dy|. */
static int32_t extent_of(const glint_vertex *const v[3]) {
    return apart(v[0]->x, v[1]->x, v[2]->x) + apart(v[0]->y, v[1]->y, v[2]->y);
}

/* Planes of a triangle that is lit all over and may show a highlight. */
static GLINT_NOINLINE glint_deviation_kind begin_highlight(const glint_draw *draw, const glint_vertex *const v[3],
                                                           const glint_gradients *g, int32_t turn, const w_range *w,
                                                           glint_deviation_planes *planes) {
    const glint_deviation *deviation = draw->shading->deviation;
    const int16_t *a = glint_terms_of(draw, v[0]), *b = glint_terms_of(draw, v[1]), *c = glint_terms_of(draw, v[2]);
    if (4 * (int32_t)g->reach + 4 > deviation->extent && extent_of(v) > deviation->extent)
        return GLINT_DEVIATION_UNFIT;
    const int32_t change = apart(a[1], b[1], c[1]) + apart(a[2], b[2], c[2]);
    if ((uint32_t)change * w->change > deviation->slant * w->least)
        return GLINT_DEVIATION_UNFIT;
    const int32_t longer = find_longer(turn);
    begin_term(&planes->cosine, g, longer, a[0], b[0], c[0]);
    begin_term(&planes->x, g, longer, a[1], b[1], c[1]);
    begin_term(&planes->y, g, longer, a[2], b[2], c[2]);
    return GLINT_DEVIATION_SPECULAR;
}

/* Is N.L, or near enough, that of the first corner? */
static int is_even(int32_t even, int32_t a, int32_t b, int32_t c) {
    const int32_t most = a + even;
    return (uint32_t)(most - b) <= (uint32_t)(2 * even) && (uint32_t)(most - c) <= (uint32_t)(2 * even);
}

uint32_t glint_deviation_even(const glint_shading *shading, const glint_deviation_planes *planes) {
    const int32_t cosine = planes->cosine.start;
    if (!shading->lights || cosine <= 0)
        return shading->deviation->ambient;
    return shading->deviation->diffuse ? shading->deviation->diffuse_pixel[cosine >> 22]
                                       : glint_deviation_pixel(shading, cosine, UINT32_MAX);
}

uint32_t glint_deviation_covered(const glint_part *part) {
    uint32_t covered = 0;
    for (uint32_t row = part->top; row < part->bottom; row++)
        covered += (uint32_t)part->spans[row].right - part->spans[row].left;
    return covered;
}

glint_deviation_kind glint_deviation_begin(const glint_draw *draw, const glint_triangle *triangle,
                                           const glint_part *part, glint_deviation_planes *planes) {
    const glint_deviation *deviation = draw->shading->deviation;
    const glint_vertex *const *v = triangle->corners;
    const uint32_t all = v[0]->flags & v[1]->flags & v[2]->flags, any = v[0]->flags | v[1]->flags | v[2]->flags;
    /* corners made by clipping are not lit */
    if (!(all & GLINT_VERTEX_LIT) || any & GLINT_TERMS_UNFIT || triangle->back)
        return GLINT_DEVIATION_UNFIT;
    if (all & GLINT_TERMS_DARK)
        return GLINT_DEVIATION_AMBIENT;
    const int shows = !(all & GLINT_TERMS_ANY_OUTSIDE);
    const int32_t turn = turn_of(v);
    const w_range w = find_w_range(v);
    if (!fits(shows ? deviation->turn_specular : deviation->turn, turn, w))
        return GLINT_DEVIATION_UNFIT;
    if (shows)
        return any & (GLINT_TERMS_DIM | GLINT_TERMS_FAR) ? GLINT_DEVIATION_UNFIT
                                                         : begin_highlight(draw, v, &part->gradients, turn, &w, planes);
    const int32_t longer = find_longer(turn);
    const int32_t a = *glint_terms_of(draw, v[0]), b = *glint_terms_of(draw, v[1]), c = *glint_terms_of(draw, v[2]);
    if (deviation->even && is_even(deviation->even, a, b, c)) {
        planes->cosine.start = a * ((1 << 16) + 2 * longer);
        return GLINT_DEVIATION_EVEN;
    }
    begin_term(&planes->cosine, &part->gradients, longer, a, b, c);
    return any & GLINT_TERMS_DIM ? GLINT_DEVIATION_GATED : GLINT_DEVIATION_DIFFUSE;
}
