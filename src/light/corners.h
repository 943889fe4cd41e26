/* SPDX-License-Identifier: MIT */
/**
 * @file corners.h
 * Light at single points ("corners"): vertices, and centroids of facets. Each object is lit in a space of its own, into
 * which its lights and the eye are transformed once. Distances in this space are those of the world times a constant,
 * so that cosines are the same.
 *
 * | quantity | format | range |
 * | --- | --- | --- |
 * | place of a point, from the mesh's middle | int32, in a unit that each object chooses | +-(2^30 - 2^16) |
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

/** The transform from the world to the space in which an object is lit. */
typedef struct glint_corner_space {
    int32_t rotation[3][3]; /* rotates vectors in Q28, and scales them; the unit of places is then 2^exponent */
    int32_t exponent;       /* from -64 to 64 */
    uint32_t inverse;       /* 1 / length of the rows of rotation = inverse 2^inverse_exponent, 16 bits */
    int32_t inverse_exponent;
    int64_t middle[3]; /* of the mesh, in the world, Q28 */
    int32_t range[3];  /* the largest coordinates of points, relative to the middle */
} glint_corner_space;

/** The place of a light or of the eye, as points of an object see it. */
typedef struct glint_corner_place {
    int32_t vector[3]; /* in units of 2^shift; 2^down / 2 is added, so that cutting the way off rounds it */
    uint8_t shift;
    uint8_t down; /* the way from any point has 15 bits when it is shifted right by this */
} glint_corner_place;

/** A light as an object sees it. */
typedef struct glint_corner_light {
    glint_reach_light *reach; /* null of directional lights */
    const glint_prepared_light *source;
    const glint_weights *weights;
    glint_corner_place place;   /* directional: `vector` is the unit vector towards the light */
    uint8_t shines;             /* its specular light is visible */
    uint8_t is_gated;           /* it has no highlight at points that face away from it */
    int16_t axis[3];            /* spot: unit vector opposite to its axis; */
    int32_t axis_excess;        /* the square of its length less that of source->direction's */
    uint16_t linear, quadratic; /* attenuation, 16 and 15 bits: at distance length 2^exponent light is divided by */
    int16_t linear_exponent;    /* 1 + linear length 2^(exponent + linear_exponent - 16) */
    int16_t quadratic_exponent; /* + quadratic length^2 2^(2 exponent + quadratic_exponent - 31) */
} glint_corner_light;

/** The lights of the object whose corners are being lit; each frame has one of these. */
typedef struct glint_corner_lights {
    uint32_t object;              /* the object's number in the scene + 1, or 0 for none */
    uint32_t count;               /* number of lights that reach it */
    const glint_shading *shading; /* of its material */
    glint_highlight *highlight;
    const glint_mesh *mesh;
    uint8_t has_colours;   /* the mesh's vertices have colours of their own */
    uint8_t is_even;       /* the space is the mesh's own, scaled evenly; else it is the camera's */
    uint8_t is_cubic;      /* the mesh's three extents are equal */
    uint8_t is_local;      /* the eye has a place; else `eye.vector` is the unit vector towards it */
    uint8_t takes_largest; /* the larger of ambient and all other light is taken, not their sum */
    glint_corner_place eye;
    int32_t matrix[3][3]; /* from steps of the mesh to places, 15 bits; in an even space only its diagonal is set */
    int32_t area[3];      /* products of two extents, 30 bits; set for facets if the extents differ */
    glint_corner_light lights[1];
} glint_corner_lights;

/** A point to be lit. */
typedef struct glint_lit_point {
    int32_t normal[3], place[3];
} glint_lit_point;

/** The way from a point to a place. */
typedef struct glint_corner_sight {
    int32_t direction[3]; /* unit, 1 = GLINT_UNIT */
    int32_t cosine;       /* between the direction and the normal, Q15; up to one part in 2^12 too small */
    uint32_t length;      /* the way's length is length 2^exponent; 14 to 16 bits, one part in 2^13 too short */
    int32_t exponent;
} glint_corner_sight;

/** Returns the bytes of a scene's glint_corner_lights; 0 if no object is lit at its corners. */
size_t glint_corners_size(const glint_scene *scene);

/** Finds the unit vector against a light's direction in an object's space, 1 = GLINT_UNIT. */
void glint_corner_towards(const glint_corner_space *space, const glint_light *light, int32_t to[3]);

/**
 * Makes a vector below 2^31 - 2^15 unit, 1 = GLINT_UNIT, each component off by at most 2.3 steps; 0 stays 0.
 * @param exponent receives n
 * @return its length, 14 to 16 bits, times 2^-n; too short by one part in 2^13
 */
uint32_t glint_corner_unit(int32_t v[3], int32_t *exponent);

/** A way of 15 bits is precise enough if its square has no more leading zeros: 13 bits are left. */
#define GLINT_CORNER_ZEROS 6

/** Find the highlights of Blinn-Phong and of Phong: around the half vector, and around the mirrored L. */
glint_highlight glint_highlight_of_half_vector GLINT_IF_LINKED, glint_highlight_of_mirror GLINT_IF_LINKED;

/** Finds the way from a point to a place that is much nearer to it than `down` allows for, with all bits. */
void glint_corner_see_near(const glint_corner_place *place, const glint_lit_point *point, glint_corner_sight *to);

/**
 * Finds the way from a point to a place. Each component of the direction is off by at most 4 steps.
 * @return 0 if the light is gated and the point faces away; then nothing else is set
 */
static inline int glint_corner_see(const glint_corner_place *place, const glint_lit_point *point, uint32_t is_gated,
                                   glint_corner_sight *to) {
    const unsigned shift = place->shift, down = place->down;
    const int32_t x = glint_shift_right(place->vector[0] - glint_shift_right(point->place[0], shift), down),
                  y = glint_shift_right(place->vector[1] - glint_shift_right(point->place[1], shift), down),
                  z = glint_shift_right(place->vector[2] - glint_shift_right(point->place[2], shift), down);
    const uint32_t square = (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z);
    const unsigned zeros = glint_leading_zeros(square) & ~1u;
    if (zeros > GLINT_CORNER_ZEROS) {
        glint_corner_sight near; /* as the address of `to` is not taken, fields that callers ignore cost nothing */
        glint_corner_see_near(place, point, &near);
        *to = near;
        return 1;
    }
    const int32_t dot = point->normal[0] * x + point->normal[1] * y + point->normal[2] * z; /* below 2^30.8 */
    if (is_gated && dot <= 0)
        return 0;
    const uint32_t scaled = square << zeros >> 2; /* 2^28 to 2^30 */
    const int32_t root = glint_inverse_root(scaled);
    const unsigned back = 16 - zeros / 2;
    const int32_t half = 1 << (back - 1);
    to->cosine = glint_shift_right(glint_shift_right(dot, 15) * root, back);
    to->direction[0] = glint_shift_right(x * root + half, back); /* |(x, y, z)| root is at most 2^16 GLINT_UNIT */
    to->direction[1] = glint_shift_right(y * root + half, back);
    to->direction[2] = glint_shift_right(z * root + half, back);
    to->length = ((scaled + (1u << 13)) >> 14) * (uint32_t)root >> 16;
    to->exponent = (int32_t)(down + 1 - zeros / 2);
    return 1;
}

#endif
