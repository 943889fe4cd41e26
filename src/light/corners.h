/* SPDX-License-Identifier: MIT */
/**
 * @file corners.h
 * Light at one point: a vertex, or a facet's centroid. Each object is lit in a space of its own, to which its lights
 * and the eye are brought once. Distances there are those of the world times a constant, so that cosines stay.
 *
 * | quantity | format | range |
 * | --- | --- | --- |
 * | place of a point, from the mesh's middle | int32, one unit per object | +-(2^30 - 2^16) |
 * | place of a light or of the eye | int32, that unit times 2^shift | +-2^30 |
 * | unit normal | int32, 1 = 2^15 | length 32761 to 32769 |
 * | unit vector towards a light or the eye | int32, 1 = GLINT_UNIT | length 32764 +-2.3 |
 * | strength, diffuse and specular light | uint32, Q15 | 0 to 2^15 |
 * | colour of a vertex or facet | int16, 1 = GLINT_COLOUR_ONE | 0 to 1 |
 */
#ifndef GLINT_LIGHT_CORNERS_H
#define GLINT_LIGHT_CORNERS_H

#include "../math/numeric.h"
#include "shading.h"

/** From the world to the space in which an object is lit. */
typedef struct glint_corner_space {
    int32_t turn[3][3]; /* of vectors in Q28: 2^exponent units of places are 1 */
    int32_t exponent;   /* from -64 to 64 */
    uint32_t inverse;   /* 1 / length of the rows of turn = inverse 2^inverse_exponent, 16 bits */
    int32_t inverse_exponent;
    int64_t middle[3]; /* of the mesh, in the world, Q28 */
    int32_t range[3];  /* places of points are no farther from there */
} glint_corner_space;

/** A place that points see. */
typedef struct glint_corner_place {
    int32_t at[3]; /* and 2^down / 2 more, so that cutting the way off rounds it */
    uint8_t shift; /* of `at` */
    uint8_t down;  /* brings the way from any point to 15 bits */
} glint_corner_place;

/** A light as an object sees it. */
typedef struct glint_corner_light {
    glint_reach_light *reach; /* null of directional lights */
    const glint_prepared_light *source;
    const glint_weights *weights;
    glint_corner_place place;   /* directional: the unit vector towards the light */
    uint8_t shines;             /* its specular light is visible */
    uint8_t is_gated;           /* it adds nothing to a point that faces away */
    int16_t axis[3];            /* spot: unit, against its axis; */
    int32_t axis_excess;        /* its length's square less that of source->direction */
    uint16_t linear, quadratic; /* 16 and 15 bits, or 0. A light length 2^exponent away is divided by */
    int16_t linear_exponent;    /* 1 + linear length 2^(exponent + this - 16) */
    int16_t quadratic_exponent; /* + quadratic length^2 2^(2 exponent + this - 31) */
} glint_corner_light;

/** The lights of the object whose corners are being lit; one of these per frame. */
typedef struct glint_corner_lights {
    uint32_t object;              /* number in the scene + 1, or 0 */
    uint32_t count;               /* lights that reach it */
    const glint_shading *shading; /* its material */
    glint_highlight *highlight;
    const glint_mesh *mesh;
    uint8_t has_colours;   /* the mesh's vertices have colours of their own */
    uint8_t is_even;       /* the space is the object's own, scaled evenly */
    uint8_t is_cubic;      /* the mesh's extents are the same */
    uint8_t is_local;      /* the eye has a place; else it is the unit vector towards the eye */
    uint8_t takes_largest; /* of ambient light and all other */
    glint_corner_place eye;
    int32_t matrix[3][3]; /* from steps to places, 15 bits: of an even space its diagonal */
    int32_t area[3];      /* of facets where the extents differ: the products of two extents, 30 bits */
    glint_corner_light lights[1];
} glint_corner_lights;

/** A point to be lit. */
typedef struct glint_lit_point {
    int32_t normal[3], place[3];
} glint_lit_point;

/** What a point sees of a place. */
typedef struct glint_corner_sight {
    int32_t direction[3]; /* unit, 1 = GLINT_UNIT */
    int32_t cosine;       /* between that and the normal, Q15, 1 is up to one part in 2^12 too small */
    uint32_t length;      /* of the way, 14 to 16 bits, times 2^exponent; one part in 2^13 too short */
    int32_t exponent;
} glint_corner_sight;

/** Bytes of the lights at corners that a scene has; 0 where no object is lit at its corners. */
size_t glint_corners_size(const glint_scene *scene);

/** Brings the opposite of a light's direction to an object's space, unit, 1 = GLINT_UNIT. */
void glint_corner_towards(const glint_corner_space *space, const glint_light *light, int32_t to[3]);

/**
 * Makes a vector below 2^31 - 2^15 unit, 1 = GLINT_UNIT, each component off by at most 2.3 steps; 0 stays 0.
 * @param exponent receives n
 * @return its length, 14 to 16 bits, times 2^-n; too short by one part in 2^13
 */
uint32_t glint_corner_unit(int32_t v[3], int32_t *exponent);

/** Leading zeros up to which a way of 15 bits is precise enough: 13 bits are left. */
#define GLINT_CORNER_ZEROS 6

/** Highlights around the half vector and the mirrored light. */
glint_highlight glint_highlight_of_half_vector GLINT_IF_LINKED, glint_highlight_of_mirror GLINT_IF_LINKED;

/** The way from a point to a place that is nearer to it than to others, with all bits that there are. */
void glint_corner_see_near(const glint_corner_place *place, const glint_lit_point *point, glint_corner_sight *to);

/**
 * Finds what a point sees of a place. Each component of the direction is off by at most 4 steps.
 * @return 0 where the point is gated and faces away; then the rest is not found
 */
static inline int glint_corner_see(const glint_corner_place *place, const glint_lit_point *point, uint32_t is_gated,
                                   glint_corner_sight *to) {
    const unsigned shift = place->shift, down = place->down;
    const int32_t x = glint_shift_right(place->at[0] - glint_shift_right(point->place[0], shift), down),
                  y = glint_shift_right(place->at[1] - glint_shift_right(point->place[1], shift), down),
                  z = glint_shift_right(place->at[2] - glint_shift_right(point->place[2], shift), down);
    const uint32_t square = (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z);
    const unsigned zeros = glint_leading_zeros(square) & ~1u;
    if (zeros > GLINT_CORNER_ZEROS) {
        glint_corner_sight near; /* of `to` itself no address is taken: what callers do not use is not found */
        glint_corner_see_near(place, point, &near);
        *to = near;
        return 1;
    }
    const int32_t along = point->normal[0] * x + point->normal[1] * y + point->normal[2] * z; /* below 2^30.8 */
    if (is_gated && along <= 0)
        return 0;
    const uint32_t scaled = square << zeros >> 2; /* 2^28 to 2^30 */
    const int32_t root = glint_inverse_root(scaled);
    const unsigned back = 16 - zeros / 2;
    const int32_t half = 1 << (back - 1);
    to->cosine = glint_shift_right(glint_shift_right(along, 15) * root, back);
    to->direction[0] = glint_shift_right(x * root + half, back); /* |(x, y, z)| root is at most 2^16 UNIT */
    to->direction[1] = glint_shift_right(y * root + half, back);
    to->direction[2] = glint_shift_right(z * root + half, back);
    to->length = ((scaled + (1u << 13)) >> 14) * (uint32_t)root >> 16;
    to->exponent = (int32_t)(down + 1 - zeros / 2);
    return 1;
}

#endif
