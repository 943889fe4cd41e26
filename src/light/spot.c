/* SPDX-License-Identifier: MIT */
/* Spots: point lights whose light is limited to a cone, with a smooth step from its inner to its outer angle. */
#include "lamps.h"
#include "point.h"

/* Returns the cosine of an angle in degrees, times GLINT_UNIT^2, rounded to nearest. */
static int32_t cosine_of(glint_q16 degrees) {
    int64_t cosine = glint_sine(glint_phase(degrees) + 0x40000000u);
    return (int32_t)glint_round_shift64(cosine * (GLINT_UNIT * GLINT_UNIT), 30);
}

/* Sets the cosines of a cone's edges, corrected for the length of the axis, and the slope between them. */
static void prepare_edge(const glint_light *light, glint_prepared_light *prepared) {
    const int32_t inner = cosine_of(light->inner), outer = cosine_of(light->outer),
                  excess = glint_square_excess(prepared->direction);
    const int32_t width = glint_most(inner - outer, 1);
    const unsigned zeros = glint_leading_zeros((uint32_t)width);
    prepared->spot.shift = zeros < 16 ? 16 - zeros : 0;
    prepared->spot.slope = zeros < 17 ? (1 << 30) / (glint_shift_right(width, prepared->spot.shift) | 1) : 0;
    prepared->spot.cosine_inner = inner + glint_excess(inner, excess);
    prepared->spot.cosine_outer = outer + glint_excess(outer, excess);
}

static glint_status prepare_spot(const glint_light *light, glint_prepared_light *prepared, const glint_view *view) {
    if (light->inner < 0 || light->inner > light->outer || light->outer > 180 * GLINT_ONE)
        return GLINT_ERROR_CONE;
    if (glint_light_grows(light))
        return GLINT_ERROR_ATTENUATION;
    if (!glint_light_to_camera(view, light, 0, prepared->direction))
        return GLINT_ERROR_DIRECTION;
    for (int i = 0; i < 3; i++)
        prepared->direction[i] = (int16_t)-prepared->direction[i];
    prepare_edge(light, prepared);
    return GLINT_OK;
}

/* ---- Objects that a cone misses ---- */

/* The way from a spot to an object, and the object's box, are scaled to this many bits and a sign. */
#define WAY_BITS 13

/* Until the way has been rotated, it has these bits more. */
#define FINE_WAY_BITS 12

/* An object as a spot sees it, in any unit. */
typedef struct sighted {
    int32_t way[3];     /* from the spot to the middle of the object's box, in camera space */
    int32_t half[3][3]; /* the three half edges of the box, in world space */
} sighted;

static void sight(const glint_light *light, const glint_view *view, const glint_object *object, sighted *to) {
    const glint_vector *const extent = &object->mesh->extent, *const offset = &object->mesh->offset;
    const int32_t position[3] = {light->position.x, light->position.y, light->position.z},
                  size[3] = {extent->x, extent->y, extent->z}, middle[3] = {offset->x, offset->y, offset->z};
    int64_t way[3], half[3][3];
    uint64_t all = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t *const m = object->pose.m[i];
        way[i] = (int64_t)m[3] - position[i];
        for (int j = 0; j < 3; j++) {
            way[i] += glint_shift_right64((int64_t)m[j] * middle[j], 16);
            half[j][i] = glint_shift_right64((int64_t)m[j] * size[j], 16);
            all |= glint_magnitude64(half[j][i]);
        }
        all |= glint_magnitude64(way[i]);
    }
    /* in camera space, the components of the way may have one more bit */
    const unsigned bits = glint_bits64(all) + 1, down = bits > WAY_BITS ? bits - WAY_BITS : 0,
                   early = bits > WAY_BITS + FINE_WAY_BITS ? bits - WAY_BITS - FINE_WAY_BITS : 0;
    for (int i = 0; i < 3; i++) {
        int64_t rotated = 0;
        for (int j = 0; j < 3; j++) {
            rotated += view->rotation[i][j] * glint_shift_right64(way[j], early);
            to->half[j][i] = (int32_t)glint_shift_right64(half[j][i], down);
        }
        to->way[i] = (int32_t)glint_shift_right64(rotated, 16 + down - early);
    }
}

/* Returns the square of the distance from the box's middle to its farthest corner, rounded up. */
static uint32_t square_of_radius(const int32_t half[3][3]) {
    uint32_t most = 0;
    for (int corner = 0; corner < 4; corner++) {
        uint32_t square = 0;
        for (int i = 0; i < 3; i++) {
            const int32_t x =
                half[0][i] + (corner & 1 ? -half[1][i] : half[1][i]) + (corner & 2 ? -half[2][i] : half[2][i]);
            const uint32_t most_x = glint_magnitude_bits(x) + 4; /* three summands and the magnitude may each lack 1 */
            square += most_x * most_x;
        }
        most = square > most ? square : most;
    }
    return most;
}

/*
 * Returns whether all of an object lies outside of a spot's cone. A sphere of radius r lies outside of a cone of half
 * angle t, up to 90 degrees, if p cos t - a sin t > r, where a and p are the coordinates of its middle along the axis
 * and away from it. The test requires 1/64 of the middle's distance more than that, so that no fragment sees the light
 * by rounding. Each component of the axis may be 3 steps of 2^15 too small, and so may a be: where p is found from a,
 * there is room for this.
 */
static int misses_cone(const glint_light *light, const glint_prepared_light *prepared, const glint_view *view,
                       const glint_object *object) {
    const uint32_t angle = glint_phase(light->outer);
    const int32_t sine = glint_sine(angle) >> 15, cosine = glint_sine(angle + 0x40000000u) >> 15; /* Q15 */
    const int16_t *const back = prepared->direction;
    sighted s;
    if (cosine <= 0)
        return 0;
    sight(light, view, object, &s);
    const int32_t axial = -glint_shift_right(s.way[0] * back[0] + s.way[1] * back[1] + s.way[2] * back[2], 15);
    const uint32_t square = (uint32_t)(s.way[0] * s.way[0]) + (uint32_t)(s.way[1] * s.way[1]) +
                            (uint32_t)(s.way[2] * s.way[2]),
                   most_axial = glint_magnitude_bits(axial) + 6, axial_square = most_axial * most_axial;
    const uint32_t across_square = square > axial_square ? square - axial_square : 0,
                   radius_square = square_of_radius((const int32_t(*)[3])s.half);
    if (radius_square >= square)
        return 0;
    const int32_t least = (int32_t)(glint_square_root(radius_square) + (glint_square_root(square) >> 6)) + 4 +
                          glint_shift_right(axial * sine, 15);
    const uint64_t least_square = (uint64_t)((int64_t)least * least);
    return least < 0 || (uint64_t)across_square * (uint32_t)(cosine * cosine) > least_square << 30;
}

const glint_light_type glint_light_spot = {.prepare = prepare_spot,
                                           .has_place = 1,
                                           .places = &glint_lamp_places,
                                           .place = glint_point_place,
                                           .misses = misses_cone,
                                           .has_cone = 1,
                                           .arrive = glint_arrive_from_place,
                                           .bring = glint_spot_bring,
                                           .reach = glint_spot_reach};
