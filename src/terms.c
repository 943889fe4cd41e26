/* SPDX-License-Identifier: MIT */
/* Terms of a triangle: its nodes, which lights shine on it, and the polynomials if they are close enough. */
#include "terms.h"

#include "division.h"

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
            lobe[0] = node->number[i][GLINT_LOBE_X];
            lobe[1] = node->number[i][GLINT_LOBE_Y];
            if (frame->view->lights[i].type->illuminate)
                lobe[2] = node->number[i][GLINT_STRENGTH];
        }
}

static void gather_corner(const glint_frame *frame, const glint_vertex *v, glint_fragments *to) {
    const uint32_t i = to->count++;
    glint_find_ray(frame, v->x, v->y, to->ray[i]);
    to->inverse_w[i] = v->inverse_w;
    for (int c = 0; c < 3; c++)
        to->normal[i][c] = v->attribute[c];
}

void glint_terms_light(const glint_frame *frame, glint_draw *draw, const glint_transform *transform,
                       uint32_t triangle) {
    const glint_light_terms *light = &draw->shading->terms;
    uint32_t index[3];
    glint_fragments vertices;
    glint_node nodes[3], *const to[3] = {&nodes[0], &nodes[1], &nodes[2]};
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
    glint_nodes_light(frame, draw->shading, &vertices, draw->shading->lights, light->lobes, to);
    for (uint32_t i = 0; i < vertices.count; i++) {
        glint_node_sum(light, nodes[i].lit, &nodes[i]);
        keep(frame, light, &nodes[i], draw->nodes + index[i] * light->stride);
    }
}

/* ---- What is known from the corners ---- */

/* A triangle on its way to terms. */
typedef struct candidate {
    const int16_t *kept[3]; /* of its corners */
    glint_node node[6];     /* corners, where they are found anew, and middles */
    int is_fresh;           /* are they? */
    int has_surface;
    int16_t surface[6][3]; /* its colours there, Q14 */
    glint_region region;
} candidate;

static void measure(const glint_view *view, const glint_triangle *triangle, glint_region *region) {
    const glint_vertex *const *v = triangle->corners;
    const int16_t *a = v[0]->attribute, *b = v[1]->attribute, *c = v[2]->attribute;
    const int32_t turn = glint_most_of(glint_square_apart(a, b), glint_square_apart(b, c), glint_square_apart(c, a));
    const int32_t width = glint_most_of(v[0]->x, v[1]->x, v[2]->x) - glint_least_of(v[0]->x, v[1]->x, v[2]->x);
    const int32_t height = glint_most_of(v[0]->y, v[1]->y, v[2]->y) - glint_least_of(v[0]->y, v[1]->y, v[2]->y);
    region->turn = glint_angle_of((uint32_t)turn >> 2);
    glint_region_measure(view, (uint32_t)width, (uint32_t)height, glint_find_w_range(v), region);
}

/* Does a highlight show on a triangle? */
static int place_lobe(const glint_shading *shading, const candidate *t, uint32_t l) {
    const glint_light_terms *light = &shading->terms;
    const int16_t *a = t->kept[0] + light->lobe_at[l], *b = t->kept[1] + light->lobe_at[l],
                  *c = t->kept[2] + light->lobe_at[l];
    const int32_t sum[3] = {a[0] + a[1], b[0] + b[1], c[0] + c[1]},
                  difference[3] = {a[0] - a[1], b[0] - b[1], c[0] - c[1]};
    const int32_t least[4] = {glint_least_of(a[0], b[0], c[0]), glint_least_of(a[1], b[1], c[1]),
                              glint_least_of(sum[0], sum[1], sum[2]),
                              glint_least_of(difference[0], difference[1], difference[2])};
    const int32_t most[4] = {glint_most_of(a[0], b[0], c[0]), glint_most_of(a[1], b[1], c[1]),
                             glint_most_of(sum[0], sum[1], sum[2]),
                             glint_most_of(difference[0], difference[1], difference[2])};
    return glint_place_lobe(shading, least, most);
}

/* A colour at the middle of an edge, which is linear over w. */
static int16_t between(int32_t a, int32_t b, int32_t wa, int32_t wb) {
    return (int16_t)(a == b ? a >> 1 : (a * (wa >> 1) + b * (wb >> 1)) / (wa + wb));
}

/* Sets the surface's colours at the nodes. @return by how much they differ, Q12 */
static uint32_t find_surface(const glint_triangle *triangle, candidate *t) {
    static const uint8_t ends[3][2] = {{0, 1}, {1, 2}, {0, 2}};
    int32_t apart = 0, w[3];
    const glint_vertex *const *v = triangle->corners;
    const unsigned zeros =
        glint_leading_zeros((uint32_t)v[0]->inverse_w | (uint32_t)v[1]->inverse_w | (uint32_t)v[2]->inverse_w);
    for (int i = 0; i < 3; i++)
        w[i] = (int32_t)((uint32_t)v[i]->inverse_w << zeros >> 17);
    for (int c = 0; c < 3; c++) {
        const int32_t a[3] = {triangle->extra[0][c], triangle->extra[1][c], triangle->extra[2][c]};
        for (int i = 0; i < 3; i++) {
            const int from = ends[i][0], to = ends[i][1];
            t->surface[i][c] = (int16_t)((a[i] + 1) >> 1);
            t->surface[3 + i][c] = between(a[from] + 1, a[to] + 1, w[from], w[to]);
        }
        apart = glint_most(apart, glint_most_of(a[0], a[1], a[2]) - glint_least_of(a[0], a[1], a[2]));
    }
    return (uint32_t)apart >> 3;
}

/* Sets a triangle's region from what its corners keep. @return 0 where no polynomials fit */
static int find_region(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle, candidate *t) {
    const glint_shading *shading = draw->shading;
    const glint_light_terms *light = &shading->terms;
    glint_region *region = &t->region;
    for (int i = 0; i < 3; i++)
        t->kept[i] = draw->nodes + (size_t)(triangle->corners[i] - draw->vertices) * light->stride;
    const int16_t *a = t->kept[0] + light->channels, *b = t->kept[1] + light->channels,
                  *c = t->kept[2] + light->channels;
    const uint32_t facing = (uint16_t)(a[FACING] & b[FACING] & c[FACING]);
    const uint32_t flags = (uint16_t)(a[FLAGS] | b[FLAGS] | c[FLAGS]);
    measure(frame->view, triangle, region);
    region->levels = (uint32_t)glint_most_of(a[LEVELS], b[LEVELS], c[LEVELS]);
    region->lit = facing & 0xff;
    region->dark = facing >> 8;
    region->far = flags & 0xff;
    region->unfit = flags >> 8;
    region->steep = 0;
    t->has_surface = draw->extra != 0;
    region->colour = t->has_surface ? find_surface(triangle, t) : 0;
    uint32_t lobes =
        glint_region_sort(frame, shading, (uint32_t)glint_most_of(a[CLOSENESS], b[CLOSENESS], c[CLOSENESS]), region);
    region->lobes = 0;
    for (uint32_t l = 0; lobes >> l; l++)
        if (lobes >> l & 1)
            glint_region_add_lobe(region, l, region->unfit >> l & 1 ? GLINT_LOBE_UNFIT : place_lobe(shading, t, l));
    /* corners' sums hold all lights that each faces */
    t->is_fresh = region->sides || ((a[FACING] | b[FACING] | c[FACING]) & 0xff) != (int32_t)region->held;
    return glint_region_bound(frame, shading, t->has_surface, region);
}

/* ---- Nodes ---- */

/* The middle of an edge, as a fragment. */
static void gather_middle(const glint_frame *frame, const glint_vertex *a, const glint_vertex *b, glint_fragments *to) {
    const uint32_t i = to->count++;
    const unsigned zeros = glint_leading_zeros((uint32_t)a->inverse_w | (uint32_t)b->inverse_w);
    const int32_t wa = (int32_t)((uint32_t)a->inverse_w << zeros >> 17),
                  wb = (int32_t)((uint32_t)b->inverse_w << zeros >> 17);
    glint_find_ray(frame, (a->x + b->x) >> 1, (a->y + b->y) >> 1, to->ray[i]);
    to->inverse_w[i] = (a->inverse_w >> 1) + (b->inverse_w >> 1);
    glint_unit_each(a->attribute[0] * wa + b->attribute[0] * wb, a->attribute[1] * wa + b->attribute[1] * wb,
                    a->attribute[2] * wa + b->attribute[2] * wb, to->normal[i]);
}

/* Finds a triangle's nodes. @return 0 where polynomials through them do not fit */
static int find_nodes(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle, candidate *t) {
    const glint_vertex *const *v = triangle->corners;
    const glint_region *region = &t->region;
    const int first = t->is_fresh ? 0 : 3;
    glint_node *const to[6] = {&t->node[0], &t->node[1], &t->node[2], &t->node[3], &t->node[4], &t->node[5]};
    glint_fragments at;
    uint32_t unfit = 0;
    at.count = 0;
    for (int i = first; i < 3; i++)
        gather_corner(frame, v[i], &at);
    gather_middle(frame, v[0], v[1], &at);
    gather_middle(frame, v[1], v[2], &at);
    gather_middle(frame, v[0], v[2], &at);
    glint_nodes_light(frame, draw->shading, &at, region->held | region->sides | region->lobes, region->lobes,
                      to + first);
    for (int i = first; i < 6; i++)
        glint_node_sum(&draw->shading->terms, region->held, &t->node[i]);
    for (int i = first; i < 6; i++)
        unfit |= ((t->node[i].unfit | t->node[i].far) & region->lobes) | (t->node[i].steep & region->cones);
    return !unfit;
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
        const int32_t turn = glint_square_apart(v[a]->attribute, v[b]->attribute); /* Q26 */
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

/* Through a number of the nodes: at the corners, and at the middles of the edges. */
static void begin_polynomial(glint_quadratic *q, const glint_barycentric *s, const int32_t n[6]) {
    const int32_t bulge[3] = {4 * n[3] - 2 * (n[0] + n[1]), 4 * n[4] - 2 * (n[1] + n[2]), 4 * n[5] - 2 * (n[0] + n[2])};
    glint_polynomial_begin(q, s, n, bulge);
}

/* A number times its node's length, or its square, where there is one. */
static inline int32_t scale_by(const int32_t by[6], int i, int32_t number) {
    return by ? glint_shift_right(number * by[i] + (1 << 14), 15) : number;
}

/* A plane as a polynomial, times 2^unit. */
static void begin_plane(glint_quadratic *q, const glint_gradients *g, int32_t a, int32_t b, int32_t c, unsigned unit) {
    glint_plane plane;
    glint_plane_begin(&plane, g, glint_shift_left(a, unit), glint_shift_left(b, unit), glint_shift_left(c, unit));
    *q = (glint_quadratic){(uint32_t)plane.start, (uint32_t)plane.dx, (uint32_t)plane.dy, 0, 0, 0};
}

/* Sums at a triangle's node. */
static inline int32_t sum_at(const glint_terms *terms, const candidate *t, int i, int c) {
    const int16_t *const surface = t->has_surface ? t->surface[i] : 0;
    if (i >= 3 || t->is_fresh)
        return glint_sum_at(terms, t->node[i].sum[0], t->node[i].sum[c], c, surface);
    return glint_sum_at(terms, t->kept[i][0], terms->light->channels == 1 ? t->kept[i][0] : t->kept[i][c], c, surface);
}

/* Its numbers of a light. */
static inline int32_t number_at(const glint_light_terms *light, const candidate *t, int i, uint32_t l, uint32_t kind) {
    return i < 3 && !t->is_fresh ? t->kept[i][light->lobe_at[l] + (kind == GLINT_STRENGTH ? 2 : kind - GLINT_LOBE_X)]
                                 : t->node[i].number[l][kind];
}

/* Adds half a level to sums that are all channels, and ambient light where they do not hold it. */
static void finish_sums(const glint_terms *terms, const candidate *t,
                        glint_quadratic polynomials[GLINT_POLYNOMIALS_MAX]) {
    if (!terms->is_channels && terms->light->channels == 1)
        polynomials[0].start += 1 << 15;
    for (int c = 0; c < 3 && terms->is_channels && !terms->is_over_length; c++)
        polynomials[c].start += (uint32_t)(terms->light->half[c] + (t->has_surface ? 0 : terms->light->ambient[c]));
}

/* Binary logarithm of what 1 is in polynomials of sums, over what it is at nodes. */
static unsigned unit_of_sums(const glint_terms *terms) {
    return terms->sums == 1 ? 16 : 12 + terms->light->sum_bits;
}

static void begin_quadratics(const glint_part *part, const candidate *t, const lengths *by, const glint_terms *terms,
                             glint_quadratic polynomials[GLINT_POLYNOMIALS_MAX]) {
    const int32_t *const length = by ? by->length : 0;
    const int32_t *const of_lobe = terms->is_over_length > 1 ? by->square : length;
    glint_barycentric s;
    int32_t n[6];
    glint_barycentric_begin(&s, &part->gradients, (int32_t)unit_of_sums(terms));
    for (uint32_t c = 0; c < terms->sums; c++) {
        for (int i = 0; i < 6; i++)
            n[i] = scale_by(length, i, sum_at(terms, t, i, (int)c));
        begin_polynomial(&polynomials[c], &s, n);
    }
    finish_sums(terms, t, polynomials);
    if (!by && !terms->apart_count && !terms->has_surface)
        return;
    glint_barycentric_begin(&s, &part->gradients, 16);
    if (by) {
        for (int i = 0; i < 6; i++)
            n[i] = by->square[i] >> 1;
        begin_polynomial(&polynomials[terms->square], &s, n);
    }
    for (int c = 0; c < 3 && terms->has_surface; c++) {
        for (int i = 0; i < 6; i++)
            n[i] = t->surface[i][c];
        begin_polynomial(&polynomials[terms->surface + c], &s, n);
    }
    for (uint32_t a = 0; a < terms->apart_count; a++) {
        const glint_apart *apart = &terms->apart[a];
        glint_quadratic *to = &polynomials[apart->first];
        for (uint32_t kind = 0; kind < GLINT_NUMBERS; kind++)
            if (apart->kinds >> kind & 1) {
                const int32_t *const scale = kind == GLINT_SIDE ? length : kind >= GLINT_LOBE_X ? of_lobe : 0;
                for (int i = 0; i < 6; i++)
                    n[i] = scale_by(scale, i, number_at(terms->light, t, i, apart->light, kind));
                begin_polynomial(to++, &s, n);
            }
    }
}

/* Planes of what the corners keep. @param longer chords are made longer by this, Q15 */
static void begin_planes(const glint_part *part, const candidate *t, int32_t longer, const glint_terms *terms,
                         glint_quadratic polynomials[GLINT_POLYNOMIALS_MAX]) {
    const glint_gradients *g = &part->gradients;
    const int32_t length = (1 << 15) + longer;
    for (uint32_t c = 0; c < terms->sums; c++)
        begin_plane(&polynomials[c], g, sum_at(terms, t, 0, (int)c) * length >> 15,
                    sum_at(terms, t, 1, (int)c) * length >> 15, sum_at(terms, t, 2, (int)c) * length >> 15,
                    unit_of_sums(terms));
    finish_sums(terms, t, polynomials);
    for (uint32_t a = 0; a < terms->apart_count; a++) {
        const glint_apart *apart = &terms->apart[a];
        glint_quadratic *to = &polynomials[apart->first];
        for (uint32_t kind = 0; kind < GLINT_NUMBERS; kind++)
            if (apart->kinds >> kind & 1) {
                const int32_t by = kind == GLINT_STRENGTH ? 1 << 15 : length;
                begin_plane(to++, g, number_at(terms->light, t, 0, apart->light, kind) * by >> 15,
                            number_at(terms->light, t, 1, apart->light, kind) * by >> 15,
                            number_at(terms->light, t, 2, apart->light, kind) * by >> 15, 16);
            }
    }
}

/* ---- Triangles ---- */

/* Do polynomials fit the triangle's shape? */
static int is_shapely(const glint_triangle *triangle, const glint_part *part) {
    const glint_vertex *const *v = triangle->corners;
    return v[0]->flags & v[1]->flags & v[2]->flags & GLINT_VERTEX_LIT && !triangle->back &&
           triangle->area >= GLINT_POLYNOMIAL_LEAST_AREA &&
           glint_slenderness(&part->gradients, triangle->area) <= GLINT_POLYNOMIAL_SLENDER && !glint_is_deep(triangle);
}

int glint_terms_begin(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                      const glint_part *part, glint_terms *terms, glint_quadratic polynomials[GLINT_POLYNOMIALS_MAX]) {
    const glint_region *region;
    const uint32_t limit = draw->shading->terms.limit;
    candidate t;
    lengths by;
    region = &t.region;
    if (!is_shapely(triangle, part))
        return REJECT(1);
    if (!find_region(frame, draw, triangle, &t))
        return REJECT(4);
    if (region->plane_error <= limit && !t.is_fresh) {
        glint_terms_name(frame, draw, region, 0, terms);
        terms->is_curved = 0;
        begin_planes(part, &t, region->folds ? 0 : (int32_t)(region->turn * region->turn >> 13), terms, polynomials);
        return 1;
    }
    const int is_over_length = region->error > 2 * limit;
    if (is_over_length && (region->error_over_length > limit || !find_lengths(triangle, &by)))
        return REJECT(6);
    if (!find_nodes(frame, draw, triangle, &t))
        return REJECT(8);
    const int twice = draw->shading->material->model->lobe == GLINT_LOBE_MIRROR;
    glint_terms_name(frame, draw, region, is_over_length ? 1 + twice : 0, terms);
    begin_quadratics(part, &t, is_over_length ? &by : 0, terms, polynomials);
    return 1;
}
