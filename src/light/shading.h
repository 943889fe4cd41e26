/* SPDX-License-Identifier: MIT */
/** @file shading.h Materials under the scene's lights, which are prepared once a frame. */
#ifndef GLINT_SHADING_H
#define GLINT_SHADING_H

#include "../glint_extras.h"
#include "../math/numeric.h"
#include "../scene/view.h"

struct glint_suns;

/** Number of intervals of a power table, and bits of the position within an interval. */
#define GLINT_POWER_TABLE_BITS 7
#define GLINT_POWER_INTERVALS (1 << GLINT_POWER_TABLE_BITS)
#define GLINT_POWER_FRACTION_BITS 12

/** Number of intervals from 1/2 to 1, if the exponent is below 2. */
#define GLINT_POWER_OCTAVE 64

/** A table of x^p over u = 1 - x^2. If p < 2, it is over x from 1/2 to 1, and behind that over powers of two. */
typedef struct glint_power_table {
    int32_t exponent;            /* p, Q16.16 */
    uint32_t direct;             /* p < 2: the table is over x, and fragments use logarithms */
    uint32_t window;             /* the table spans sin^2, Q30, from 0 to this power of two; beyond, the power is 0 */
    uint32_t index_shift;        /* sin^2, Q30, shifted right by this is the number of the interval */
    int32_t cosine_square_floor; /* a smaller cos^2, Q15, lies beyond the window */
    uint16_t value[GLINT_POWER_INTERVALS + 1]; /* Q15 */
} glint_power_table;

/** The products of a material's colours and a light's, Q12. */
typedef struct glint_weights {
    uint32_t diffuse[3], specular[3];
} glint_weights;

/** A material under the scene's lights. */
typedef struct glint_shading {
    const glint_material *material;
    int32_t shininess;
    uint32_t ambient[3]; /* ambient light times the material's ambient colour, Q23 */
    glint_weights weights[GLINT_LIGHTS_MAX];
    uint32_t lights;               /* bit i: light i is visible on the material */
    uint32_t has_specular;         /* bit i: its specular light is */
    uint32_t changed;              /* 0: all above is as the last frame left it, and so are the tables */
    const struct glint_suns *suns; /* set if suns serve the material: suns.h; else null */
    uint32_t power_sum;            /* glint_sum of `power`, if the arena is persistent */
    glint_power_table power;
} glint_shading;

/** Returns the shading of a material of the frame. */
static inline const glint_shading *glint_shading_of(const glint_frame *frame, const glint_material *material) {
    const glint_shading *shading = frame->shading;
    while (shading->material != material)
        shading++;
    return shading;
}

/**
 * Returns the specular power at a point, Q15, of unit vectors: 1 = 2^15 of the normal, and 1 = GLINT_UNIT of the
 * others. Their lengths may be off by as much as corners.h says.
 */
typedef uint32_t glint_highlight(const glint_power_table *table, const int32_t normal[3], const int32_t light[3],
                                 const int32_t view[3]);

struct glint_shading_model {
    /** Prepares what a model needs beyond weights. May be null: then the model has no specular light. */
    void (*prepare)(glint_shading *shading, uint32_t largest_specular);
    /** Finds the colours of fragments: lamps.h. */
    void (*reflect)(const struct glint_row_walk *walk, struct glint_lit_fragment *f,
                    const struct glint_lit_fragment *end);
    uint8_t is_lit;             /* lights count; else surfaces have one colour, which stands in `ambient` */
    uint8_t lobe;               /* GLINT_LOBE_* */
    glint_highlight *highlight; /* null for surfaces without highlights */
};

/* The direction around which a model's specular light lies. */
#define GLINT_LOBE_OTHER 0       /* none of the others */
#define GLINT_LOBE_NONE 1        /* there is no specular light */
#define GLINT_LOBE_HALF_VECTOR 2 /* Blinn-Phong */
#define GLINT_LOBE_MIRROR 3      /* Phong */

/**
 * Sets a material's weights and power table.
 * @param shading all 0, or what the same memory held after the last frame: tables that would be the same are not made
 * again
 */
glint_status glint_prepare_shading(const glint_frame *frame, glint_shading *shading, const glint_material *material);

/**
 * Makes the power table of an exponent. Its values are multiplied by weights up to `weight`, Q12: products below 1/16
 * of a step of 8 bits may be 0.
 */
void glint_power_prepare(glint_power_table *table, int32_t exponent, uint32_t weight);

/** Returns cos^p, Q15, from the table, given sin^2, Q30; p is 2 or more. */
static inline uint32_t glint_power_at(const glint_power_table *table, uint32_t u) {
    if (u >= table->window)
        return 0;
    const uint16_t *node = &table->value[u >> table->index_shift];
    int32_t fraction =
        (int32_t)((u >> (table->index_shift - GLINT_POWER_FRACTION_BITS)) & ((1u << GLINT_POWER_FRACTION_BITS) - 1));
    return (uint32_t)(node[0] + glint_shift_right((node[1] - node[0]) * fraction, GLINT_POWER_FRACTION_BITS));
}

/** Returns t^2 (3 - 2 t), Q15, for t from 0 to 1, Q15: the smooth step of a spot's cone. */
static inline uint32_t glint_smooth_step(uint32_t t) {
    return (t * t >> 15) * ((3u << 15) - 2 * t) >> 15;
}

#endif
