#ifndef REJECT
#define REJECT(n) 0
#endif
/* SPDX-License-Identifier: MIT */
/* Terms of a triangle: which lights shine on it, whether polynomials fit, and the polynomials. */
#include "terms.h"

#include "deviation.h"
#include "division.h"
#include "setup.h"

/* ---- Vertices ---- */

/*
 * What a vertex keeps: its sum, the lights it faces and does not, its flags; of each light with a lobe a deviation, and
 * of each with a position its strength and how close it is.
 */
static void keep(const glint_frame *frame, const glint_light_terms *light, const glint_node *node, int16_t *to) {
    for (uint32_t c = 0; c < light->channels; c++)
        *to++ = (int16_t)node->sum[c];
    *to++ = (int16_t)(uint16_t)(node->lit | node->dark << 8);
    *to++ = (int16_t)(uint16_t)(node->far | node->unfit << 8);
    for (uint32_t i = 0; i < frame->view->light_count; i++) {
        if (light->lobes >> i & 1) {
            *to++ = node->lobe[i][0];
            *to++ = node->lobe[i][1];
        }
        if (frame->view->lights[i].type->illuminate) {
            *to++ = node->lobe[i][2];
            *to++ = (int16_t)node->closeness[i];
        }
    }
}

static void recall(const glint_frame *frame, const glint_light_terms *light, const int16_t *from, glint_node *node) {
    for (uint32_t c = 0; c < light->channels; c++)
        node->sum[c] = *from++;
    const uint16_t facing = (uint16_t)*from++, flags = (uint16_t)*from++;
    node->lit = (uint8_t)facing;
    node->dark = (uint8_t)(facing >> 8);
    node->far = (uint8_t)flags;
    node->unfit = (uint8_t)(flags >> 8);
    for (uint32_t i = 0; i < frame->view->light_count; i++) {
        if (light->lobes >> i & 1) {
            node->lobe[i][0] = *from++;
            node->lobe[i][1] = *from++;
        }
        if (frame->view->lights[i].type->illuminate) {
            node->lobe[i][2] = *from++;
            node->closeness[i] = (uint16_t)*from++;
        }
    }
}

/* Ray towards the eye from a point of the screen, 28.4. */
static void find_ray(const glint_frame *frame, int32_t x, int32_t y, int32_t ray[3]) {
    ray[0] = frame->config.width * 4096 - x * 512;
    ray[1] = y * 512 - frame->config.height * 4096;
    ray[2] = frame->view->focal;
}

static void gather_corner(const glint_frame *frame, const glint_vertex *v, int is_back, glint_fragments *to) {
    const uint32_t i = to->count++;
    find_ray(frame, v->x, v->y, to->ray[i]);
    to->inverse_w[i] = v->inverse_w;
    for (int c = 0; c < 3; c++)
        to->normal[i][c] = (int16_t)(is_back ? -v->attribute[c] : v->attribute[c]);
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
        gather_corner(frame, vertex, 0, &vertices);
    }
    if (!vertices.count)
        return;
    glint_nodes_light(frame, draw->shading, &vertices, GLINT_ALL_LIT, nodes);
    for (uint32_t i = 0; i < vertices.count; i++)
        keep(frame, light, &nodes[i], draw->nodes + index[i] * light->stride);
}

/* ---- Triangles ---- */

/* What a triangle's light is decided by; angles Q12. */
typedef struct measures {
    int32_t turn;  /* of the normals */
    int32_t reach; /* how far its corners lie apart, over their depth */
    int32_t slant; /* natural logarithm of the change of 1/w, or more */
} measures;

/* sqrt(x), Q24 to Q12. */
static int32_t root_of(uint32_t x) {
    if (!x)
        return 0;
    const unsigned up = (glint_leading_zeros(x) & ~1u);
    const uint32_t wide = x << up;                                 /* 2^30 .. 2^32 */
    const uint32_t root = (uint32_t)glint_inverse_root(wide >> 1); /* 2^15 2^15 / sqrt */
    return (int32_t)(((wide >> 16) * root >> 15) >> (up / 2)) + 1;
}

/* sqrt(x), Q15, x from 2^13 to 2^15. */
static int32_t root_of15(uint32_t x) {
    const unsigned up = (glint_leading_zeros(x) - 3) | 1;
    const uint32_t wide = x << up; /* 2^28 .. 2^30 */
    const uint32_t inverse = (uint32_t)glint_inverse_root(wide);
    const uint32_t root = (wide >> 14) * (inverse + (inverse >> 13)) >> 16;
    return (int32_t)(root << 1 >> (up - 13) / 2);
}

static int32_t square_of_difference(const int16_t a[3], const int16_t b[3]) {
    const int32_t x = glint_shift_right(a[0] - b[0], 2), y = glint_shift_right(a[1] - b[1], 2),
                  z = glint_shift_right(a[2] - b[2], 2);
    return x * x + y * y + z * z; /* Q26, below 2^29 */
}

static void measure(const glint_view *view, const glint_triangle *triangle, measures *m) {
    const glint_vertex *const *v = triangle->corners;
    const int16_t *a = v[0]->attribute, *b = v[1]->attribute, *c = v[2]->attribute;
    const int32_t turn =
        glint_most_of(square_of_difference(a, b), square_of_difference(b, c), square_of_difference(c, a));
    const int32_t width = glint_most_of(v[0]->x, v[1]->x, v[2]->x) - glint_least_of(v[0]->x, v[1]->x, v[2]->x);
    const int32_t height = glint_most_of(v[0]->y, v[1]->y, v[2]->y) - glint_least_of(v[0]->y, v[1]->y, v[2]->y);
    const glint_w_range w = glint_find_w_range(v);
    m->turn = root_of((uint32_t)turn >> 2);
    m->slant = w.least ? (int32_t)glint_least((int32_t)((w.change << 12) / w.least), 1 << 14) : 1 << 14;
    m->reach = (int32_t)((int64_t)(width + height) * view->pixel >> 18) + m->slant;
}

/* Products of angles, Q12; saturated. */
static inline uint32_t times(uint32_t a, uint32_t b) {
    const uint64_t product = (uint64_t)a * b >> 12;
    return product > 1 << 24 ? 1 << 24 : (uint32_t)product;
}

/*
 * What polynomials through a triangle's nodes err at most, levels in Q8: quadratics of a light's diffuse part by 0.0275
 * theta (theta + e)^2, theta the turn of N and of L and the logarithm of the distance, e 1.85 times that of 1/w.
 */
static uint32_t diffuse_error(uint32_t levels, const measures *m, int32_t turn, uint32_t closeness) {
    const uint32_t theta = (uint32_t)turn + (2 * (uint32_t)m->reach * closeness >> 8);
    const uint32_t with = theta + ((uint32_t)m->slant * 474 >> 8);
    return (uint32_t)((uint64_t)times(times(theta, with), with) * levels * 1802 >> 28); /* 0.0275 is 1802 2^-16 */
}

/*
 * The same of a highlight: by 0.041 s h (h + e)^2, h the turn of N and of H, s the highlight's slope over the
 * deviation; and of its strength.
 */
static uint32_t lobe_error(const glint_light_terms *light, uint32_t levels, const measures *m, int32_t turning,
                           uint32_t closeness, int is_mirror, int is_local) {
    const uint32_t near = (uint32_t)m->reach * closeness >> 8, view = is_local ? (uint32_t)m->reach : 0;
    const uint32_t turn = is_mirror ? 2 * (uint32_t)turning + near + view : (uint32_t)turning + (near + view) / 2;
    const uint32_t e = (uint32_t)m->slant * 474 >> 8, h = turn + near / 2;
    const uint32_t of_place = (uint32_t)((uint64_t)times(times(h, h + e), h + e) * light->slope >> 8);
    const uint32_t of_strength = times(times(near, near + e), near + e);
    return (uint32_t)(((uint64_t)of_place * 2687 + (uint64_t)of_strength * 1802) * levels >> 28);
}

/* Are all three corners beyond one side of the octagon around a highlight? */
static int is_outside(const glint_light_terms *light, const glint_node nodes[3], uint32_t i, int32_t margin) {
    const int32_t cut = light->lobe_cut + margin, diagonal = light->lobe_diagonal + margin + (margin >> 1);
    const int32_t x0 = nodes[0].lobe[i][0], x1 = nodes[1].lobe[i][0], x2 = nodes[2].lobe[i][0];
    const int32_t y0 = nodes[0].lobe[i][1], y1 = nodes[1].lobe[i][1], y2 = nodes[2].lobe[i][1];
    return glint_least_of(x0, x1, x2) >= cut || glint_most_of(x0, x1, x2) <= -cut ||
           glint_least_of(y0, y1, y2) >= cut || glint_most_of(y0, y1, y2) <= -cut ||
           glint_least_of(x0 + y0, x1 + y1, x2 + y2) >= diagonal ||
           glint_most_of(x0 + y0, x1 + y1, x2 + y2) <= -diagonal ||
           glint_least_of(x0 - y0, x1 - y1, x2 - y2) >= diagonal ||
           glint_most_of(x0 - y0, x1 - y1, x2 - y2) <= -diagonal;
}

/* M at a node, N/w with the largest corner's 1/w as 1: its square and its length, Q15. */
typedef struct lengths {
    int32_t square[6], length[6];
} lengths;

/* Lengths at the corners, whose 1/w is w, Q15, and at the middles of the edges, where M.M = wa wb (N.N - 1) / 2 + ((wa
 * + wb) / 2)^2. */
static void find_lengths(const glint_triangle *triangle, lengths *of) {
    const glint_vertex *const *v = triangle->corners;
    uint32_t w[3];
    const uint32_t largest = (uint32_t)glint_most_of(v[0]->inverse_w, v[1]->inverse_w, v[2]->inverse_w);
    const unsigned zeros = glint_leading_zeros(largest);
    const uint32_t reciprocal = (uint32_t)glint_reciprocal16(largest << zeros >> 16) - 1; /* 2^31 / 16 bits */
    for (int i = 0; i < 3; i++) {
        w[i] = ((uint32_t)v[i]->inverse_w << zeros >> 16) * reciprocal >> 16; /* Q15 */
        of->length[i] = (int32_t)w[i];
        of->square[i] = (int32_t)(w[i] * w[i] >> 15);
    }
    for (int i = 0; i < 3; i++) {
        const int a = i == 1 ? 1 : 0, b = i == 0 ? 1 : 2;
        const int32_t turn = square_of_difference(v[a]->attribute, v[b]->attribute); /* Q26 */
        const int32_t mean = (int32_t)(w[a] + w[b]) >> 1, both = (int32_t)(w[a] * w[b] >> 15);
        of->square[3 + i] = (mean * mean >> 15) - (int32_t)((int64_t)both * turn >> 28);
        of->length[3 + i] = root_of15((uint32_t)of->square[3 + i]);
    }
}

/* The middle of an edge, as a fragment. */
static void gather_middle(const glint_frame *frame, const glint_vertex *a, const glint_vertex *b, int is_back,
                          glint_fragments *to) {
    const uint32_t i = to->count++;
    const unsigned zeros = glint_leading_zeros((uint32_t)a->inverse_w | (uint32_t)b->inverse_w);
    int32_t wa = (int32_t)((uint32_t)a->inverse_w << zeros >> 17),
            wb = (int32_t)((uint32_t)b->inverse_w << zeros >> 17);
    if (is_back)
        wa = -wa, wb = -wb;
    find_ray(frame, (a->x + b->x) >> 1, (a->y + b->y) >> 1, to->ray[i]);
    to->inverse_w[i] = (a->inverse_w >> 1) + (b->inverse_w >> 1);
    glint_unit_each(a->attribute[0] * wa + b->attribute[0] * wb, a->attribute[1] * wa + b->attribute[1] * wb,
                    a->attribute[2] * wa + b->attribute[2] * wb, to->normal[i]);
}

/* Lights of a triangle by what is to be done with them; bit i: light i. */
typedef struct lights {
    uint32_t held, sides, lobes;
} lights;

/* The polynomial of a number of the nodes: at the corners, and at the middles of the edges. */
static void begin_polynomial(glint_quadratic *q, const glint_barycentric *s, const int32_t n[6]) {
    const int32_t bulge[3] = {4 * n[3] - 2 * (n[0] + n[1]), 4 * n[4] - 2 * (n[1] + n[2]), 4 * n[5] - 2 * (n[0] + n[2])};
    glint_polynomial_begin(q, s, n, bulge);
}

static uint32_t scale_down(uint32_t x, unsigned by) {
    return (uint32_t)glint_shift_right((int32_t)x, by);
}

/* A channel's polynomial in Q27. */
static void scale_channel(glint_quadratic *q, unsigned sum_bits) {
    const unsigned by = 4 - sum_bits;
    *q = (glint_quadratic){scale_down(q->start, by), scale_down(q->dx, by),  scale_down(q->dy, by),
                           scale_down(q->dxx, by),   scale_down(q->dxy, by), scale_down(q->dyy, by)};
}

/* A number times its node's length, where there is one. */
static inline int32_t scale_by(const lengths *by, int i, int32_t number) {
    return by ? glint_shift_right(number * by->length[i] + (1 << 14), 15) : number;
}

static void begin_terms(const glint_frame *frame, const glint_draw *draw, const glint_part *part,
                        const glint_node nodes[6], const lights *of, const lengths *by, glint_terms *terms) {
    const glint_light_terms *light = &draw->shading->terms;
    glint_barycentric s;
    int32_t n[6];
    glint_barycentric_begin(&s, &part->gradients);
    for (uint32_t c = 0; c < light->channels; c++) {
        for (int i = 0; i < 6; i++)
            n[i] = scale_by(by, i, nodes[i].sum[c]);
        begin_polynomial(&terms->sum[c], &s, n);
        if (light->channels == 3)
            scale_channel(&terms->sum[c], light->sum_bits);
        else
            terms->sum[c].start += 1 << 15;
    }
    terms->is_over_length = by != 0;
    if (by) {
        for (int i = 0; i < 6; i++)
            n[i] = by->square[i] >> 1;
        begin_polynomial(&terms->square, &s, n);
    }
    terms->side_count = terms->lobe_count = 0;
    for (uint32_t l = 0; l < GLINT_LIGHTS_MAX; l++) {
        if (of->sides >> l & 1) {
            glint_side *side = &terms->sides[terms->side_count++];
            for (int i = 0; i < 6; i++)
                n[i] = scale_by(by, i, nodes[i].side[l] >> 1);
            begin_polynomial(&side->cosine, &s, n);
            side->weight = light->diffuse[l];
        }
        if (of->lobes >> l & 1) {
            glint_lobe *lobe = &terms->lobes[terms->lobe_count++];
            for (int k = 0; k < 3; k++) {
                for (int i = 0; i < 6; i++)
                    n[i] = k == 2 ? nodes[i].lobe[l][k] >> 1 : scale_by(by, i, nodes[i].lobe[l][k]);
                begin_polynomial(k == 0 ? &lobe->x : k == 1 ? &lobe->y : &lobe->strength, &s, n);
            }
            lobe->weight = light->specular[l];
            lobe->is_attenuated = frame->view->lights[l].type->illuminate != 0;
        }
    }
}

/*
 * A spot's cone on a triangle: where the cosine within the cone changes by `range` of what lies between its edges, its
 * strength errs as light that turns by that; and by 0.25 range^2 where an edge lies inside. @return does it change too
 * much?
 */
static int cone_cuts(const glint_prepared_light *source, measures *m, uint32_t closeness, int is_side, uint32_t levels,
                     uint32_t *error) {
    const uint32_t near = (uint32_t)m->reach * closeness >> 8;
    if (!source->has_cone)
        return 0;
    if (!is_side)
        return near > 64; /* of what tells clear from not */
    if (!source->spot.slope)
        return 1;
    const uint32_t range = (uint32_t)((uint64_t)near * (uint32_t)source->spot.slope >> 15);
    if (range > 2048)
        return 1;
    *error += (uint32_t)((uint64_t)(times(range, range) / 4 + times(times(range, range), range) / 36) * levels >> 12);
    return 0;
}

/* Slivers' polynomials wrap or lose their digits: 2 bits more than a triangle of even sides has. */
#define SLENDER 7
#define LEAST_AREA 8

/* M.M between the nodes is no less than 1/4 where they have this, Q15. */
#define LEAST_SQUARE 12000

int glint_terms_begin(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                      const glint_part *part, glint_terms *terms) {
    const glint_shading *shading = draw->shading;
    const glint_light_terms *light = &shading->terms;
    const glint_vertex *const *v = triangle->corners;
    const uint32_t count = frame->view->light_count;
    const int is_mirror = shading->material->model->lobe == GLINT_LOBE_MIRROR, is_local = frame->view->local_viewer;
    const int gated = !(shading->material->flags & GLINT_MATERIAL_UNGATED);
    glint_node nodes[6];
    glint_fragments at;
    measures m;
    if (!(v[0]->flags & v[1]->flags & v[2]->flags & GLINT_VERTEX_LIT) || triangle->back || glint_is_deep(triangle) ||
        triangle->area < LEAST_AREA || glint_slenderness(&part->gradients, triangle->area) > SLENDER)
        return REJECT(1);
    for (int i = 0; i < 3; i++)
        recall(frame, light, draw->nodes + (size_t)(v[i] - draw->vertices) * light->stride, &nodes[i]);
    measure(frame->view, triangle, &m);
    lights of = {nodes[0].lit & nodes[1].lit & nodes[2].lit, 0, 0};
    const uint32_t dark = nodes[0].dark & nodes[1].dark & nodes[2].dark;
    of.sides = shading->lights & ~of.held & ~dark;
    const uint32_t unfit = nodes[0].unfit | nodes[1].unfit | nodes[2].unfit,
                   far = nodes[0].far | nodes[1].far | nodes[2].far;
    uint32_t error = 0, error_over = 0;
    lengths by;
    for (uint32_t l = 0; l < count; l++) {
        if (!(shading->lights >> l & 1))
            continue;
        uint32_t closeness = 0;
        if (frame->view->lights[l].type->illuminate) {
            closeness = nodes[0].closeness[l];
            for (int i = 1; i < 3; i++)
                closeness = closeness > nodes[i].closeness[l] ? closeness : nodes[i].closeness[l];
            if ((uint64_t)m.reach * closeness > 1 << 18) /* a quarter of the distance */
                return REJECT(2);
            if (cone_cuts(&frame->view->lights[l], &m, closeness, of.sides >> l & 1, light->diffuse_levels[l], &error))
                return REJECT(3);
            /* between the corners N.L is off by no more than half the product of what N and L turn by */
            if ((uint64_t)m.reach * closeness * (uint32_t)m.turn >> 20 > 64)
                of.held &= ~(1u << l), of.sides |= 1u << l;
        }
        if ((of.held | of.sides) >> l & 1)
            error += diffuse_error(light->diffuse_levels[l], &m, m.turn, closeness),
                error_over += diffuse_error(light->diffuse_levels[l], &m, 0, closeness);
        if (!(light->lobes >> l & 1) || (gated && dark >> l & 1))
            continue;
        const uint32_t bit = 1u << l;
        if (!(unfit & bit) && is_outside(light, nodes, l, light->lobe_cut >> 4))
            continue;
        if ((unfit | far) & bit || (gated && of.sides & bit))
            return REJECT(4);
        of.lobes |= bit;
        error += lobe_error(light, light->specular_levels[l], &m, m.turn, closeness, is_mirror, is_local),
            error_over +=
            lobe_error(light, light->specular_levels[l], &m, is_mirror ? m.turn : 0, closeness, is_mirror, is_local);
    }
    const int is_over_length = error > light->limit;
    if (is_over_length && error_over > light->limit)
        return REJECT(5);
    if (is_over_length) {
        find_lengths(triangle, &by);
        for (int i = 0; i < 6; i++)
            if (by.square[i] < LEAST_SQUARE)
                return REJECT(6);
    }
    at.count = 0;
    const int fresh = of.sides || nodes[0].lit != of.held || nodes[1].lit != of.held || nodes[2].lit != of.held;
    if (fresh)
        for (int i = 0; i < 3; i++)
            gather_corner(frame, v[i], 0, &at);
    gather_middle(frame, v[0], v[1], 0, &at);
    gather_middle(frame, v[1], v[2], 0, &at);
    gather_middle(frame, v[0], v[2], 0, &at);
    glint_nodes_light(frame, shading, &at, of.held, fresh ? nodes : nodes + 3);
    for (int i = 3; i < 6; i++)
        if ((nodes[i].unfit | nodes[i].far) & of.lobes)
            return REJECT(7);
    terms->light = light;
    terms->power = &shading->power;
    terms->has_surface = 0;
    terms->takes_largest = (shading->material->flags & GLINT_MATERIAL_MAX) != 0;
    begin_terms(frame, draw, part, nodes, &of, is_over_length ? &by : 0, terms);
    return 1;
}
