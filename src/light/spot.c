/* SPDX-License-Identifier: MIT */
/* Spots: point lights within a cone, with a smooth step from its inner to its outer angle. */
#include "lamps.h"
#include "point.h"

/* Cosine of an angle in degrees, times UNIT^2. */
static int32_t cosine_of(glint_q16 degrees) {
    int64_t cosine = glint_sine(glint_phase(degrees) + 0x40000000u);
    return (int32_t)glint_round_shift64(cosine * (GLINT_UNIT * GLINT_UNIT), 30);
}

/* The cosines of a cone's edges, and what lies between them. */
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

/* Bits and a sign that a spot's way to an object, and the object's box, are brought to. */
#define WAY_BITS 13

/* And bits more until the way has been turned. */
#define WAY_MORE 12

/* An object's middle as a spot sees it, and half of its box along the mesh's axes; in any unit. */
typedef struct sighted {
    int32_t way[3], half[3][3];
} sighted;

static void sight(const glint_light *light, const glint_view *view, const glint_object *object, sighted *to) {
    const glint_vector *const extent = &object->mesh->extent, *const offset = &object->mesh->offset;
    const int32_t at[3] = {light->position.x, light->position.y, light->position.z},
                  size[3] = {extent->x, extent->y, extent->z}, middle[3] = {offset->x, offset->y, offset->z};
    int64_t way[3], half[3][3];
    uint64_t all = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t *const m = object->pose.m[i];
        way[i] = (int64_t)m[3] - at[i];
        for (int j = 0; j < 3; j++) {
            way[i] += glint_shift_right64((int64_t)m[j] * middle[j], 16);
            half[j][i] = glint_shift_right64((int64_t)m[j] * size[j], 16);
            all |= glint_magnitude64(half[j][i]);
        }
        all |= glint_magnitude64(way[i]);
    }
    /* turned to view space, a way has up to a bit more */
    const unsigned bits = glint_bits64(all) + 1, down = bits > WAY_BITS ? bits - WAY_BITS : 0,
                   early = bits > WAY_BITS + WAY_MORE ? bits - WAY_BITS - WAY_MORE : 0;
    for (int i = 0; i < 3; i++) {
        int64_t turned = 0;
        for (int j = 0; j < 3; j++) {
            turned += view->rotation[i][j] * glint_shift_right64(way[j], early);
            to->half[j][i] = (int32_t)glint_shift_right64(half[j][i], down);
        }
        to->way[i] = (int32_t)glint_shift_right64(turned, 16 + down - early);
    }
}

/* The square of the distance of the box's farthest corner from its middle, no less than it is. */
static uint32_t square_of_radius(const int32_t half[3][3]) {
    uint32_t most = 0;
    for (int corner = 0; corner < 4; corner++) {
        uint32_t square = 0;
        for (int i = 0; i < 3; i++) {
            const int32_t x =
                half[0][i] + (corner & 1 ? -half[1][i] : half[1][i]) + (corner & 2 ? -half[2][i] : half[2][i]);
            const uint32_t reach = glint_magnitude_bits(x) + 4; /* each part may lack 1, the magnitude too */
            square += reach * reach;
        }
        most = square > most ? square : most;
    }
    return most;
}

/*
 * A sphere of radius r lies outside a cone of half angle t, up to a right one, if its middle, a along the axis and p
 * from it, has p cos t - a sin t > r. It is to have more than that by 1/64 of its distance, so that no rounding of what
 * fragments see takes one of them in. The axis is short by up to 3 of 2^15 in each number, and so is a: what p is found
 * from has room for it.
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
    const int32_t along = -glint_shift_right(s.way[0] * back[0] + s.way[1] * back[1] + s.way[2] * back[2], 15);
    const uint32_t square = (uint32_t)(s.way[0] * s.way[0]) + (uint32_t)(s.way[1] * s.way[1]) +
                            (uint32_t)(s.way[2] * s.way[2]),
                   reach = glint_magnitude_bits(along) + 6, axial = reach * reach,
                   across = square > axial ? square - axial : 0, radius = square_of_radius((const int32_t(*)[3])s.half);
    if (radius >= square)
        return 0;
    const int32_t least = (int32_t)(glint_square_root(radius) + (glint_square_root(square) >> 6)) + 4 +
                          glint_shift_right(along * sine, 15);
    return least < 0 || (uint64_t)across * (uint32_t)(cosine * cosine) > (uint64_t)((int64_t)least * least) << 30;
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
