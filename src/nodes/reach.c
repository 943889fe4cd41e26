/* SPDX-License-Identifier: MIT */
/* Reach: where on a region highlights show, and how steep they are there. */
#include "../light/model.h"
#include "angles.h"

/*
 * A deviation is linear in N, and N over |M| where it is interpolated: with H fixed it lies no nearer to 0 than chords
 * between corners do. H turns by g while N turns by t: that adds g^2 / 6 + g t / 3, as planes are off by. R is a
 * quadratic form of N, which adds t^2 / 12, t being R's turn. And unit vectors are rounded.
 */
int32_t glint_lobe_bulge(const glint_shading *shading, const glint_region *region, uint32_t light) {
    const uint32_t turn = (uint32_t)glint_least((int32_t)glint_lobe_turn(shading, region), GLINT_WIDEST),
                   axis = (uint32_t)glint_least(region->axis_of[light], GLINT_WIDEST);
    const uint32_t mirrored = shading->material->model->lobe == GLINT_LOBE_MIRROR ? glint_times(turn, turn) / 2 : 0;
    return (int32_t)((glint_times(axis, axis + 2 * turn) + mirrored) * 171 / 256 + 3) << shading->terms->lobe_shift;
}

glint_lobe_bounds glint_find_lobe_bounds(const glint_shading *shading, int32_t bulge) {
    const glint_light_terms *light = shading->terms;
    return (glint_lobe_bounds){light->lobe_is_wide,
                               bulge,
                               light->lobe_cut + bulge,
                               light->lobe_diagonal + bulge + (bulge >> 1),
                               shading->shininess ? -bulge : INT32_MIN,
                               light->lobe_has_strip ? 2 * GLINT_HORIZON + bulge : INT32_MIN};
}

/* The nearest to 0 that a range of numbers comes. */
static inline int32_t nearest_of(const glint_interval *range) {
    return glint_most(range->least, -range->most);
}

/*
 * The slope of (1 - r^2)^(p/2) is p r (1 - r^2)^(p/2 - 1), which falls from r = 1/sqrt(p) on. A sixteenth more is for
 * the table. @param r Q14, beyond that
 */
static uint32_t slope_from(const glint_shading *shading, int32_t r) {
    const uint32_t steepest = shading->terms->slope, u = (uint32_t)(r * r) << 2, rest = (1u << 15) - (u >> 15);
    const uint32_t power = glint_power_at(&shading->power, u) * (uint32_t)r / rest; /* Q14 */
    const uint64_t slope = glint_product_unsigned(power + (power >> 4) + 1, (uint32_t)shading->shininess) >> 22;
    return slope < steepest ? (uint32_t)slope : steepest;
}

/* Of a highlight that shows no nearer to 0 than this at nodes, and what deviations and polynomials are off by. */
static uint32_t find_lobe_slope(const glint_shading *shading, const glint_region *region, uint32_t axis,
                                int32_t nearest) {
    const glint_light_terms *light = shading->terms;
    if (light->lobe_is_wide || nearest <= light->crest)
        return light->slope;
    const uint32_t off = glint_cube(glint_lobe_turn(shading, region) + axis, region->slant) * 2687 >> 12; /* Q14 */
    const int32_t r = glint_shift_right(nearest, light->lobe_shift) - glint_least((int32_t)off, 1 << 14);
    return r <= glint_shift_right(light->crest, light->lobe_shift) ? light->slope
                                                                   : slope_from(shading, glint_least(r, (1 << 14) - 1));
}

void glint_region_add_lobe(const glint_shading *shading, const glint_lobe_bounds *bounds, uint32_t light,
                           const glint_lobe_range *at, glint_region *region) {
    const int32_t straight = glint_most(nearest_of(&at->x), nearest_of(&at->y)),
                  diagonal = glint_most(nearest_of(&at->rising), nearest_of(&at->falling));
    const int is_unfit = region->unfit >> light & 1,
              is_outside = bounds->is_wide ? at->x.most < bounds->below
                                           : straight >= bounds->straight || diagonal >= bounds->diagonal;
    if (is_outside && !is_unfit)
        return;
    region->lobes |= 1u << light;
    if (is_unfit)
        return;
    region->has_edge |= bounds->is_wide && at->x.least < bounds->edge;
    const int32_t nearest = glint_most(straight, glint_shift_right(diagonal * 23170, 15)) - bounds->bulge;
    const uint32_t slope = find_lobe_slope(shading, region, region->axis_of[light], nearest);
    region->slope = slope > region->slope ? slope : region->slope;
}
