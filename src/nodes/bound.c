/* SPDX-License-Identifier: MIT */
/* Bound: how far polynomials through the nodes of a region may be from its light. */
#include "../light/model.h"
#include "angles.h"

/* A region wider than three quarters of a light's distance has no polynomial, Q12. */
#define TOO_NEAR (3 << 10)

/* Of what 1/w changes by, times 1.85: beyond, nothing fits. Q12 */
#define STEEPEST (1 << 12)

/* A cone's ramp is to be no longer over a region, Q12. */
#define LONGEST_RAMP (4 << 12)

/* 0.0275 of a cube times levels, Q4: Q8. */
static inline uint32_t of_levels(uint32_t of_cube, uint32_t levels) {
    return (of_cube * 1802 >> 14) * levels >> 10; /* 0.0275 is 1802 2^-16 */
}

/* a b / 2^n, below 2^32: of bright lights a b is not. */
static inline uint32_t scaled(uint32_t a, uint32_t b, unsigned n) {
    return (uint32_t)(glint_product_unsigned(a, b) >> n);
}

/*
 * In the middle of a triangle whose edges all turn by a planes fall short by a^2 / 6, and err by a b / 3; chords
 * between unit vectors made longer by half of what they fall short by do so by half of that. Levels Q4 to Q8.
 */
static uint32_t plane_sum_error(uint32_t levels, uint32_t turn, uint32_t place, uint32_t b) {
    const uint32_t a = turn + place;
    return scaled((2 * glint_times(a, a) - glint_times(turn, turn) + 4 * glint_times(a, b)) * 342 >> 8, levels, 12);
}

/* x, Q16, times a highlight's slope: Q12, at most 2^16. */
static uint32_t with_slope(uint32_t slope, uint32_t x) {
    const uint32_t product = (x < 1 << 18 ? x : 1 << 18) * (slope >> 2) >> 10;
    return x > 1 << 18 || product > 1 << 16 ? 1 << 16 : product;
}

/* A highlight's: |e| falls short as N does, and H turns. */
static uint32_t plane_lobe_error(uint32_t slope, uint32_t levels, uint32_t turn, uint32_t axis, uint32_t b) {
    const uint32_t of_axis =
        2 * glint_times(axis, axis) + 4 * glint_times(turn, axis) + 4 * glint_times(turn + axis, b);
    return ((with_slope(slope, of_axis << 4) + glint_times(turn, turn)) * 683 >> 13) * (levels >> 4) >> 8;
}

/*
 * A deviation at the middle of an edge is found from its ends: what both N and H make of it falls with it. The ends
 * weigh as their 1/w do, which are apart by b / 1.85 of one of them, where H is between them by its place.
 */
static uint32_t between_error(const glint_light_terms *light, uint32_t slope, uint32_t levels, uint32_t turn,
                              uint32_t axis, uint32_t b) {
    const uint32_t widest = light->lobe_is_wide ? 1 << 12 : (uint32_t)light->lobe_cut >> light->lobe_shift >> 2;
    const uint32_t of_axis = 2 * glint_times(axis, axis) + 4 * glint_times(glint_times(turn, axis), widest) +
                             4 * glint_times(axis, b * 277 >> 9);
    return scaled(with_slope(slope, of_axis << 4), levels >> 4, 12);
}

/*
 * A highlight's by 0.041 of what its deviation has of third order and 2^-14, which rounding takes of N and its axis,
 * with its slope, and as a sum for its strength.
 */
static uint32_t lobe_error(uint32_t slope, uint32_t levels, uint32_t third, uint32_t f, uint32_t b, int is_wide) {
    const uint32_t rounding = is_wide ? 6 : 4; /* 2^-14, Q16, and for a slope of two thirds */
    return scaled(with_slope(slope, ((third >> 4) * 2687 >> 12) + rounding), levels >> 4, 8) +
           of_levels(glint_cube(f, b), levels >> 4);
}

/*
 * What 1 / |M| of a table over |M|^2, in steps of 2^-10, leaves of all that is over length `times` over: 2^-12 / |M|^2
 * each. |M|^2 is 1 at the corner with the largest 1/w, and falls to cos^2 of half the normals' turn between corners.
 */
static uint32_t length_error(const glint_region *region, uint32_t levels, uint32_t times) {
    const uint32_t slower = (1 << 12) + (region->slant * 277 >> 9), square = glint_times(slower, slower),
                   turn = glint_times(region->turn, region->turn);
    return scaled(square + glint_times(square, turn) / 3, levels * times, 24);
}

/* What narrow highlights lose over length is not counted up to a tenth of a level, Q8. */
#define A_TENTH 26

/*
 * What a highlight loses over length: a wide one by the table, a narrow one by its numbers. These are times |M| there,
 * or |M|^2 under Phong's model, and so rounded at nodes and cut off at pixels: 2^-14 of them is 2^-14 over |M|, or
 * |M|^2, of a deviation. A wide one's slope is given as two thirds; it counts as 4/3, for what a table is off by is
 * reached somewhere in any region, what polynomials are by hardly.
 */
static uint32_t lobe_length_error(const glint_region *region, uint32_t levels, uint32_t times, int is_wide) {
    const uint32_t slope = is_wide ? 2 * region->slope : region->slope >> 2,
                   error = length_error(region, scaled(levels, slope, 8), times);
    return is_wide || error > A_TENTH ? error : 0;
}

/* The cone's edge may cross a region: by how much its ramp changes from node to node, Q12. */
static uint32_t ramp_of(const glint_prepared_light *source, uint32_t near) {
    const uint64_t range = (uint64_t)near * (uint32_t)source->spot.slope >> source->spot.shift;
    return range > 1 << 20 ? 1 << 20 : (uint32_t)range;
}

/* What is left of a light's levels at its strength at nodes: all where no light is near. */
static GLINT_NOINLINE uint32_t levels_at_strength(uint32_t levels, const glint_region *region, uint32_t l) {
    return !region->near ? levels : scaled(levels, region->strength[l], 14) + 16;
}

/*
 * What a light turns by as a place in space does: its direction by what the region is long over its distance, and
 * beside it its strength, which falls the faster the less of it is left: 1 + 0.4 t + 0.35 t^2 times that, t being what
 * is lost. Of random triangles and lights no polynomial is off by more than the laws make of it (suite nodes).
 */
static uint32_t place_of_light(const glint_region *region, uint32_t l) {
    const uint32_t lost = (1u << 14) - region->strength[l];          /* Q14 */
    const uint32_t more = lost * (1638 + (lost * 1434 >> 14)) >> 14; /* Q12 */
    return region->near_of[l] * ((1u << 12) + more) >> 12;
}

/* Sets it for lights that show, if one of them is near. @return the most of it */
static uint32_t find_places(glint_region *region) {
    const uint32_t shown = region->held | region->sides | region->lobes;
    uint32_t most = 0;
    for (uint32_t l = 0; region->near && shown >> l; l++) {
        const uint32_t place = shown >> l & 1 && region->near_of[l] ? place_of_light(region, l) : 0;
        region->place_of[l] = (uint16_t)place;
        most = place > most ? place : most;
    }
    return most;
}

/* What has been set. */
static inline uint32_t known_place(const glint_region *region, uint32_t l) {
    return region->near ? region->place_of[l] : 0;
}

int glint_region_fits(const glint_shading *shading, int has_surface, glint_region *region) {
    const glint_light_terms *light = shading->terms;
    region->folds = 0;
    region->summed = 0;
    if (region->near > TOO_NEAR || region->slant > STEEPEST)
        return 0;
    if (region->lobes & region->unfit)
        return 0;
    if (region->cones & region->steep)
        return 0;
    const uint32_t place = find_places(region), turn = region->turn + place + region->colour;
    if (!region->lobes)
        region->axis = 0;
    if (glint_lobe_turn(shading, region) + region->axis > GLINT_WIDEST || turn > GLINT_WIDEST)
        return 0;
    region->folds = has_surface && !region->sides && !(shading->material->flags & GLINT_MATERIAL_MAX) &&
                    of_levels(glint_cube(turn, region->slant), region->levels) <= light->limit;
    region->place = place + (region->folds ? region->colour : 0);
    region->of_colour =
        glint_times(region->colour, region->slant) * ((light->ambient_levels >> 4) + region->levels) >> 8;
    return 1;
}

/*
 * What highlights in sums turn by. With a turn t of N from H, cos^p t changes as exp(-p t^2 / 2) does: its derivatives
 * are at most p and 1.38 p^(3/2), where those of a cosine, which the law is for, are 1. They are so for p = 3 and more.
 */
static uint32_t turn_of_shine(const glint_shading *shading, const glint_region *region, uint32_t l) {
    const uint32_t turn = glint_lobe_turn(shading, region) + region->axis_of[l];
    return (turn * shading->terms->spread >> 4) + known_place(region, l);
}

int glint_region_sum_lobes(const glint_shading *shading, int has_surface, glint_region *region) {
    const glint_light_terms *light = shading->terms;
    const uint32_t summed = has_surface && !region->folds ? 0 : region->lobes & region->held;
    if (!summed || !light->spread)
        return 0;
    region->shine = 0;
    for (uint32_t l = 0; summed >> l; l++) {
        const uint32_t turn = summed >> l & 1 ? turn_of_shine(shading, region, l) : 0;
        if (turn > GLINT_WIDEST)
            return 0;
        if (turn)
            region->shine += of_levels(glint_cube(turn, region->slant),
                                       levels_at_strength(light->specular_levels[l], region, l) >> 4);
    }
    if (region->shine > light->most)
        return 0;
    region->summed = summed;
    region->lobes &= ~summed;
    return 1;
}

/* Of highlights with terms of their own: is one cut off? */
static inline int is_cut_off(const glint_region *region) {
    return (region->lobes & region->far) != 0;
}

/* By how much its place turns a light in sums, at most as the nearest one's. */
static uint32_t turn_of_place(const glint_region *region, uint32_t l) {
    const uint32_t place = known_place(region, l) + (region->folds ? region->colour : 0);
    return place < region->place ? place : region->place;
}

/* How far sums may be off, by quadratics, or by planes whose chords are made longer for one of both turns of normals:
 * all light turns no more than that of the nearest light, or each as it does. */
static GLINT_NOINLINE uint32_t sum_error(const glint_light_terms *light, const glint_region *region, uint32_t longer,
                                         uint32_t turn, int is_plane) {
    const uint32_t b = region->slant, all = turn + region->place, shown = region->held | region->sides;
    const uint32_t whole =
        is_plane ? plane_sum_error(region->levels, longer, all, b) : of_levels(glint_cube(all, b), region->levels);
    uint32_t each = 0;
    if (!shown || !region->near || !(shown & (shown - 1)))
        return whole;
    for (uint32_t l = 0; shown >> l && each < whole; l++) {
        if (!(shown >> l & 1))
            continue;
        const uint32_t here = turn + turn_of_place(region, l),
                       levels = levels_at_strength(light->diffuse_levels[l], region, l) >> 4;
        each += is_plane ? plane_sum_error(levels, longer, here, b) : of_levels(glint_cube(here, b), levels);
    }
    return each < whole ? each : whole;
}

uint32_t glint_plane_error(const glint_shading *shading, int has_surface, const glint_region *region) {
    const glint_light_terms *light = shading->terms;
    const uint32_t longer = region->folds || region->summed ? 0 : region->turn;
    if (region->cones || (has_surface && !region->folds) || (region->lobes && light->lobe_is_wide) ||
        is_cut_off(region))
        return UINT32_MAX;
    uint32_t error = sum_error(light, region, longer, longer ? 0 : region->turn, 1) + (region->of_colour >> 2);
    for (uint32_t l = 0, lobes = region->lobes | region->summed; lobes >> l; l++) {
        const uint32_t levels = levels_at_strength(light->specular_levels[l], region, l);
        if (region->summed >> l & 1)
            error += plane_sum_error(levels >> 4, 0, turn_of_shine(shading, region, l), region->slant);
        if (region->lobes >> l & 1)
            error += plane_lobe_error(region->slope, levels, glint_lobe_turn(shading, region), region->axis_of[l],
                                      region->slant);
    }
    return error;
}

/* Light whose direction turns by p is linear in N, which turns by t: over length that leaves t p^2, of 0.0281. */
static uint32_t turned_by(const glint_region *region, uint32_t place, uint32_t slant) {
    const uint32_t third = glint_times(glint_times(region->turn + slant, place), place + slant);
    return third + (third >> 5);
}

/* How far sums over length may be off: all light turns no more than that of the nearest light, or each as it does. */
static uint32_t sum_error_over_length(const glint_light_terms *light, const glint_region *region) {
    const uint32_t b = region->slant, shown = region->held | region->sides;
    const uint32_t whole =
        of_levels(glint_cube(region->place, b) + turned_by(region, region->place, b), region->levels);
    uint32_t each = 0;
    if (!shown || !region->near || !(shown & (shown - 1)))
        return whole;
    for (uint32_t l = 0; shown >> l && each < whole; l++) {
        if (!(shown >> l & 1))
            continue;
        const uint32_t place = turn_of_place(region, l);
        each += of_levels(glint_cube(place, b) + turned_by(region, place, b),
                          levels_at_strength(light->diffuse_levels[l], region, l) >> 4);
    }
    return each < whole ? each : whole;
}

/* More than polynomials may be off by, of each light, with room for what is added. */
#define TOO_MUCH (1u << 27)

/* What light in sums is off by, unless that is too much on its own; */
static inline uint32_t of_sums(const glint_light_terms *light, uint32_t error) {
    return error > light->most_of_sums ? TOO_MUCH : error;
}

/* and what a highlight is. */
static inline uint32_t of_one(const glint_light_terms *light, uint32_t error) {
    return error > light->most_of_one ? TOO_MUCH : error;
}

/* What highlights with terms of their own may be off by. */
static uint32_t gloss_error(const glint_frame *frame, const glint_shading *shading, const glint_region *region) {
    const glint_light_terms *light = shading->terms;
    const uint32_t turn = glint_lobe_turn(shading, region);
    uint32_t error = 0;
    for (uint32_t l = 0; region->lobes >> l; l++) {
        if (!(region->lobes >> l & 1))
            continue;
        const uint32_t levels = levels_at_strength(light->specular_levels[l], region, l),
                       third = glint_lobe_third(turn, region->axis_of[l], glint_turn_of_rays(frame, region, l),
                                                region->slant);
        error += of_one(
            light, lobe_error(region->slope, levels, third, region->near_of[l], region->slant, light->lobe_is_wide));
    }
    return error;
}

/* And over length. */
static uint32_t gloss_error_over_length(const glint_frame *frame, const glint_shading *shading,
                                        const glint_region *region) {
    const glint_light_terms *light = shading->terms;
    const uint32_t slant = region->slant, turn = glint_lobe_turn(shading, region), slope = region->slope;
    const int is_mirrored = shading->material->model->lobe == GLINT_LOBE_MIRROR;
    uint32_t error = 0;
    for (uint32_t l = 0; region->lobes >> l; l++) {
        if (!(region->lobes >> l & 1))
            continue;
        const uint32_t levels = levels_at_strength(light->specular_levels[l], region, l);
        const uint32_t third = glint_lobe_third_over_length(turn, region->axis_of[l],
                                                            glint_turn_of_rays(frame, region, l), slant, is_mirrored),
                       of_length = lobe_length_error(region, levels, 1 + (uint32_t)is_mirrored, light->lobe_is_wide);
        error +=
            of_one(light, lobe_error(slope, levels, third, region->near_of[l], slant, light->lobe_is_wide) + of_length);
    }
    return error;
}

uint32_t glint_error_between(const glint_shading *shading, const glint_region *region) {
    const glint_light_terms *light = shading->terms;
    const uint32_t turn = glint_lobe_turn(shading, region), lobes = region->lobes | region->summed;
    uint32_t error = 0;
    for (uint32_t l = 0; lobes >> l; l++)
        if (lobes >> l & 1)
            error += of_one(light, between_error(light, region->slope,
                                                 levels_at_strength(light->specular_levels[l], region, l), turn,
                                                 region->axis_of[l], region->slant));
    return error;
}

/* What cones may be off by. @return 0 where one is too steep */
static int find_cone_error(const glint_frame *frame, const glint_light_terms *light, glint_region *region) {
    region->cone_error = 0;
    for (uint32_t l = 0; region->cones >> l; l++) {
        const uint32_t near = region->near_of[l], place = near + region->slant;
        if (!(region->cones >> l & 1))
            continue;
        const uint32_t ramp = ramp_of(&frame->view->lights[l], near);
        if (ramp > LONGEST_RAMP)
            return 0;
        region->cone_error += 3 *
                              of_levels(glint_times(glint_times(ramp, place), place),
                                        levels_at_strength(light->diffuse_levels[l], region, l) >> 4) /
                              2; /* the step's slope */
    }
    return 1;
}

/* By how much N.L times strength, Q14, is off: of lights whose highlights end at 0, where normals turn by so much. */
static int32_t find_margin(const glint_region *region, uint32_t turn) {
    uint32_t most = 0;
    for (uint32_t l = 0, ends = region->sides & region->lobes; ends >> l; l++) {
        const uint32_t error =
            ends >> l & 1 ? glint_cube(turn + turn_of_place(region, l), region->slant) * 1802 >> 14 : 0;
        most = (uint32_t)glint_most((int32_t)(error * region->strength[l] >> 14), (int32_t)most);
    }
    return 8 + (int32_t)most;
}

/* What a surface's colours make of them. */
static inline uint32_t colour_error(const glint_region *region) {
    return scaled(region->of_colour, region->slant, 12 + 5);
}

int glint_region_bound(const glint_frame *frame, const glint_shading *shading, glint_region *region) {
    const glint_light_terms *light = shading->terms;
    if (is_cut_off(region) || !find_cone_error(frame, light, region))
        return 0;
    region->error = of_sums(light, sum_error(light, region, 0, region->turn, 0)) + colour_error(region) +
                    gloss_error(frame, shading, region) + region->cone_error + (region->summed ? region->shine : 0);
    region->margin = find_margin(region, region->turn);
    return 1;
}

uint32_t glint_error_over_length(const glint_frame *frame, const glint_shading *shading, glint_region *region) {
    const glint_light_terms *light = shading->terms;
    if (region->summed) /* over length none are */
        return UINT32_MAX;
    region->margin = find_margin(region, 0);
    const uint32_t error = of_sums(light, sum_error_over_length(light, region)) + colour_error(region) +
                           gloss_error_over_length(frame, shading, region) + region->cone_error;
    if (!region->folds)
        return error;
    /* colours times |M| are of a degree more, and ambient light with them */
    return error + of_levels(glint_cube(region->turn + region->place, region->slant),
                             region->levels + (light->ambient_levels >> 4));
}
