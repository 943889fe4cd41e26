/* SPDX-License-Identifier: MIT */
/* Sort: how large a region is, how near lights are to it, and what becomes of each. */
#include "../pixel/format.h"
#include "angles.h"
#include "nearness.h"

/* What a node's cosine differs by at least from what tells clear from not, Q12: lights with a position, and cones. */
#define CLEAR_OF_EDGE 16
#define INSIDE_CONE 64

/* The widest region that is told from wider ones, over its depth, Q12; and the nearest light, over its distance. */
#define WIDEST_REACH (4 << 12)
#define NEAREST_LIGHT (2 << 12)

/* sqrt(square), Q24 to Q12. */
uint32_t glint_root_above(uint32_t square) {
    if (!square)
        return 0;
    const unsigned up = glint_leading_zeros(square) & ~1u; /* to 2^30 .. 2^32 */
    const uint32_t root = (uint32_t)glint_inverse_root(square << up >> 1) * 46341 >> 16;
    return ((square << up >> 16) * root >> 14 >> up / 2) + 1;
}

void glint_region_measure(uint32_t pixel, uint32_t longest, const glint_w_range *w, glint_region *region) {
    const uint32_t across =
        (uint32_t)glint_least((int32_t)(glint_product_unsigned(longest, pixel) >> 18), WIDEST_REACH);
    const uint32_t slant = w->least > w->change >> 2 ? (w->change << 12) / w->least : 1 << 14;
    region->slant = slant * 474 >> 8;
    region->reach = (uint32_t)glint_least((int32_t)glint_hypotenuse(across, slant), WIDEST_REACH);
}

/* May a cone so near end between nodes that are outside of it by so much? A cosine's chord, from arcs. */
static inline int is_wide(uint32_t near, uint32_t clearly) {
    return glint_times(near, near) > 8 * clearly;
}

uint32_t glint_region_place(uint32_t all, uint32_t lights, glint_region *region) {
    uint32_t away = 0;
    for (uint32_t l = 0; all >> l; l++) {
        region->near_of[l] = 0;
        if (!(lights >> l & 1))
            continue;
        const uint32_t closeness = glint_closeness_of(region->nearness[l]), outside = region->outside >> l,
                       near = region->reach < WIDEST_REACH && closeness <= UINT16_MAX
                                  ? (uint32_t)glint_least((int32_t)(region->reach * closeness >> 8), NEAREST_LIGHT)
                                  : NEAREST_LIGHT;
        region->near_of[l] = (uint16_t)near;
        away |= (uint32_t)((outside & 1 && !is_wide(near, INSIDE_CONE)) ||
                           (outside >> 8 & 1 && !is_wide(near, 8 * INSIDE_CONE)))
                << l;
    }
    return away;
}

/* H turns by that over |L + V|. */
static inline uint32_t turn_of_axis(const glint_frame *frame, const glint_region *region, uint32_t l) {
    const uint32_t turn = glint_turn_of_rays(frame, region, l), half = (region->nearness[l] & 0x7fu) << 8 | 1;
    if (!turn)
        return 0;
    const unsigned up = (glint_leading_zeros(half) - 1) & ~1u; /* to 2^29 .. 2^31 */
    const uint32_t inverse = (uint32_t)glint_inverse_root(half << up);
    const uint32_t axis = (turn * (inverse + (inverse >> 12) + 1) >> (23 - up / 2)) + 1;
    return axis < UINT16_MAX ? axis : UINT16_MAX;
}

/* Sets by how much of its place and its axis a region turns at most, of lights that show and have a place. */
static void set_most(const glint_frame *frame, uint32_t placed, uint32_t lobes, glint_region *region) {
    region->near = region->axis = 0;
    for (uint32_t l = 0; placed >> l; l++)
        if (placed >> l & 1 && region->near_of[l] > region->near)
            region->near = region->near_of[l];
    for (uint32_t l = 0; lobes >> l; l++) {
        if (!(lobes >> l & 1))
            continue;
        region->axis_of[l] = (uint16_t)turn_of_axis(frame, region, l);
        region->axis = region->axis_of[l] > region->axis ? region->axis_of[l] : region->axis;
    }
}

/*
 * Is a light on one side of all of a region, as at its nodes? N, linear between nodes, times the way to the light,
 * which is linear too, is a quadratic, whose second derivative is twice what both change by. It lies within a third of
 * that product of what is linear between nodes; half of it is for lengths, which change as well.
 */
static inline int is_clear(const glint_region *region, uint32_t l) {
    const uint32_t apart = glint_times(region->near_of[l], region->turn) / 2 + CLEAR_OF_EDGE;
    const int32_t least = (int32_t)(apart * region->strength[l] >> 12) + 1;
    return region->side_least[l] > least || region->side_most[l] < -least;
}

uint32_t glint_region_sort(const glint_frame *frame, const glint_shading *shading, glint_region *region) {
    const uint32_t ungated = shading->material->flags & GLINT_MATERIAL_UNGATED;
    const uint32_t placed = shading->lights & shading->terms->placed;
    const uint32_t away = glint_region_place(shading->lights, placed & ~region->left, region) | region->left,
                   dark = region->dark | away, lights = shading->lights & ~away, near = placed & ~away;
    region->turn = (uint32_t)glint_least((int32_t)region->turn, 1 << 13);
    region->held = region->lit;
    region->sides = lights & ~region->lit & ~dark;
    for (uint32_t l = 0; near >> l; l++)
        if (near >> l & 1 && !is_clear(region, l)) { /* at nodes, it may be, not between them */
            region->sides |= 1u << l;
            region->held &= ~(1u << l);
        }
    const uint32_t lobes = shading->terms->lobes & ~away & (ungated ? ~0u : region->held | region->sides),
                   shown = region->held | region->sides | lobes, cones = shading->terms->cones & shown;
    for (uint32_t l = 0; cones >> l; l++)
        if (cones >> l & 1 && is_wide(region->near_of[l], INSIDE_CONE)) {
            region->sides |= 1u << l;
            region->held &= ~(1u << l);
        }
    region->cones = cones & ~region->held;
    set_most(frame, shown & placed, lobes, region);
    return lobes;
}

/* ---- What they mean ---- */

void glint_terms_name(const glint_frame *frame, const glint_draw *draw, const glint_region *region, int over_length,
                      glint_terms *terms) {
    const glint_shading *shading = draw->shading;
    const int has_surface = draw->extra != 0, has_apart = (region->sides | region->lobes) != 0;
    terms->has_shine = region->summed != 0;
    terms->light = shading->terms;
    terms->power = &shading->power;
    terms->has_surface = (uint8_t)(has_surface && !region->folds);
    terms->takes_largest = (shading->material->flags & GLINT_MATERIAL_MAX) != 0;
    terms->is_ungated = (shading->material->flags & GLINT_MATERIAL_UNGATED) != 0;
    terms->is_over_length = (uint8_t)over_length;
    terms->is_curved = 1;
    terms->shown = (uint8_t)(region->held | region->sides | region->lobes | region->summed);
    terms->margin = region->has_edge ? region->margin : 0;
    const int is_plain = !has_apart && !terms->has_surface && !over_length;
    const int is_coloured = shading->terms->channels > 1 && !terms->takes_largest;
    terms->is_channels = (uint8_t)(region->folds || region->summed || (is_plain && is_coloured));
    terms->sums = (uint8_t)(terms->is_channels ? 3 : shading->terms->channels);
    terms->is_fused = (uint8_t)(is_plain && (terms->sums == 1 || !terms->takes_largest) &&
                                frame->config.format->draw_channels && !frame->config.gamma);
    terms->square = terms->sums;
    terms->surface = (uint8_t)(terms->square + (over_length != 0));
    terms->apart_count = 0;
    uint32_t next = terms->surface + 3u * terms->has_surface;
    for (uint32_t l = 0, apart = region->sides | region->lobes; apart >> l; l++) {
        if (!(apart >> l & 1))
            continue;
        glint_apart *to = &terms->apart[terms->apart_count++];
        const uint32_t side = region->sides >> l & 1, cone = region->cones >> l & 1, lobe = region->lobes >> l & 1,
                       strength = lobe & shading->terms->placed >> l, narrow = lobe && !shading->terms->lobe_is_wide;
        to->light = (uint8_t)l;
        to->first = (uint8_t)next;
        to->kinds = (uint8_t)(side << GLINT_SIDE | cone << GLINT_CONE | strength << GLINT_STRENGTH |
                              lobe << GLINT_LOBE_X | narrow << GLINT_LOBE_Y);
        next += side + cone + strength + lobe + narrow;
    }
    terms->end = (uint8_t)next;
}
