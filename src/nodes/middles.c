/* SPDX-License-Identifier: MIT */
/* Middles: nodes between a triangle's corners, lit like these, or found from them. */
#include "corners.h"

#include "../math/division.h"

/* Sums a node's highlights. */
static void shine_node(const glint_shading *shading, glint_candidate *t, int i, glint_node *node) {
    glint_node_shine(shading, t->region.summed, node);
    for (int c = 0; c < 3; c++)
        t->shine[i][c] = node->shine[c];
}

/* Sums its lights, and these. */
static void sum_node(const glint_shading *shading, glint_candidate *t, int i, glint_node *node) {
    glint_node_sum(shading->terms, t->region.held, node);
    for (uint32_t c = 0; c < shading->terms->channels; c++)
        t->sum[i][c] = node->sum[c];
    if (t->region.summed)
        shine_node(shading, t, i, node);
}

/* A node's numbers of some lights, as a corner keeps them. */
static void take_kept(const glint_light_terms *light, const int16_t *kept, uint32_t lights, glint_node *node) {
    for (uint32_t l = 0; lights >> l; l++) {
        if (!(lights >> l & 1))
            continue;
        node->number[l][GLINT_STRENGTH] = 1 << 14; /* where none is kept */
        for (uint32_t kind = 0; kind < GLINT_NUMBERS_DRAWN; kind++)
            if (light->at[l][kind])
                node->number[l][kind] = kept[light->at[l][kind]];
    }
}

/* Sets the corners' sums of the lights that all of them face: what they keep, without the others that they face. */
void glint_sum_corners(const glint_shading *shading, glint_candidate *t) {
    const glint_light_terms *light = shading->terms;
    const uint32_t summed = t->region.summed;
    glint_node node;
    for (int i = 0; i < 3; i++) {
        const int16_t *const kept = t->kept[i], *const rest = kept + light->channels;
        const uint32_t others = (uint32_t)rest[GLINT_KEPT_FACING] & 0xff & ~t->region.held;
        for (uint32_t c = 0; c < light->channels; c++)
            t->sum[i][c] = kept[c];
        for (int c = 0; c < 3 && summed; c++)
            t->shine[i][c] = rest[GLINT_KEPT_SHINE + c];
        if (!others)
            continue;
        take_kept(light, kept, others, &node);
        glint_node_sum(light, others, &node);
        for (uint32_t c = 0; c < light->channels; c++)
            t->sum[i][c] -= node.sum[c];
        if (!summed)
            continue;
        take_kept(light, kept, summed, &node);
        shine_node(shading, t, i, &node);
    }
}

/*
 * Under lights without a position, numbers between corners are those of the corners over |M|, M the normal over w. With
 * r = wa wb |Na - Nb|^2 / (wa + wb)^2, |M| = (wa + wb) sqrt(1 - r) / 2; the root's inverse by its series. Of what 4
 * times a number there differs by from twice both ends', the share of each end, Q15.
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
        t->share[e][0] = (int32_t)(of_a * longer >> 13) - (1 << 16);
        t->share[e][1] = (int32_t)(of_b * longer >> 13) - (1 << 16);
    }
}

/* A number at its middle. */
static inline int32_t mix_ends(const glint_candidate *t, int e, int32_t a, int32_t b) {
    return glint_shift_right(2 * (a + b) + glint_mix_bulge(t, e, a, b) + 2, 2);
}

/* Sums of middles that are found from the corners. */
static void mix_sums(const glint_shading *shading, glint_candidate *t) {
    for (int e = 0; e < 3; e++)
        for (uint32_t c = 0; c < shading->terms->channels; c++)
            t->sum[3 + e][c] = mix_ends(t, e, t->sum[glint_ends[e][0]][c], t->sum[glint_ends[e][1]][c]);
}

/* Deviations there of highlights that are summed. */
static void mix_lobes(const glint_light_terms *light, glint_candidate *t, int e, glint_node *node) {
    const uint32_t summed = t->region.summed;
    for (uint32_t l = 0; summed >> l; l++)
        for (uint32_t kind = GLINT_LOBE_X; kind <= GLINT_LOBE_Y && summed >> l & 1; kind++) {
            const uint8_t at = light->at[l][kind];
            node->number[l][GLINT_STRENGTH] = 1 << 14;
            node->number[l][kind] =
                (int16_t)mix_ends(t, e, t->kept[glint_ends[e][0]][at], t->kept[glint_ends[e][1]][at]);
        }
}

/* The middle of edge e, as a fragment. */
static void gather_middle(const glint_frame *frame, const glint_triangle *triangle, const glint_candidate *t, int e,
                          glint_fragments *to) {
    const glint_vertex *const a = triangle->corners[glint_ends[e][0]], *const b = triangle->corners[glint_ends[e][1]];
    const uint32_t i = to->count++;
    glint_find_ray(frame, a->x + b->x, a->y + b->y, to->ray[i]);
    to->inverse_w[i] = (a->inverse_w >> 1) + (b->inverse_w >> 1);
    if (t->is_mixed && !t->is_straight) {
        for (int c = 0; c < 3; c++)
            to->normal[i][c] = (int16_t)mix_ends(t, e, a->attribute[c], b->attribute[c]);
        return;
    }
    const unsigned zeros = glint_leading_zeros((uint32_t)a->inverse_w | (uint32_t)b->inverse_w);
    const int32_t wa = (int32_t)((uint32_t)a->inverse_w << zeros >> 17),
                  wb = (int32_t)((uint32_t)b->inverse_w << zeros >> 17);
    glint_unit_each(a->attribute[0] * wa + b->attribute[0] * wb, a->attribute[1] * wa + b->attribute[1] * wb,
                    a->attribute[2] * wa + b->attribute[2] * wb, to->normal[i]);
}

/* Lights the nodes between corners. @return 0 where polynomials through them do not fit */
static int light_middles(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                         glint_candidate *t) {
    const glint_region *region = &t->region;
    const uint32_t lobes = region->lobes | region->summed;
    glint_node *const to[3] = {&t->middle[0], &t->middle[1], &t->middle[2]};
    glint_fragments at;
    uint32_t unfit = 0;
    at.count = 0;
    for (int e = 0; e < 3; e++)
        gather_middle(frame, triangle, t, e, &at);
    glint_nodes_light(frame, draw->shading, &at, t->is_mixed ? lobes : region->held | region->sides | lobes, lobes, 0,
                      to);
    for (int e = 0; e < 3; e++)
        unfit |= (to[e]->unfit & lobes) | (to[e]->far & region->lobes) | (to[e]->steep & region->cones);
    return !unfit;
}

/* Finds what polynomials take of the nodes between corners. @return 0 where these do not fit */
int glint_find_middles(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                       glint_candidate *t) {
    const glint_region *region = &t->region;
    if (t->is_mixed && !t->is_straight)
        find_shares(triangle, t);
    if (!t->is_between && !light_middles(frame, draw, triangle, t))
        return 0;
    if (t->is_mixed && !region->summed && !region->folds) /* sums are polynomials of the corners' */
        return 1;
    if (t->is_mixed)
        mix_sums(draw->shading, t);
    for (int e = 0; e < 3; e++) {
        glint_node *const node = &t->middle[e];
        if (t->is_between)
            mix_lobes(draw->shading->terms, t, e, node);
        if (!t->is_mixed)
            sum_node(draw->shading, t, 3 + e, node);
        else if (region->summed)
            shine_node(draw->shading, t, 3 + e, node);
    }
    return 1;
}
