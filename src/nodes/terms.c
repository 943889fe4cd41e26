/* SPDX-License-Identifier: MIT */
/* Terms of a triangle: its nodes, and the polynomials through them if these are close enough. */
#include "corners.h"
#include "fit.h"
#include "lengths.h"

/* ---- Polynomials ---- */

/* Where polynomials go. */
typedef struct terms_target {
    const glint_part *part;
    const glint_terms *terms;
    glint_polynomials *polynomials;
} terms_target;

/* Numbers at the corners, and by how much edges bulge: 4 times what their middles have, less twice both ends. */
typedef struct bulged_numbers {
    int32_t corner[3], bulge[3];
} bulged_numbers;

/* Sets polynomial number i, times 2^unit, which begins with so much more. */
static void set_quadratic(const terms_target *to, glint_barycentric *s, uint32_t i, const bulged_numbers *n,
                          unsigned unit, uint32_t more) {
    glint_quadratic *const q = &to->polynomials->of[i];
    if (s->unit != unit)
        glint_barycentric_begin(s, &to->part->gradients, (int32_t)unit);
    glint_polynomial_begin(q, s, n->corner, n->bulge);
    q->start += more;
}

static inline int32_t times_length(int32_t n, int32_t length) {
    return glint_shift_right(n * length + (1 << 14), 15);
}

/* Sets it to a plane of numbers times `by`, Q15. */
static void set_plane(const terms_target *to, uint32_t i, const int32_t n[3], int32_t by, unsigned unit,
                      uint32_t more) {
    glint_quadratic *const q = &to->polynomials->of[i];
    glint_fit_plane(q, &to->part->gradients, n, by, unit);
    q->start += more;
}

/*
 * To numbers times lengths whose middles are found from the corners: they are linear over w, and what they are divided
 * by is |M|.
 */
static void set_straight(const terms_target *to, uint32_t i, int32_t n[3], const int32_t length[3], unsigned unit,
                         uint32_t more) {
    glint_plane plane;
    for (int c = 0; c < 3; c++)
        n[c] = times_length(n[c], length[c]);
    if (GLINT_SMALL) {
        set_plane(to, i, n, 1 << 15, unit, more);
        return;
    }
    glint_plane_begin(&plane, &to->part->gradients, glint_shift_left(n[0], unit), glint_shift_left(n[1], unit),
                      glint_shift_left(n[2], unit));
    glint_quadratic_of(&to->polynomials->of[i], &plane);
    to->polynomials->of[i].start += more;
}

/* Sets the bulge of edge e from a number at its middle. */
static inline void set_bulge(bulged_numbers *n, int e, int32_t middle) {
    n->bulge[e] = 4 * middle - 2 * (n->corner[glint_ends[e][0]] + n->corner[glint_ends[e][1]]);
}

/* Sets bulges from what middles have, which is in their place; all of it times lengths, or as it is. */
static void pass_through(bulged_numbers *n, const int32_t *length) {
    for (int i = 0; i < 3 && length; i++) {
        n->corner[i] = times_length(n->corner[i], length[i]);
        n->bulge[i] = times_length(n->bulge[i], length[3 + i]);
    }
    for (int e = 0; e < 3; e++)
        set_bulge(n, e, n->bulge[e]);
}

/* Sets bulges where middles are found from the corners. */
static inline void mix_bulges(const glint_candidate *t, bulged_numbers *n) {
    for (int e = 0; e < 3; e++)
        n->bulge[e] = glint_mix_bulge(t, e, n->corner[glint_ends[e][0]], n->corner[glint_ends[e][1]]);
}

/* Are a light's numbers of a kind at the middles found from the corners? */
static inline int is_mixed_kind(const glint_candidate *t, uint32_t kind) {
    return kind >= GLINT_LOBE_X ? t->is_between : t->is_mixed;
}

static inline void take_corners(const glint_light_terms *light, const glint_candidate *t, uint32_t l, uint32_t kind,
                                int32_t n[3]) {
    const uint8_t at = light->at[l][kind];
    n[0] = t->kept[0][at];
    n[1] = t->kept[1][at];
    n[2] = t->kept[2][at];
}

/* A light's numbers, times lengths at the nodes, or their squares, or as they are. */
static void take_numbers(const glint_light_terms *light, const glint_candidate *t, uint32_t l, uint32_t kind,
                         const int32_t *length, bulged_numbers *n) {
    take_corners(light, t, l, kind, n->corner);
    if (is_mixed_kind(t, kind)) {
        mix_bulges(t, n);
        return;
    }
    for (int e = 0; e < 3; e++)
        n->bulge[e] = t->middle[e].number[l][kind];
    pass_through(n, length);
}

/* A sum at a node. */
static inline int32_t sum_at(const glint_terms *terms, const glint_candidate *t, int i, uint32_t c) {
    return terms->is_channels ? glint_sum_at(terms, t->sum[i], t->shine[i], (int)c, t->has_surface ? t->surface[i] : 0)
                              : t->sum[i][c];
}

/* Do sums at the middles follow from those at the corners? */
static inline int is_mixed_sum(const glint_candidate *t) {
    return t->is_mixed && !t->region.summed && !t->region.folds;
}

/* Sum c, times lengths at the nodes, or as it is. */
static void take_sums(const glint_terms *terms, const glint_candidate *t, uint32_t c, const int32_t *length,
                      bulged_numbers *n) {
    for (int i = 0; i < 3; i++)
        n->corner[i] = sum_at(terms, t, i, c);
    if (is_mixed_sum(t)) {
        mix_bulges(t, n);
        return;
    }
    for (int e = 0; e < 3; e++)
        n->bulge[e] = sum_at(terms, t, 3 + e, c);
    pass_through(n, length);
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

/* Those of a light with terms of its own. */
static void begin_light(const glint_candidate *t, const glint_lengths *by, const glint_apart *apart,
                        const terms_target *to, glint_barycentric *s) {
    const glint_light_terms *const light = to->terms->light;
    uint32_t next = apart->first;
    bulged_numbers n;
    for (uint32_t kind = 0; apart->kinds >> kind; kind++) {
        const int32_t *length = 0;
        if (!(apart->kinds >> kind & 1))
            continue;
        if (by && (kind == GLINT_SIDE || kind >= GLINT_LOBE_X))
            length = kind != GLINT_SIDE && to->terms->is_over_length > 1 ? by->square : by->length;
        if (length && is_mixed_kind(t, kind)) {
            take_corners(light, t, apart->light, kind, n.corner);
            set_straight(to, next++, n.corner, length, 16, glint_half_of(kind));
        } else {
            take_numbers(light, t, apart->light, kind, length, &n);
            set_quadratic(to, s, next++, &n, 16, glint_half_of(kind));
        }
    }
}

/* Those of sums. */
static void begin_sums_of(const glint_candidate *t, const glint_lengths *by, const terms_target *to,
                          glint_barycentric *s) {
    const glint_terms *const terms = to->terms;
    const unsigned unit = unit_of_sums(terms);
    bulged_numbers n;
    for (uint32_t c = 0; c < terms->sums; c++) {
        const uint32_t more = finish_of(terms, t, c);
        if (by && is_mixed_sum(t)) {
            for (int i = 0; i < 3; i++)
                n.corner[i] = sum_at(terms, t, i, c);
            set_straight(to, c, n.corner, by->length, unit, more);
        } else {
            take_sums(terms, t, c, by ? by->length : 0, &n);
            set_quadratic(to, s, c, &n, unit, more);
        }
    }
}

static void begin_term_quadratics(const glint_candidate *t, const glint_lengths *by, const glint_terms *terms,
                                  const terms_target *to) {
    glint_barycentric s;
    bulged_numbers n;
    s.unit = 0; /* it has not begun */
    begin_sums_of(t, by, to, &s);
    if (by) {
        for (int i = 0; i < 3; i++)
            n.corner[i] = by->square[i] >> 1;
        for (int e = 0; e < 3; e++)
            set_bulge(&n, e, by->square[3 + e] >> 1);
        set_quadratic(to, &s, terms->square, &n, 16, 0);
    }
    for (uint32_t c = 0; c < 3 && terms->has_surface; c++) {
        for (int i = 0; i < 3; i++)
            n.corner[i] = t->surface[i][c];
        for (int e = 0; e < 3; e++)
            set_bulge(&n, e, t->surface[3 + e][c]);
        set_quadratic(to, &s, terms->surface + c, &n, 16, 0);
    }
    for (uint32_t a = 0; a < terms->apart_count; a++)
        begin_light(t, by, &terms->apart[a], to, &s);
}

/*
 * A highlight may end at once at a terminator: polynomials do not tell just where. Lengths are at most 1: numbers that
 * are no more over them keep their side if these do.
 */
static int has_edge(const glint_shading *shading, const glint_candidate *t, const glint_lengths *by) {
    const uint32_t gated = shading->material->flags & GLINT_MATERIAL_UNGATED ? 0 : t->region.sides & t->region.lobes;
    bulged_numbers n;
    n.bulge[0] = n.bulge[1] = n.bulge[2] = 0;
    for (uint32_t l = 0; gated >> l; l++)
        if (gated >> l & 1) {
            if (by && t->is_mixed) {
                take_corners(shading->terms, t, l, GLINT_SIDE, n.corner);
                for (int i = 0; i < 3; i++)
                    n.corner[i] = times_length(n.corner[i], by->length[i]);
            } else {
                take_numbers(shading->terms, t, l, GLINT_SIDE, by ? by->length : 0, &n);
            }
            if (!glint_triangle_keeps_side(n.corner, n.bulge, t->region.margin))
                return 1;
        }
    return 0;
}

/* Planes of what the corners keep. @param longer chords are made longer by this, Q15 */
static void begin_term_planes(const glint_candidate *t, int32_t longer, const glint_terms *terms,
                              const terms_target *to) {
    const int32_t length = (1 << 15) + longer;
    int32_t n[3];
    for (uint32_t c = 0; c < terms->sums; c++) {
        for (int i = 0; i < 3; i++)
            n[i] = sum_at(terms, t, i, c);
        set_plane(to, c, n, length, unit_of_sums(terms), finish_of(terms, t, c));
    }
    for (uint32_t a = 0; a < terms->apart_count; a++) {
        const glint_apart *apart = &terms->apart[a];
        uint32_t next = apart->first;
        for (uint32_t kind = 0; apart->kinds >> kind; kind++)
            if (apart->kinds >> kind & 1) {
                take_corners(terms->light, t, apart->light, kind, n);
                set_plane(to, next++, n, kind == GLINT_STRENGTH ? 1 << 15 : length, 16, glint_half_of(kind));
            }
    }
}

/* ---- Triangles ---- */

/* Do polynomials fit the triangle's shape? */
static int is_shapely(const glint_triangle *triangle, const glint_part *part) {
    return glint_slenderness(&part->gradients, triangle->area) <= GLINT_SLENDER;
}

/* Do a triangle's corners keep light? */
static int is_lit_at_corners(const glint_triangle *triangle) {
    const glint_vertex *const *v = triangle->corners;
    return v[0]->flags & v[1]->flags & v[2]->flags & GLINT_VERTEX_LIT;
}

/* May numbers at the middles, but for those of highlights, be found from the corners? */
static int is_mixed(const glint_shading *shading, const glint_region *region, int is_over_length) {
    const uint32_t shown = region->held | region->sides | region->lobes | region->summed;
    return !(shading->terms->placed & shown) && (region->turn < 3072 || (is_over_length && !region->folds));
}

/* Polynomials that are close enough: none, planes, quadratics, or quadratics over length. */
enum { FIT_NONE, FIT_PLANES, FIT_QUADRATICS, FIT_OVER_LENGTH };

/* Which of them are, for highlights as they stand? Sets what of nodes between corners may be found from these. */
static int choose_fit(const glint_frame *frame, const glint_shading *shading, glint_candidate *t) {
    const uint32_t limit = shading->terms->limit, most = shading->terms->most;
    glint_region *const region = &t->region;
    if (!(region->sides & region->lobes) && !region->has_edge &&
        glint_plane_error(shading, t->has_surface, region) <= limit)
        return FIT_PLANES;
    if (!glint_region_bound(frame, shading, region))
        return FIT_NONE;
    const int is_over_length = region->error > most;
    const uint32_t error = is_over_length ? glint_error_over_length(frame, shading, region) : region->error;
    if (error > most)
        return FIT_NONE;
    t->is_mixed = (uint8_t)is_mixed(shading, region, is_over_length);
    t->is_straight = (uint8_t)(is_over_length && !region->folds);
    t->is_between = t->is_mixed && (!(region->lobes | region->summed) ||
                                    (region->turn < 3072 && shading->material->model->lobe != GLINT_LOBE_MIRROR &&
                                     error + glint_error_between(shading, region) <= most));
    return is_over_length ? FIT_OVER_LENGTH : FIT_QUADRATICS;
}

/* Finds polynomials of a triangle whose region they may fit. @return 0 where they do not */
static int begin_candidate(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                           glint_candidate *t, const terms_target *to, glint_terms *terms) {
    const glint_shading *shading = draw->shading;
    const glint_part *part = to->part;
    glint_region *const region = &t->region;
    glint_lengths by;
    int fit = glint_region_sum_lobes(shading, t->has_surface, region) ? choose_fit(frame, shading, t) : FIT_NONE;
    if (fit == FIT_NONE) {
        glint_region_part_lobes(region);
        fit = choose_fit(frame, shading, t);
    }
    if (fit == FIT_NONE || (fit == FIT_OVER_LENGTH && !glint_find_lengths(triangle, t->apart, &by)))
        return 0;
    glint_sum_corners(shading, t);
    if (fit == FIT_PLANES) {
        glint_terms_name(frame, draw, region, 0, terms);
        terms->is_curved = 0;
        const int32_t longer = region->folds || region->summed ? 0 : (int32_t)(region->turn * region->turn / 12 >> 9);
        begin_term_planes(t, longer, terms, to);
        return 1;
    }
    const int twice = shading->material->model->lobe == GLINT_LOBE_MIRROR; /* R turns as far as that */
    const uint32_t apart = (uint32_t)glint_most_of(t->apart[0], t->apart[1], t->apart[2]);
    if (!glint_keeps_digits(&part->gradients, triangle->area, apart << twice))
        return 0;
    const glint_lengths *const over = fit == FIT_OVER_LENGTH ? &by : 0;
    if (over && (!t->is_between || !t->is_straight))
        glint_find_middle_lengths(&by);
    if (!glint_find_middles(frame, draw, triangle, t))
        return 0;
    region->has_edge |= has_edge(shading, t, over);
    glint_terms_name(frame, draw, region, over ? 1 + twice : 0, terms);
    begin_term_quadratics(t, over, terms, to);
    return 1;
}

int glint_terms_begin(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                      const glint_part *part, glint_terms *terms, glint_polynomials *polynomials, glint_reach *reach) {
    const terms_target to = {part, terms, polynomials};
    const int is_lit = is_lit_at_corners(triangle);
    glint_candidate t;
    const int is_known = is_lit && glint_find_region(frame, draw, triangle, &t);
    if (is_known && is_shapely(triangle, part) && begin_candidate(frame, draw, triangle, &t, &to, terms))
        return 1;
    if (is_lit)
        *reach = glint_reach_of(draw, &t.region, is_known);
    else
        *reach = (glint_reach){draw->unreached, draw->shading->terms->lobes & ~draw->unreached};
    return 0;
}
