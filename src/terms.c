/* SPDX-License-Identifier: MIT */
/* Terms of a triangle: which lights shine on it, whether polynomials fit, and the polynomials. */
#include "terms.h"

#include "deviation.h"
#include "division.h"
#include "setup.h"

#ifndef REJECT
#define REJECT(n) 0
#endif

/* ---- Vertices ---- */

/*
 * What a vertex keeps: its sum; the lights it faces and does not; those whose deviation is cut off or unknown; what
 * light there is, and how close; and of each light with a lobe a deviation, and its strength where that varies.
 */
enum { FACING, FLAGS, LEVELS, CLOSENESS };

static void keep(const glint_frame *frame, const glint_light_terms *light, const glint_node *node, int16_t *to) {
    int16_t *const rest = to + light->channels;
    for (uint32_t c = 0; c < light->channels; c++)
        to[c] = (int16_t)node->sum[c];
    rest[FACING] = (int16_t)(uint16_t)(node->lit | node->dark << 8);
    rest[FLAGS] = (int16_t)(uint16_t)(node->far | node->unfit << 8);
    rest[LEVELS] = (int16_t)glint_least((int32_t)node->levels, INT16_MAX);
    rest[CLOSENESS] = (int16_t)glint_least((int32_t)node->closeness, INT16_MAX);
    for (uint32_t i = 0; light->lobes >> i; i++)
        if (light->lobes >> i & 1) {
            int16_t *const lobe = to + light->lobe_at[i];
            lobe[0] = node->lobe[i][0];
            lobe[1] = node->lobe[i][1];
            if (frame->view->lights[i].type->illuminate)
                lobe[2] = node->lobe[i][2];
        }
}

/* Ray towards the eye from a point of the screen, 28.4. */
static void find_ray(const glint_frame *frame, int32_t x, int32_t y, int32_t ray[3]) {
    ray[0] = frame->config.width * 4096 - x * 512;
    ray[1] = y * 512 - frame->config.height * 4096;
    ray[2] = frame->view->focal;
}

static void gather_corner(const glint_frame *frame, const glint_vertex *v, glint_fragments *to) {
    const uint32_t i = to->count++;
    find_ray(frame, v->x, v->y, to->ray[i]);
    to->inverse_w[i] = v->inverse_w;
    for (int c = 0; c < 3; c++)
        to->normal[i][c] = v->attribute[c];
}

void glint_terms_light(const glint_frame *frame, glint_draw *draw, const glint_transform *transform,
                       uint32_t triangle) {
    const glint_light_terms *light = &draw->shading->terms;
    uint32_t index[3];
    glint_fragments vertices;
    glint_node nodes[3];
    (void)transform;
    vertices.count = 0;
    for (int corner = 0; corner < 3; corner++) {
        const uint32_t here = draw->triangles[triangle][corner];
        glint_vertex *vertex = &draw->vertices[here];
        if (vertex->flags & GLINT_VERTEX_NORMAL)
            continue;
        glint_transform_normal(draw, vertex);
        if (vertex->flags & GLINT_VERTEX_CLIP)
            continue;
        vertex->flags |= GLINT_VERTEX_LIT;
        index[vertices.count] = here;
        gather_corner(frame, vertex, &vertices);
    }
    if (!vertices.count)
        return;
    glint_nodes_light(frame, draw->shading, &vertices, GLINT_ALL_LIT, draw->shading->lights, light->lobes, nodes);
    for (uint32_t i = 0; i < vertices.count; i++)
        keep(frame, light, &nodes[i], draw->nodes + index[i] * light->stride);
}

/* ---- How far polynomials are off ---- */

/* A triangle; angles Q12. */
typedef struct measures {
    uint32_t turn;   /* of the normals, from corner to corner at most */
    uint32_t reach;  /* how far the corners lie apart, over their depth */
    uint32_t slant;  /* the change of 1/w, times 1.85 */
    uint32_t near;   /* how far they lie apart, over the distance to a light */
    uint32_t levels; /* what light makes, Q4 */
} measures;

/* sqrt(x), Q24 to Q12. */
static uint32_t root_of(uint32_t x) {
    if (!x)
        return 0;
    const unsigned up = glint_leading_zeros(x) & ~1u; /* to 2^30 .. 2^32 */
    const uint32_t root = (uint32_t)glint_inverse_root(x << up >> 1) * 46341 >> 16;
    return ((x << up >> 16) * root >> 14 >> up / 2) + 1;
}

static int32_t square_of_difference(const int16_t a[3], const int16_t b[3]) {
    const int32_t x = glint_shift_right(a[0] - b[0], 2), y = glint_shift_right(a[1] - b[1], 2),
                  z = glint_shift_right(a[2] - b[2], 2);
    return x * x + y * y + z * z; /* Q26, below 2^29 */
}

/* Longer than the hypotenuse of two sides, by at most 12 %. */
static uint32_t hypotenuse(uint32_t a, uint32_t b) {
    return a > b ? a + b / 2 : b + a / 2;
}

static void measure(const glint_view *view, const glint_triangle *triangle, measures *m) {
    const glint_vertex *const *v = triangle->corners;
    const int16_t *a = v[0]->attribute, *b = v[1]->attribute, *c = v[2]->attribute;
    const int32_t turn =
        glint_most_of(square_of_difference(a, b), square_of_difference(b, c), square_of_difference(c, a));
    const int32_t width = glint_most_of(v[0]->x, v[1]->x, v[2]->x) - glint_least_of(v[0]->x, v[1]->x, v[2]->x);
    const int32_t height = glint_most_of(v[0]->y, v[1]->y, v[2]->y) - glint_least_of(v[0]->y, v[1]->y, v[2]->y);
    const glint_w_range w = glint_find_w_range(v);
    const uint32_t across =
        (uint32_t)((uint64_t)hypotenuse((uint32_t)width, (uint32_t)height) * (uint32_t)view->pixel >> 18);
    const uint32_t slant = w.least > w.change >> 2 ? (w.change << 12) / w.least : 1 << 14;
    m->turn = root_of((uint32_t)turn >> 2);
    m->slant = slant * 474 >> 8;
    m->reach = hypotenuse(across, slant);
}

/* Products of angles, Q12; saturated. */
static inline uint32_t times(uint32_t a, uint32_t b) {
    const uint64_t product = (uint64_t)a * b >> 12;
    return product > 1 << 20 ? 1 << 20 : (uint32_t)product;
}

/* Quadratics err by 0.0275 a (a + b)^2 where the light turns by a, and 1/w changes by b: levels Q4 to Q8. */
static uint32_t sum_error(uint32_t levels, uint32_t a, uint32_t b) {
    return (uint32_t)((uint64_t)times(times(a, a + b), a + b) * levels * 1802 >> 24); /* 0.0275 is 1802 2^-16 */
}

/*
 * Planes err by a^2 / 8 + a b / 4 where light turns by a; chords between unit vectors made longer by half of what they
 * fall short by do so by half of that: levels Q4 to Q8.
 */
static uint32_t plane_sum_error(uint32_t levels, uint32_t turn, uint32_t place, uint32_t b) {
    const uint32_t a = turn + place;
    return (uint32_t)((uint64_t)(2 * times(a, a) - times(turn, turn) + 4 * times(a, b)) * levels >> 12);
}

/* A highlight's: |e| falls short as N does, and H turns. */
static uint32_t plane_lobe_error(const glint_light_terms *light, uint32_t levels, uint32_t turn, uint32_t axis,
                                 uint32_t b) {
    const uint64_t of_axis =
        (uint64_t)(2 * times(axis, axis) + 4 * times(turn, axis) + 4 * times(turn + axis, b)) * light->slope >> 8;
    return (uint32_t)((of_axis + times(turn, turn)) * levels >> 16);
}

/* A highlight's by 0.041 s h (h + b)^2, s the highlight's slope over its deviation, and as a sum for its strength. */
static uint32_t lobe_error(const glint_light_terms *light, uint32_t levels, uint32_t h, uint32_t f, uint32_t b) {
    const uint64_t of_place = (uint64_t)times(times(h, h + b), h + b) * light->slope >> 8;
    return (uint32_t)((of_place * 2687 + (uint64_t)times(times(f, f + b), f + b) * 1802) * levels >> 28);
}

/* Are all three corners beyond one side of the octagon around a highlight? */
static int is_outside(const glint_light_terms *light, const int16_t *const lobe[3]) {
    const int32_t cut = light->lobe_cut + (light->lobe_cut >> 4),
                  diagonal = light->lobe_diagonal + (light->lobe_diagonal >> 4);
    const int32_t x0 = lobe[0][0], x1 = lobe[1][0], x2 = lobe[2][0], y0 = lobe[0][1], y1 = lobe[1][1], y2 = lobe[2][1];
    return glint_least_of(x0, x1, x2) >= cut || glint_most_of(x0, x1, x2) <= -cut ||
           glint_least_of(y0, y1, y2) >= cut || glint_most_of(y0, y1, y2) <= -cut ||
           glint_least_of(x0 + y0, x1 + y1, x2 + y2) >= diagonal ||
           glint_most_of(x0 + y0, x1 + y1, x2 + y2) <= -diagonal ||
           glint_least_of(x0 - y0, x1 - y1, x2 - y2) >= diagonal ||
           glint_most_of(x0 - y0, x1 - y1, x2 - y2) <= -diagonal;
}

/* ---- Nodes ---- */

/* The middle of an edge, as a fragment. */
static void gather_middle(const glint_frame *frame, const glint_vertex *a, const glint_vertex *b, glint_fragments *to) {
    const uint32_t i = to->count++;
    const unsigned zeros = glint_leading_zeros((uint32_t)a->inverse_w | (uint32_t)b->inverse_w);
    const int32_t wa = (int32_t)((uint32_t)a->inverse_w << zeros >> 17),
                  wb = (int32_t)((uint32_t)b->inverse_w << zeros >> 17);
    find_ray(frame, (a->x + b->x) >> 1, (a->y + b->y) >> 1, to->ray[i]);
    to->inverse_w[i] = (a->inverse_w >> 1) + (b->inverse_w >> 1);
    glint_unit_each(a->attribute[0] * wa + b->attribute[0] * wb, a->attribute[1] * wa + b->attribute[1] * wb,
                    a->attribute[2] * wa + b->attribute[2] * wb, to->normal[i]);
}

/* M at a node, N/w with the largest corner's 1/w as 1: its square and its length, Q15. */
typedef struct lengths {
    int32_t square[6], length[6];
} lengths;

/* sqrt(x), Q15, x from 2^13 to 2^15. */
static int32_t root_of15(uint32_t x) {
    const unsigned up = (glint_leading_zeros(x) - 3) | 1;
    const uint32_t wide = x << up; /* 2^28 .. 2^30 */
    const uint32_t inverse = (uint32_t)glint_inverse_root(wide);
    const uint32_t root = (wide >> 14) * (inverse + (inverse >> 13)) >> 16;
    return (int32_t)(root << 1 >> (up - 13) / 2);
}

/* M.M between the nodes is no less than 1/4 where they have this, Q15. */
#define LEAST_SQUARE 12000

/*
 * Lengths at the corners, whose 1/w is w, Q15, and at the middles of the edges, where
 * M.M = ((wa + wb) / 2)^2 - wa wb |Na - Nb|^2 / 4. @return 0 where one is too small
 */
static int find_lengths(const glint_triangle *triangle, lengths *of) {
    const glint_vertex *const *v = triangle->corners;
    uint32_t w[3];
    const uint32_t largest = (uint32_t)glint_most_of(v[0]->inverse_w, v[1]->inverse_w, v[2]->inverse_w);
    const unsigned zeros = glint_leading_zeros(largest);
    const uint32_t reciprocal = (uint32_t)glint_reciprocal16(largest << zeros >> 16) - 1; /* 2^31 over 16 bits */
    for (int i = 0; i < 3; i++) {
        w[i] = ((uint32_t)v[i]->inverse_w << zeros >> 16) * reciprocal >> 16;
        of->length[i] = (int32_t)w[i];
        of->square[i] = (int32_t)(w[i] * w[i] >> 15);
    }
    for (int i = 0; i < 3; i++) {
        const int a = i == 1 ? 1 : 0, b = i == 0 ? 1 : 2;
        const int32_t turn = square_of_difference(v[a]->attribute, v[b]->attribute); /* Q26 */
        const int32_t mean = (int32_t)(w[a] + w[b]) >> 1, both = (int32_t)(w[a] * w[b] >> 15);
        const int32_t square = (mean * mean >> 15) - (both * glint_shift_right(turn, 12) >> 16);
        if (square < LEAST_SQUARE || of->square[i] < LEAST_SQUARE)
            return 0;
        of->square[3 + i] = square;
        of->length[3 + i] = root_of15((uint32_t)square);
    }
    return 1;
}

/* ---- Polynomials ---- */

/* Lights of a triangle by what is to be done with them; bit i: light i. */
typedef struct lights {
    uint32_t held, sides, lobes;
} lights;

/* Through a number of the nodes: at the corners, and at the middles of the edges. */
static void begin_polynomial(glint_quadratic *q, const glint_barycentric *s, const int32_t n[6]) {
    const int32_t bulge[3] = {4 * n[3] - 2 * (n[0] + n[1]), 4 * n[4] - 2 * (n[1] + n[2]), 4 * n[5] - 2 * (n[0] + n[2])};
    glint_polynomial_begin(q, s, n, bulge);
}

/* Are all the terms of a triangle three channels? */
static int is_plain(const glint_shading *shading, const lights *of) {
    return !of->sides && !of->lobes && !(shading->material->flags & GLINT_MATERIAL_MAX);
}

/* A number times its node's length, or its square, where there is one. */
static inline int32_t scale_by(const int32_t by[6], int i, int32_t number) {
    return by ? glint_shift_right(number * by[i] + (1 << 14), 15) : number;
}

static void begin_sum(const glint_light_terms *light, const glint_part *part, const glint_barycentric *s,
                      const int32_t sum[3][6], glint_terms *terms) {
    glint_barycentric channel;
    if (light->channels == 1 && !terms->is_channels) {
        begin_polynomial(&terms->sum[0], s, sum[0]);
        terms->sum[0].start += 1 << 15;
        return;
    }
    glint_barycentric_begin(&channel, &part->gradients, 12 + (int32_t)light->sum_bits);
    for (int c = 0; c < 3; c++) {
        begin_polynomial(&terms->sum[c], &channel, sum[c]);
        if (terms->is_channels)
            terms->sum[c].start += (uint32_t)(light->ambient[c] + light->half[c]);
    }
}

/* A channel of a sum as a term of its own, 15 bits less sum_bits: all light together, in levels. */
static inline int32_t channel_of(const glint_light_terms *light, const int16_t *kept, int c) {
    return light->channels == 1 ? glint_shift_right(kept[0] * light->chroma[c] + (1 << 11), 12) : kept[c];
}

/* What triangles have in common on their way to terms. */
typedef struct triangle_nodes {
    const int16_t *kept[3];
    glint_node fresh[6]; /* corners, where they are found anew, and middles */
    int is_fresh;
} triangle_nodes;

static inline int32_t lobe_number(const glint_light_terms *light, const triangle_nodes *t, uint32_t l, int i, int k) {
    return i < 3 && !t->is_fresh ? t->kept[i][light->lobe_at[l] + k] : t->fresh[i].lobe[l][k];
}

static void begin_terms(const glint_frame *frame, const glint_draw *draw, const glint_part *part,
                        const triangle_nodes *t, const lights *of, const lengths *by, glint_terms *terms) {
    const glint_light_terms *light = &draw->shading->terms;
    const int32_t *const length = by ? by->length : 0;
    const int is_mirror = draw->shading->material->model->lobe == GLINT_LOBE_MIRROR;
    const int32_t *const of_lobe = by ? is_mirror ? by->square : by->length : 0;
    glint_barycentric s;
    int32_t n[3][6];
    glint_barycentric_begin(&s, &part->gradients, 16);
    terms->is_channels = (uint8_t)(!by && is_plain(draw->shading, of));
    for (uint32_t c = 0; c < light->channels; c++)
        for (int i = 0; i < 6; i++)
            n[c][i] = scale_by(length, i, i < 3 && !t->is_fresh ? t->kept[i][c] : t->fresh[i].sum[c]);
    if (terms->is_channels && light->channels == 1)
        for (int i = 0; i < 6; i++) {
            const int32_t sum = n[0][i];
            for (int c = 0; c < 3; c++)
                n[c][i] = glint_shift_right(sum * light->chroma[c] + (1 << 11), 12);
        }
    begin_sum(light, part, &s, (const int32_t(*)[6])n, terms);
    terms->is_over_length = (uint8_t)(by ? 1 + is_mirror : 0);
    terms->is_curved = 1;
    if (by) {
        for (int i = 0; i < 6; i++)
            n[0][i] = by->square[i] >> 1;
        begin_polynomial(&terms->square, &s, n[0]);
    }
    terms->side_count = terms->lobe_count = 0;
    for (uint32_t l = 0; of->sides >> l; l++)
        if (of->sides >> l & 1) {
            glint_side *side = &terms->sides[terms->side_count++];
            for (int i = 0; i < 6; i++)
                n[0][i] = scale_by(length, i, t->fresh[i].side[l] >> 1);
            begin_polynomial(&side->cosine, &s, n[0]);
            side->weight = light->diffuse[l];
        }
    for (uint32_t l = 0; of->lobes >> l; l++)
        if (of->lobes >> l & 1) {
            glint_lobe *lobe = &terms->lobes[terms->lobe_count++];
            lobe->is_attenuated = frame->view->lights[l].type->illuminate != 0;
            for (int i = 0; i < 6; i++) {
                n[0][i] = scale_by(of_lobe, i, lobe_number(light, t, l, i, 0));
                n[1][i] = scale_by(of_lobe, i, lobe_number(light, t, l, i, 1));
                n[2][i] = lobe->is_attenuated ? lobe_number(light, t, l, i, 2) >> 1 : 0;
            }
            begin_polynomial(&lobe->x, &s, n[0]);
            begin_polynomial(&lobe->y, &s, n[1]);
            if (lobe->is_attenuated)
                begin_polynomial(&lobe->strength, &s, n[2]);
            lobe->weight = light->specular[l];
        }
}

/* A plane as a polynomial, times 2^unit. */
static void begin_plane(glint_quadratic *q, const glint_gradients *g, int32_t a, int32_t b, int32_t c, unsigned unit) {
    glint_plane plane;
    glint_plane_begin(&plane, g, glint_shift_left(a, unit), glint_shift_left(b, unit), glint_shift_left(c, unit));
    *q = (glint_quadratic){(uint32_t)plane.start, (uint32_t)plane.dx, (uint32_t)plane.dy, 0, 0, 0};
}

/* Planes of what the corners keep. @param longer chords are made longer by this, Q15 */
static void begin_planes(const glint_frame *frame, const glint_draw *draw, const glint_part *part,
                         const triangle_nodes *t, const lights *of, int32_t longer, glint_terms *terms) {
    const glint_light_terms *light = &draw->shading->terms;
    const glint_gradients *g = &part->gradients;
    const int32_t length = (1 << 15) + longer;
    terms->is_over_length = terms->is_curved = 0;
    terms->side_count = terms->lobe_count = 0;
    terms->is_channels = (uint8_t)is_plain(draw->shading, of);
    if (terms->is_channels || light->channels == 3) {
        const unsigned up = 12 + light->sum_bits;
        for (int c = 0; c < 3; c++) {
            int32_t n[3];
            for (int i = 0; i < 3; i++)
                n[i] = channel_of(light, t->kept[i], c) * length >> 15;
            begin_plane(&terms->sum[c], g, n[0], n[1], n[2], up);
            if (terms->is_channels)
                terms->sum[c].start += (uint32_t)(light->ambient[c] + light->half[c]);
        }
    } else {
        begin_plane(&terms->sum[0], g, t->kept[0][0] * length >> 15, t->kept[1][0] * length >> 15,
                    t->kept[2][0] * length >> 15, 16);
        terms->sum[0].start += 1 << 15;
    }
    for (uint32_t l = 0; of->lobes >> l; l++)
        if (of->lobes >> l & 1) {
            glint_lobe *lobe = &terms->lobes[terms->lobe_count++];
            const int16_t *const a = t->kept[0] + light->lobe_at[l], *const b = t->kept[1] + light->lobe_at[l],
                                 *const c = t->kept[2] + light->lobe_at[l];
            lobe->is_attenuated = frame->view->lights[l].type->illuminate != 0;
            begin_plane(&lobe->x, g, a[0] * length >> 15, b[0] * length >> 15, c[0] * length >> 15, 16);
            begin_plane(&lobe->y, g, a[1] * length >> 15, b[1] * length >> 15, c[1] * length >> 15, 16);
            if (lobe->is_attenuated)
                begin_plane(&lobe->strength, g, a[2] >> 1, b[2] >> 1, c[2] >> 1, 16);
            lobe->weight = light->specular[l];
        }
}

/* ---- Triangles ---- */

/* What a corner's cosine differs by at most from what tells clear from not, Q12. */
#define CLEARLY_NEAR 512
#define CLEARLY_INSIDE 64

/* Do polynomials fit the triangle's shape? */
static int is_shapely(const glint_triangle *triangle, const glint_part *part) {
    const glint_vertex *const *v = triangle->corners;
    return v[0]->flags & v[1]->flags & v[2]->flags & GLINT_VERTEX_LIT && !triangle->back &&
           triangle->area >= GLINT_POLYNOMIAL_LEAST_AREA &&
           glint_slenderness(&part->gradients, triangle->area) <= GLINT_POLYNOMIAL_SLENDER && !glint_is_deep(triangle);
}

/* Which lights shine on a triangle, all over or in part. */
static void find_lights(const glint_shading *shading, const triangle_nodes *t, measures *m, lights *of,
                        uint32_t *dark) {
    const uint32_t at = shading->terms.channels;
    const int16_t *a = t->kept[0] + at, *b = t->kept[1] + at, *c = t->kept[2] + at;
    const uint32_t facing = (uint16_t)(a[FACING] & b[FACING] & c[FACING]);
    m->levels = (uint32_t)glint_most_of(a[LEVELS], b[LEVELS], c[LEVELS]);
    m->near = m->reach * (uint32_t)glint_most_of(a[CLOSENESS], b[CLOSENESS], c[CLOSENESS]) >> 8;
    of->held = facing & 0xff;
    *dark = facing >> 8;
    /* between the corners N.L is off by no more than half the product of what N and L turn by */
    of->sides = shading->lights & ~of->held & ~*dark;
}

/* Does a spot's cone change too much over a triangle? An edge of it that lies inside errs by 0.25 range^2. */
static int cone_cuts(const glint_frame *frame, lights *of, const measures *m, uint32_t shown, uint32_t *error) {
    for (uint32_t l = 0; shown >> l; l++) {
        const glint_prepared_light *source = &frame->view->lights[l];
        if (!(shown >> l & 1) || !source->has_cone)
            continue;
        if (!(of->sides >> l & 1)) {
            if (m->near <= CLEARLY_INSIDE)
                continue;
            of->sides |= 1u << l;
            of->held &= ~(1u << l);
        }
        const uint32_t range = (uint32_t)((uint64_t)m->near * (uint32_t)source->spot.slope >> 15);
        if (!source->spot.slope || range > 2048)
            return 1;
        *error += (times(range, range) / 4 + times(times(range, range), range) / 36) * m->levels >> 8;
    }
    return 0;
}

/* Does a light shine all over a triangle, by the control points of its quadratic (Bezier triangles, Farin, 1986)? */
static int shines_all_over(const glint_node nodes[6], uint32_t l) {
    const int32_t a = nodes[0].side[l], b = nodes[1].side[l], c = nodes[2].side[l];
    return glint_least_of(a, b, c) > 0 &&
           glint_least_of(4 * nodes[3].side[l] - a - b, 4 * nodes[4].side[l] - b - c, 4 * nodes[5].side[l] - a - c) > 0;
}

int glint_terms_begin(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                      const glint_part *part, glint_terms *terms) {
    const glint_shading *shading = draw->shading;
    const glint_light_terms *light = &shading->terms;
    const glint_vertex *const *v = triangle->corners;
    const int is_mirror = shading->material->model->lobe == GLINT_LOBE_MIRROR;
    const int gated = !(shading->material->flags & GLINT_MATERIAL_UNGATED);
    triangle_nodes t;
    glint_fragments at;
    measures m;
    lights of = {0, 0, 0};
    uint32_t dark;
    lengths by;
    if (!is_shapely(triangle, part))
        return REJECT(1);
    for (int i = 0; i < 3; i++)
        t.kept[i] = draw->nodes + (size_t)(v[i] - draw->vertices) * light->stride;
    measure(frame->view, triangle, &m);
    find_lights(shading, &t, &m, &of, &dark);
    if (m.near > 3 << 10)
        return REJECT(2);
    if (m.near && times(m.near, m.turn) > 2 * CLEARLY_NEAR) { /* what is clear at corners may not be between them */
        of.sides = shading->lights;
        of.held = dark = 0;
    }
    uint32_t more = 0;
    if (cone_cuts(frame, &of, &m, of.held | of.sides, &more))
        return REJECT(3);
    const uint32_t place = m.near * 362 >> 8, view = frame->view->local_viewer ? m.reach : 0;
    uint32_t plane_error = of.sides ? UINT32_MAX / 2 : plane_sum_error(m.levels, m.turn, place, m.slant);
    uint32_t error = more + sum_error(m.levels, m.turn + place, m.slant),
             error_over = more + sum_error(m.levels, place, m.slant);
    const uint32_t flags = (uint16_t)(t.kept[0][light->channels + FLAGS] | t.kept[1][light->channels + FLAGS] |
                                      t.kept[2][light->channels + FLAGS]);
    const uint32_t unfit = flags >> 8, far = flags & 0xff;
    for (uint32_t l = 0, lobes = gated ? light->lobes & (of.held | of.sides) : light->lobes; lobes >> l; l++) {
        const uint32_t bit = 1u << l;
        if (!(lobes & bit))
            continue;
        const int16_t *const lobe[3] = {t.kept[0] + light->lobe_at[l], t.kept[1] + light->lobe_at[l],
                                        t.kept[2] + light->lobe_at[l]};
        if (!(unfit & bit) && is_outside(light, lobe))
            continue;
        if ((unfit | far) & bit)
            return REJECT(4);
        of.lobes |= bit;
        const uint32_t axis = m.near + view;
        plane_error +=
            plane_lobe_error(light, light->specular_levels[l], is_mirror ? 2 * m.turn : m.turn, axis, m.slant);
        error +=
            lobe_error(light, light->specular_levels[l], (is_mirror ? 2 * m.turn : m.turn) + axis, m.near, m.slant);
        error_over += lobe_error(light, light->specular_levels[l], axis, m.near, m.slant);
    }
    const uint32_t facing =
        (uint16_t)(t.kept[0][light->channels] | t.kept[1][light->channels] | t.kept[2][light->channels]);
    terms->light = light;
    terms->power = &shading->power;
    terms->has_surface = 0;
    terms->takes_largest = (shading->material->flags & GLINT_MATERIAL_MAX) != 0;
    if (plane_error <= light->limit && (facing & 0xff) == of.held) {
        begin_planes(frame, draw, part, &t, &of, (int32_t)(times(m.turn, m.turn) >> 1), terms);
        return 1;
    }
    const int is_over_length = error > 2 * light->limit;
    if (is_over_length && error_over > light->limit)
        return REJECT(6);
    if (is_over_length && !find_lengths(triangle, &by))
        return REJECT(7);
    at.count = 0;
    t.is_fresh = of.sides || (facing & 0xff) != of.held;
    if (t.is_fresh)
        for (int i = 0; i < 3; i++)
            gather_corner(frame, v[i], &at);
    gather_middle(frame, v[0], v[1], &at);
    gather_middle(frame, v[1], v[2], &at);
    gather_middle(frame, v[0], v[2], &at);
    glint_nodes_light(frame, shading, &at, of.held, of.held | of.sides | of.lobes, of.lobes,
                      t.is_fresh ? t.fresh : t.fresh + 3);
    for (int i = 3; i < 6; i++)
        if ((t.fresh[i].unfit | t.fresh[i].far) & of.lobes)
            return REJECT(8);
    for (uint32_t l = 0, both = gated ? of.sides & of.lobes : 0; both >> l; l++)
        if (both >> l & 1 && !shines_all_over(t.fresh, l))
            return REJECT(5);
    begin_terms(frame, draw, part, &t, &of, is_over_length ? &by : 0, terms);
    return 1;
}
