/* SPDX-License-Identifier: MIT */
/*
 * Cells: a triangle's light on squares of the screen's lattice, by quadratics next to three rows of three nodes; and
 * polynomials of any region whose nodes are all there.
 */
#include "angles.h"
#include "nearness.h"
#include "shapes.h"

/* ---- What is known from the nodes ---- */

/*
 * From corner to corner; of a cell that is no less than twice what it is from the centre to a corner, or between nodes
 * along an edge: where normals between corners nearly cancel, most of their turn is on one side.
 */
static uint32_t find_shape_turn(const glint_shape *shape, glint_node *const nodes[]) {
    static const uint8_t around[9] = {0, 1, 2, 5, 8, 7, 6, 3, 0};
    int32_t turn = 0, half = 0;
    for (int i = 0; i < 3; i++)
        for (int j = i + 1; j < 4; j++)
            turn = glint_most(turn,
                              glint_square_apart(nodes[shape->corners[i]]->normal, nodes[shape->corners[j]]->normal));
    for (int i = 0; i < 4 && shape->shift; i++)
        half = glint_most(half, glint_square_apart(nodes[shape->corners[i]]->normal, nodes[4]->normal));
    for (int i = 0; i < 8 && shape->shift; i++)
        half = glint_most(half, glint_square_apart(nodes[around[i]]->normal, nodes[around[i + 1]]->normal));
    return glint_root_above((uint32_t)glint_most(turn >> 2, half));
}

/* @return 0 where a node lies behind the eye, or beyond what 1/w tells */
static int find_w_range(const glint_shape *shape, glint_node *const nodes[], glint_w_range *w) {
    int32_t least = INT32_MAX, most = 0;
    for (int i = 0; i < 4; i++) {
        least = glint_least(least, nodes[shape->corners[i]]->inverse_w);
        most = glint_most(most, nodes[shape->corners[i]]->inverse_w);
    }
    if (least < 1 << 16)
        return 0;
    w->least = (uint32_t)least >> 15;
    w->change = ((uint32_t)most >> 15) - w->least + 1;
    return 1;
}

/* By how much the surface's colours differ, Q12; too much where they end at what a node holds. */
static uint32_t find_colour(const glint_shape *shape, glint_node *const nodes[]) {
    int32_t apart = 0;
    for (int c = 0; c < 3; c++) {
        int32_t least = INT32_MAX, most = INT32_MIN;
        for (int i = 0; i < 4; i++) {
            least = glint_least(least, nodes[shape->corners[i]]->surface[c]);
            most = glint_most(most, nodes[shape->corners[i]]->surface[c]);
        }
        if (least == -INT16_MAX || most == INT16_MAX)
            return GLINT_WIDEST + 1;
        apart = glint_most(apart, most - least);
    }
    return (uint32_t)apart >> 2;
}

/* Where a highlight lies at the nodes. */
static glint_lobe_range find_shape_lobe(const glint_shape *shape, glint_node *const nodes[], uint32_t l) {
    glint_lobe_range range = glint_lobe_range_of(nodes[0]->number[l][GLINT_LOBE_X], nodes[0]->number[l][GLINT_LOBE_Y]);
    for (uint32_t i = 1; i < shape->count; i++)
        glint_lobe_range_take(&range, nodes[i]->number[l][GLINT_LOBE_X], nodes[i]->number[l][GLINT_LOBE_Y]);
    return range;
}

/* Does a light keep its side all over a region, whatever its polynomial is off by? */
static int shape_keeps_side(const glint_shape *shape, glint_node *const nodes[], uint32_t l, int32_t margin) {
    int32_t least = nodes[0]->number[l][GLINT_SIDE], most = least;
    for (uint32_t i = 1; i < shape->count; i++) {
        least = glint_least(least, nodes[i]->number[l][GLINT_SIDE]);
        most = glint_most(most, nodes[i]->number[l][GLINT_SIDE]);
    }
    return 8 * (least - margin) > most - least || 8 * (most + margin) < least - most;
}

/* A highlight may end at once at a terminator: polynomials do not tell just where. */
static int shape_has_edge(const glint_shading *shading, const glint_region *region, const glint_shape *shape,
                          glint_node *const nodes[]) {
    const uint32_t gated = shading->material->flags & GLINT_MATERIAL_UNGATED ? 0 : region->sides & region->lobes;
    for (uint32_t l = 0; gated >> l; l++)
        if (gated >> l & 1 && !shape_keeps_side(shape, nodes, l, region->margin))
            return 1;
    return 0;
}

/* Sets how near lights are to a region at most, how strong and on which side, from so many of its nodes. */
static void find_nodes_nearness(uint32_t lights, uint32_t count, glint_node *const nodes[], glint_region *region) {
    for (uint32_t l = 0; lights >> l; l++) {
        uint32_t nearness = 0x7f;
        int32_t strength = 0;
        glint_interval side = {INT16_MAX, INT16_MIN};
        for (uint32_t i = 0; i < count && lights >> l & 1; i++) {
            const int16_t *const number = nodes[i]->number[l];
            nearness = glint_nearness_of_both(nearness, (uint16_t)number[GLINT_NEARNESS]);
            strength = glint_most(strength, number[GLINT_STRENGTH]);
            glint_interval_take(&side, number[GLINT_SIDE]);
        }
        region->nearness[l] = (uint16_t)nearness;
        region->strength[l] = (uint16_t)strength;
        region->side_least[l] = (int16_t)side.least;
        region->side_most[l] = (int16_t)side.most;
    }
}

uint32_t glint_shape_away(const glint_draw *draw, const glint_shape *shape, glint_node *const nodes[]) {
    glint_node *corners[4];
    glint_region region;
    glint_w_range w;
    uint32_t outside = 0xff, left = 0;
    region.outside = 0xffff;
    for (int i = 0; i < 4; i++) {
        corners[i] = nodes[shape->corners[i]];
        region.outside &= corners[i]->outside;
        left |= corners[i]->left;
    }
    outside &= region.outside;
    if (!outside || !find_w_range(shape, nodes, &w))
        return 0;
    glint_region_measure(draw->shading->terms->pixel, shape->longest, &w, &region);
    /* lights that a corner has no numbers of are away from all that the shape was cut from */
    find_nodes_nearness(outside & ~left, 4, corners, &region);
    return (outside & left) | glint_region_place(outside, outside & ~left, &region);
}

static int find_shape_region(const glint_frame *frame, const glint_draw *draw, const glint_shape *shape,
                             glint_node *const nodes[], glint_region *region) {
    const glint_shading *shading = draw->shading;
    glint_w_range w;
    if (!find_w_range(shape, nodes, &w))
        return 0;
    region->turn = find_shape_turn(shape, nodes);
    glint_region_measure(shading->terms->pixel, shape->longest, &w, region);
    region->levels = 0;
    region->lit = region->dark = 0xff;
    region->outside = 0xffff;
    region->far = region->unfit = region->steep = region->left = 0;
    for (uint32_t i = 0; i < shape->count; i++) {
        const glint_node *node = nodes[i];
        region->lit &= node->lit;
        region->dark &= node->dark;
        region->outside &= node->outside;
        region->far |= node->far;
        region->unfit |= node->unfit;
        region->steep |= node->steep;
        region->left |= node->left;
        region->levels = node->levels > region->levels ? node->levels : region->levels;
    }
    find_nodes_nearness(shading->lights & ~region->left, shape->count, nodes, region);
    region->colour = draw->extra ? find_colour(shape, nodes) : 0;
    const uint32_t lobes = glint_region_sort(frame, shading, region) & shape->lobes;
    region->lobes = region->slope = 0;
    region->has_edge = 0;
    for (uint32_t l = 0; lobes >> l; l++)
        if (lobes >> l & 1) {
            const glint_lobe_bounds bounds = /* nodes lie half as far apart as corners */
                glint_find_lobe_bounds(shading, glint_lobe_bulge(shading, region, l) / 4);
            const glint_lobe_range range = find_shape_lobe(shape, nodes, l);
            glint_region_add_lobe(shading, &bounds, l, &range, region);
        }
    return glint_region_fits(shading, draw->extra != 0, region);
}

/* Are quadratics close enough? */
static int shape_fits(const glint_frame *frame, const glint_shading *shading, glint_region *region) {
    return glint_region_bound(frame, shading, region) && region->error <= shading->terms->most;
}

/* ---- Polynomials ---- */

/*
 * With u and v from -1 to 1 across a cell, a + (b u + c v + p u^2 + q v^2 + 2 r u v) / 8. Rows and columns through the
 * middle weigh twice: of what is of the third degree that leaves no more than 0.0155 of its derivative times the
 * diagonal's cube.
 */
static int fit_cell(const glint_shape *shape, const int32_t n[], int unit, glint_quadratic *to) {
    const int32_t r = n[8] - n[6] - n[2] + n[0], b = (n[2] - n[0]) + 2 * (n[5] - n[3]) + (n[8] - n[6]),
                  c = (n[6] - n[0]) + 2 * (n[7] - n[1]) + (n[8] - n[2]),
                  p = (n[0] - 2 * n[1] + n[2]) + 2 * (n[3] - 2 * n[4] + n[5]) + (n[6] - 2 * n[7] + n[8]),
                  q = (n[0] - 2 * n[3] + n[6]) + 2 * (n[1] - 2 * n[4] + n[7]) + (n[2] - 2 * n[5] + n[8]);
    const unsigned whole = (unsigned)unit - 3, once = whole - shape->shift, twice = once - shape->shift;
    to->start = (uint32_t)(8 * n[4] - b - c + p + q + 2 * r) << whole;
    to->dx = (uint32_t)(b - 2 * p - 2 * r) << once;
    to->dy = (uint32_t)(c - 2 * q - 2 * r) << once;
    to->dxx = (uint32_t)p << twice;
    to->dxy = (uint32_t)(2 * r) << twice;
    to->dyy = (uint32_t)q << twice;
    glint_quadratic_move(to, shape->x, shape->y);
    return 1;
}

void glint_shape_cell(const glint_part *part, uint32_t lobes, int32_t x, int32_t y, unsigned shift,
                      glint_shape *shape) {
    const uint32_t size = 32u << shift; /* twice the nodes' distance, 28.4 */
    *shape = (glint_shape){.count = GLINT_CELL_NODES,
                           .corners = {0, 2, 6, 8},
                           .longest = (181 * size >> 7) + 1, /* the diagonal */
                           .lobes = lobes,
                           .part = part,
                           .fit = fit_cell,
                           .shift = shift,
                           .x = part->x + x,
                           .y = part->y + y};
}

/* ---- Shapes ---- */

/* Where polynomials of a shape go. */
typedef struct shape_target {
    const glint_shape *shape;
    const glint_terms *terms;
    glint_polynomials *polynomials;
} shape_target;

/* Sets polynomial number i, which begins with so much more. @return 0 where it does not fit */
static int set_through(const shape_target *to, uint32_t i, const int32_t n[], int unit, uint32_t more) {
    glint_quadratic *const q = &to->polynomials->of[i];
    if (!to->shape->fit(to->shape, n, unit, q))
        return 0;
    q->start += more;
    return 1;
}

static int begin_sums(const shape_target *to, glint_node *const nodes[], int has_surface) {
    const glint_terms *terms = to->terms;
    const int unit = terms->sums == 1 ? 16 : 12 + (int)terms->light->sum_bits;
    int32_t n[GLINT_CELL_NODES];
    for (uint32_t c = 0; c < terms->sums; c++) {
        for (uint32_t i = 0; i < to->shape->count; i++)
            n[i] = terms->is_channels ? glint_sum_at(terms, nodes[i]->sum, nodes[i]->shine, (int)c,
                                                     has_surface ? nodes[i]->surface : 0)
                                      : nodes[i]->sum[c];
        const uint32_t more = terms->is_channels ? glint_finish_of(terms, has_surface, (int)c) : 1 << 15;
        if (!set_through(to, c, n, unit, terms->is_channels || terms->sums == 1 ? more : 0))
            return 0;
    }
    return 1;
}

/* The polynomials of a light with terms of its own. */
static int begin_apart(const shape_target *to, glint_node *const nodes[], const glint_apart *apart) {
    uint32_t next = apart->first;
    int32_t n[GLINT_CELL_NODES];
    for (uint32_t kind = 0; kind < GLINT_NUMBERS_DRAWN; kind++) {
        if (!(apart->kinds >> kind & 1))
            continue;
        for (uint32_t i = 0; i < to->shape->count; i++)
            n[i] = nodes[i]->number[apart->light][kind];
        if (!set_through(to, next++, n, 16, glint_half_of(kind)))
            return 0;
    }
    return 1;
}

int glint_shape_begin(const glint_frame *frame, const glint_draw *draw, const glint_shape *shape,
                      glint_node *const nodes[], glint_terms *terms, glint_polynomials *polynomials) {
    const shape_target to = {shape, terms, polynomials};
    glint_region region;
    int32_t n[GLINT_CELL_NODES];
    if (!find_shape_region(frame, draw, shape, nodes, &region))
        return 0;
    if (!(glint_region_sum_lobes(draw->shading, draw->extra != 0, &region) &&
          shape_fits(frame, draw->shading, &region))) {
        glint_region_part_lobes(&region);
        if (!shape_fits(frame, draw->shading, &region))
            return 0;
    }
    region.has_edge |= shape_has_edge(draw->shading, &region, shape, nodes);
    glint_terms_name(frame, draw, &region, 0, terms);
    for (uint32_t i = 0; i < shape->count; i++) {
        glint_node_sum(terms->light, region.held, nodes[i]);
        if (region.summed)
            glint_node_shine(draw->shading, region.summed, nodes[i]);
    }
    if (!begin_sums(&to, nodes, draw->extra != 0))
        return 0;
    for (uint32_t c = 0; c < 3 && terms->has_surface; c++) {
        for (uint32_t i = 0; i < shape->count; i++)
            n[i] = nodes[i]->surface[c];
        if (!set_through(&to, terms->surface + c, n, 16, 0))
            return 0;
    }
    for (uint32_t a = 0; a < terms->apart_count; a++)
        if (!begin_apart(&to, nodes, &terms->apart[a]))
            return 0;
    return 1;
}
