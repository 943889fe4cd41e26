/* SPDX-License-Identifier: MIT */
/* Terms of a triangle: its nodes, and the polynomials through them if these are close enough. */
#include "corners.h"
#include "fit.h"
#include "lengths.h"

/* ---- Nodes ---- */

/* A node's numbers of a light, as a corner keeps them. */
static void take_kept(const glint_light_terms *light, const int16_t *kept, uint32_t l, glint_node *node) {
    node->number[l][GLINT_STRENGTH] = 1 << 14; /* where none is kept */
    for (uint32_t kind = 0; kind < GLINT_NUMBERS_DRAWN; kind++)
        if (light->at[l][kind])
            node->number[l][kind] = kept[light->at[l][kind]];
}

/* Sums a node's lights, and its highlights. */
static GLINT_INLINE void sum_node(const glint_shading *shading, glint_candidate *t, int i, glint_node *node) {
    glint_node_sum(shading->terms, t->region.held, node);
    for (uint32_t c = 0; c < shading->terms->channels; c++)
        t->sum[i][c] = node->sum[c];
    if (!t->region.summed)
        return;
    glint_node_shine(shading, t->region.summed, node);
    for (int c = 0; c < 3; c++)
        t->shine[i][c] = node->shine[c];
}

/* Sets the corners' sums of the lights that all of them face: as they keep them, if that is of these lights. */
static void sum_corners(const glint_shading *shading, glint_candidate *t) {
    const glint_light_terms *light = shading->terms;
    glint_node node;
    for (int i = 0; i < 3; i++) {
        const int16_t *const kept = t->kept[i], *const rest = kept + light->channels;
        const uint32_t held = t->region.held;
        if (((uint32_t)rest[GLINT_KEPT_FACING] & 0xff) == held) {
            for (uint32_t c = 0; c < light->channels; c++)
                t->sum[i][c] = kept[c];
            for (int c = 0; c < 3 && t->region.summed; c++)
                t->shine[i][c] = rest[GLINT_KEPT_SHINE + c];
            continue;
        }
        for (uint32_t l = 0; held >> l; l++)
            if (held >> l & 1)
                take_kept(light, kept, l, &node);
        sum_node(shading, t, i, &node);
    }
}

/*
 * Under lights without a position, numbers between corners are those of the corners over |M|, M the normal over w. With
 * r = wa wb |Na - Nb|^2 / (wa + wb)^2, |M| = (wa + wb) sqrt(1 - r) / 2; the root's inverse by its series.
 */
static void find_shares(const glint_triangle *triangle, glint_candidate *t) {
    const glint_vertex *const *v = triangle->corners;
    for (int e = 0; e < 3; e++) {
        const uint32_t a = (uint32_t)v[glint_ends[e][0]]->inverse_w, b = (uint32_t)v[glint_ends[e][1]]->inverse_w;
        const unsigned zeros = glint_leading_zeros((a >> 1) + (b >> 1));
        const uint32_t wa = (a >> 1) << zeros >> 16, wb = (b >> 1) << zeros >> 16; /* the sum has 16 bits */
        const uint32_t reciprocal = (uint32_t)glint_reciprocal16(wa + wb < 1u << 15 ? 1u << 15 : wa + wb);
        const uint32_t of_a = wa * reciprocal >> 16, of_b = wb * reciprocal >> 16;                   /* Q15 */
        const uint32_t r = (of_a * of_b >> 15) * (uint32_t)glint_shift_right(t->apart[e], 11) >> 15; /* Q15 */
        const uint32_t longer = (1u << 15) + (r * ((1u << 14) + (r * ((3u << 12) + (r * 5 >> 4)) >> 15)) >> 15);
        t->share[e][0] = (int32_t)(of_a * longer >> 15);
        t->share[e][1] = (int32_t)(of_b * longer >> 15);
    }
}

static inline int32_t mix_ends(const glint_candidate *t, int e, int32_t a, int32_t b) {
    return glint_shift_right(t->share[e][0] * a + t->share[e][1] * b + (1 << 14), 15);
}

/* Sums of middles that are found from the corners. */
static void mix_sums(const glint_shading *shading, glint_candidate *t) {
    const uint32_t summed = t->region.summed;
    for (int e = 0; e < 3; e++) {
        const int from = glint_ends[e][0], to = glint_ends[e][1];
        glint_node node;
        for (uint32_t c = 0; c < shading->terms->channels; c++)
            t->sum[3 + e][c] = mix_ends(t, e, t->sum[from][c], t->sum[to][c]);
        if (!summed)
            continue;
        for (uint32_t l = 0; summed >> l; l++) {
            const uint8_t *const at = shading->terms->at[l];
            node.number[l][GLINT_STRENGTH] = 1 << 14;
            for (uint32_t kind = GLINT_LOBE_X; kind <= GLINT_LOBE_Y && summed >> l & 1; kind++)
                node.number[l][kind] = (int16_t)mix_ends(t, e, t->kept[from][at[kind]], t->kept[to][at[kind]]);
        }
        glint_node_shine(shading, summed, &node);
        for (int c = 0; c < 3; c++)
            t->shine[3 + e][c] = node.shine[c];
    }
}

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

/* Finds the nodes between corners. @return 0 where polynomials through them do not fit */
static int light_middles(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                         glint_candidate *t) {
    const glint_region *region = &t->region;
    glint_node *const to[3] = {&t->middle[0], &t->middle[1], &t->middle[2]};
    glint_fragments at;
    uint32_t unfit = 0;
    if (t->is_between) {
        find_shares(triangle, t);
        mix_sums(draw->shading, t);
        return 1;
    }
    at.count = 0;
    for (int e = 0; e < 3; e++)
        gather_middle(frame, triangle->corners[glint_ends[e][0]], triangle->corners[glint_ends[e][1]], &at);
    glint_nodes_light(frame, draw->shading, &at, region->held | region->sides | region->lobes,
                      region->lobes | region->summed, to);
    for (int e = 0; e < 3; e++) {
        sum_node(draw->shading, t, 3 + e, to[e]);
        unfit |= (to[e]->unfit & (region->lobes | region->summed)) | (to[e]->far & region->lobes) |
                 (to[e]->steep & region->cones);
    }
    return !unfit;
}

/* ---- Polynomials ---- */

/* Where polynomials go. */
typedef struct target {
    const glint_part *part;
    const glint_terms *terms;
    glint_polynomials *polynomials;
} target;

static inline void set(const target *to, uint32_t i, glint_quadratic q, uint32_t more) {
    glint_polynomial_set(to->terms, to->part, i, q, more, to->polynomials);
}

/* A light's numbers at the nodes, the first so many. */
static inline void take_numbers(const glint_light_terms *light, const glint_candidate *t, uint32_t l, uint32_t kind,
                                int count, int32_t n[6]) {
    for (int i = 0; i < 3; i++)
        n[i] = t->kept[i][light->at[l][kind]];
    for (int e = 0; 3 + e < count; e++)
        n[3 + e] =
            t->is_between ? mix_ends(t, e, n[glint_ends[e][0]], n[glint_ends[e][1]]) : t->middle[e].number[l][kind];
}

static inline void take_sums(const glint_terms *terms, const glint_candidate *t, int c, int count, int32_t n[6]) {
    if (!terms->is_channels) {
        for (int i = 0; i < count; i++)
            n[i] = t->sum[i][c];
        return;
    }
    for (int i = 0; i < count; i++)
        n[i] = glint_sum_at(terms, t->sum[i], t->shine[i], c, t->has_surface ? t->surface[i] : 0);
}

/* Numbers times their nodes' lengths, or their squares. */
static void scale_by_lengths(int32_t n[6], const int32_t by[6]) {
    for (int i = 0; i < 6 && by; i++)
        n[i] = glint_shift_right(n[i] * by[i] + (1 << 14), 15);
}

/* What is added to sum c. */
static uint32_t finish_of(const glint_terms *terms, const glint_candidate *t, uint32_t c) {
    if (!terms->is_channels)
        return terms->sums == 1 ? 1 << 15 : 0;
    return terms->is_over_length ? 0 : glint_finish_of(terms, t->has_surface, (int)c);
}

/* Binary logarithm of what 1 is in polynomials of sums, over what it is at nodes. */
static unsigned unit_of_sums(const glint_terms *terms) {
    return terms->sums == 1 ? 16 : 12 + terms->light->sum_bits;
}

static void begin_term_quadratics(const glint_candidate *t, const glint_lengths *by, const glint_terms *terms,
                                  const target *to) {
    const glint_gradients *const g = &to->part->gradients;
    const int32_t *const length = by ? by->length : 0;
    const int32_t *const of_lobe = by && terms->is_over_length > 1 ? by->square : length;
    glint_barycentric s;
    int32_t n[6];
    glint_barycentric_begin(&s, g, (int32_t)unit_of_sums(terms));
    for (uint32_t c = 0; c < terms->sums; c++) {
        take_sums(terms, t, (int)c, 6, n);
        scale_by_lengths(n, length);
        set(to, c, glint_fit_quadratic(&s, n), finish_of(terms, t, c));
    }
    if (terms->end == terms->sums)
        return;
    if (terms->sums > 1)
        glint_barycentric_begin(&s, g, 16);
    if (by) {
        for (int i = 0; i < 6; i++)
            n[i] = by->square[i] >> 1;
        set(to, terms->square, glint_fit_quadratic(&s, n), 0);
    }
    for (uint32_t c = 0; c < 3 && terms->has_surface; c++) {
        for (int i = 0; i < 6; i++)
            n[i] = t->surface[i][c];
        set(to, terms->surface + c, glint_fit_quadratic(&s, n), 0);
    }
    for (uint32_t a = 0; a < terms->apart_count; a++) {
        const glint_apart *apart = &terms->apart[a];
        uint32_t next = apart->first;
        for (uint32_t kind = 0; kind < GLINT_NUMBERS_DRAWN; kind++)
            if (apart->kinds >> kind & 1) {
                take_numbers(terms->light, t, apart->light, kind, 6, n);
                scale_by_lengths(n, kind == GLINT_SIDE ? length : kind >= GLINT_LOBE_X ? of_lobe : 0);
                set(to, next++, glint_fit_quadratic(&s, n), 0);
            }
    }
}

/* A highlight may end at once at a terminator: polynomials do not tell just where. */
static int has_edge(const glint_shading *shading, const glint_candidate *t) {
    const uint32_t gated = shading->material->flags & GLINT_MATERIAL_UNGATED ? 0 : t->region.sides & t->region.lobes;
    int32_t n[6];
    for (uint32_t l = 0; gated >> l; l++)
        if (gated >> l & 1) {
            take_numbers(shading->terms, t, l, GLINT_SIDE, 6, n);
            if (!glint_triangle_keeps_side(n, t->region.margin))
                return 1;
        }
    return 0;
}

/* Planes of what the corners keep. @param longer chords are made longer by this, Q15 */
static void begin_term_planes(const glint_candidate *t, int32_t longer, const glint_terms *terms, const target *to) {
    const glint_gradients *g = &to->part->gradients;
    const int32_t length = (1 << 15) + longer;
    int32_t n[6];
    for (uint32_t c = 0; c < terms->sums; c++) {
        take_sums(terms, t, (int)c, 3, n);
        set(to, c, glint_fit_plane(g, n, length, unit_of_sums(terms)), finish_of(terms, t, c));
    }
    for (uint32_t a = 0; a < terms->apart_count; a++) {
        const glint_apart *apart = &terms->apart[a];
        uint32_t next = apart->first;
        for (uint32_t kind = 0; kind < GLINT_NUMBERS_DRAWN; kind++)
            if (apart->kinds >> kind & 1) {
                const int32_t by = kind == GLINT_STRENGTH ? 1 << 15 : length;
                take_numbers(terms->light, t, apart->light, kind, 3, n);
                set(to, next++, glint_fit_plane(g, n, by, 16), 0);
            }
    }
}

/* ---- Triangles ---- */

/* Do polynomials fit the triangle's shape? */
static int is_shapely(const glint_triangle *triangle, const glint_part *part) {
    const glint_vertex *const *v = triangle->corners;
    return v[0]->flags & v[1]->flags & v[2]->flags & GLINT_VERTEX_LIT && !triangle->back &&
           glint_slenderness(&part->gradients, triangle->area) <= GLINT_POLYNOMIAL_SLENDER && !glint_is_deep(triangle);
}

/* May middles be found from the corners? */
static int is_between(const glint_frame *frame, const glint_shading *shading, const glint_region *region) {
    uint32_t positions = 0;
    const uint32_t lobes = region->lobes | region->summed;
    for (uint32_t l = 0, shown = region->held | region->sides | lobes; shown >> l; l++)
        positions |= shown >> l & 1 && frame->view->lights[l].type->illuminate;
    return !positions && !(lobes && shading->material->model->lobe == GLINT_LOBE_MIRROR) && region->turn < 3072;
}

/* Polynomials that are close enough: none, planes, quadratics, or quadratics over length. */
enum { FIT_NONE, FIT_PLANES, FIT_QUADRATICS, FIT_OVER_LENGTH };

/* Which of them are, for highlights as they stand? Sets whether nodes between corners may be found from these. */
static int choose_fit(const glint_frame *frame, const glint_shading *shading, glint_candidate *t) {
    const uint32_t limit = shading->terms->limit;
    glint_region *const region = &t->region;
    if (!(region->sides & region->lobes) && !region->has_edge &&
        glint_plane_error(shading, t->has_surface, region) <= limit)
        return FIT_PLANES;
    if (!glint_region_bound(frame, shading, region))
        return FIT_NONE;
    const int is_over_length = region->error > 2 * limit;
    const uint32_t error = is_over_length ? region->error_over_length : region->error,
                   most = is_over_length ? limit : 2 * limit;
    if (error > most)
        return FIT_NONE;
    t->is_between = error + region->error_between <= most && is_between(frame, shading, region);
    return is_over_length ? FIT_OVER_LENGTH : FIT_QUADRATICS;
}

int glint_terms_begin(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                      const glint_part *part, glint_terms *terms, glint_polynomials *polynomials) {
    const glint_shading *shading = draw->shading;
    glint_candidate t;
    glint_region *const region = &t.region;
    glint_lengths by;
    const target to = {part, terms, polynomials};
    if (!is_shapely(triangle, part) || !glint_find_region(frame, draw, triangle, &t))
        return 0;
    int fit = glint_region_sum_lobes(shading, t.has_surface, region) ? choose_fit(frame, shading, &t) : FIT_NONE;
    if (fit == FIT_NONE) {
        glint_region_part_lobes(region);
        fit = choose_fit(frame, shading, &t);
    }
    if (fit == FIT_NONE || (fit == FIT_OVER_LENGTH && !glint_find_lengths(triangle, &by)))
        return 0;
    sum_corners(shading, &t);
    if (fit == FIT_PLANES) {
        glint_terms_name(frame, draw, region, 0, terms);
        terms->is_curved = 0;
        const int32_t longer = region->folds || region->summed ? 0 : (int32_t)(region->turn * region->turn / 12 >> 9);
        begin_term_planes(&t, longer, terms, &to);
        return 1;
    }
    if (!light_middles(frame, draw, triangle, &t))
        return 0;
    if (fit == FIT_OVER_LENGTH)
        region->margin = region->margin_over_length;
    region->has_edge |= has_edge(shading, &t);
    const int twice = shading->material->model->lobe == GLINT_LOBE_MIRROR;
    glint_terms_name(frame, draw, region, fit == FIT_OVER_LENGTH ? 1 + twice : 0, terms);
    begin_term_quadratics(&t, fit == FIT_OVER_LENGTH ? &by : 0, terms, &to);
    return 1;
}
