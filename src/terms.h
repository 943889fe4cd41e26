/* SPDX-License-Identifier: MIT */
/**
 * @file terms.h
 * Light as terms. A node is exact light at a point of a triangle; terms are polynomials through a triangle's nodes; a
 * row of colours is what terms make of pixels that follow each other.
 */
#ifndef GLINT_TERMS_H
#define GLINT_TERMS_H

#include "polynomial.h"

/** Where glint_nodes_light is to sum all lights that a point clearly faces. */
#define GLINT_ALL_LIT 0x100u

/** Light at a point. */
typedef struct glint_node {
    int32_t sum[3];                    /* of lights: 15 bits less sum_bits for 1 */
    int16_t side[GLINT_LIGHTS_MAX];    /* N.L times strength, Q15 */
    int16_t lobe[GLINT_LIGHTS_MAX][3]; /* deviation, and the light's strength, Q15 */
    uint32_t levels;                   /* what all lights that it does not clearly face away from make: in Q4 */
    uint32_t closeness;                /* most of these lights': depth over the distance, Q8 */
    uint8_t lit, dark;                 /* lights that clearly shine on it, and that clearly do not */
    uint8_t far;                       /* lights whose deviation was cut off */
    uint8_t unfit;                     /* lights without a half vector here */
} glint_node;

/** A highlight of a triangle. */
typedef struct glint_lobe {
    glint_quadratic x, y, strength; /* in the high half */
    const int32_t *weight;
    int is_attenuated;
} glint_lobe;

/** A light that shines on a part of a triangle. */
typedef struct glint_side {
    glint_quadratic cosine; /* N.L times strength, in the high half */
    const int32_t *weight;
} glint_side;

/** A triangle's light. */
typedef struct glint_terms {
    const glint_light_terms *light;
    const glint_power_table *power;
    glint_quadratic sum[3]; /* channels, or one scalar in the high half */
    uint32_t side_count, lobe_count;
    glint_side sides[GLINT_LIGHTS_MAX];
    glint_lobe lobes[GLINT_LIGHTS_MAX];
    glint_quadratic square; /* M.M, where all else is times |M|, M the normal over w; in the high half, Q14 */
    glint_plane surface[3]; /* colours of its own, Q30 */
    uint8_t has_surface, takes_largest;
    uint8_t is_over_length; /* 2: lobes' twice */
    uint8_t is_channels;    /* the sum is all there is: three channels, half a level and ambient light included */
    uint8_t is_curved;
} glint_terms;

/** Prepares a material. */
void glint_terms_prepare(const glint_frame *frame, glint_shading *shading);

/** Lights the vertices of a triangle, unless they are. */
glint_light_triangle glint_terms_light;

/**
 * Finds light at some points.
 * @param at normals, rays and 1/w
 * @param held lights that go into sums, or GLINT_ALL_LIT
 * @param lights those of which anything is asked
 * @param lobes those whose deviation is asked
 */
void glint_nodes_light(const glint_frame *frame, const glint_shading *shading, glint_fragments *at, uint32_t held,
                       uint32_t lights, uint32_t lobes, glint_node *nodes);

/** A triangle's light, from its corners on. @return 0 where polynomials do not fit */
int glint_terms_begin(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                      const glint_part *part, glint_terms *terms);

/** Colours of `count` pixels of a row from (x, y) of the anchor on. */
void glint_terms_row(const glint_terms *terms, int32_t x, int32_t y, uint32_t count, int32_t (*row)[3]);

#endif
