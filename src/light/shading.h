/* SPDX-License-Identifier: MIT */
/** @file shading.h Materials under the scene's lights, once a frame. */
#ifndef GLINT_SHADING_H
#define GLINT_SHADING_H

#include "../glint_extras.h"
#include "../math/numeric.h"
#include "../scene/view.h"

struct glint_suns;

/** Intervals of a power table, and bits of the position within one that are used. */
#define GLINT_POWER_TABLE_BITS 7
#define GLINT_POWER_INTERVALS (1 << GLINT_POWER_TABLE_BITS)
#define GLINT_POWER_FRACTION_BITS 12

/** Intervals from 1/2 to 1 of the table of an exponent below 2. */
#define GLINT_POWER_OCTAVE 64

/** x^p: a table over u = 1 - x^2 or, where p < 2, over x between two powers of two, followed by that of these powers.
 */
typedef struct glint_power_table {
    int32_t exponent;            /* p, Q16.16 */
    uint32_t direct;             /* p < 2: the table is over x; fragments compute the power */
    uint32_t window;             /* Q30: the table spans sin^2 from 0 to this power of two; beyond, the power is 0 */
    uint32_t index_shift;        /* sin^2 in Q30 >> this is the interval */
    int32_t cosine_square_floor; /* Q15: below this cos^2 lies outside the window */
    uint16_t value[GLINT_POWER_INTERVALS + 1]; /* Q15 */
} glint_power_table;

/** What a material makes of a light, Q12. */
typedef struct glint_weights {
    uint32_t diffuse[3], specular[3];
} glint_weights;

/** A material under the scene's lights. */
typedef struct glint_shading {
    const glint_material *material;
    int32_t shininess;
    uint32_t ambient[3]; /* Q23 */
    glint_weights weights[GLINT_LIGHTS_MAX];
    uint32_t lights;               /* bit i: light i shows */
    uint32_t has_specular;         /* bit i: its specular light does */
    uint32_t changed;              /* 0: all above is what the last frame left here, and so are its tables */
    const struct glint_suns *suns; /* of directional lights alone, or null */
    uint32_t power_sum;            /* of `power`, where the arena is kept */
    glint_power_table power;
} glint_shading;

/** A material of the frame as it was prepared. */
static inline const glint_shading *glint_shading_of(const glint_frame *frame, const glint_material *material) {
    const glint_shading *shading = frame->shading;
    while (shading->material != material)
        shading++;
    return shading;
}

/**
 * Finds specular power at a point, Q15: of unit vectors, the normal as long as a point's, the others as GLINT_UNIT; all
 * off by as much as corners.h says.
 */
typedef uint32_t glint_highlight(const glint_power_table *table, const int32_t normal[3], const int32_t light[3],
                                 const int32_t view[3]);

struct glint_shading_model {
    /** Beyond the weights: what `light` needs. May be null. */
    void (*prepare)(glint_shading *shading, uint32_t largest_specular);
    /** Finds the colours of fragments: lamps.h. */
    void (*reflect)(const struct glint_row_walk *walk, struct glint_lit_fragment *f,
                    const struct glint_lit_fragment *end);
    uint8_t is_lit; /* not of surfaces that show their ambient light alone */
    uint8_t lobe;
    glint_highlight *highlight; /* null for surfaces without highlights */
};

/* What a model's specular light lies around. */
#define GLINT_LOBE_OTHER 0       /* neither of these */
#define GLINT_LOBE_NONE 1        /* there is none */
#define GLINT_LOBE_HALF_VECTOR 2 /* Blinn's */
#define GLINT_LOBE_MIRROR 3      /* Phong's */

/**
 * A material's weights and power table.
 * @param shading all 0, or what the same place held in the last frame: tables are then kept if they would be the same
 */
glint_status glint_prepare_shading(const glint_frame *frame, glint_shading *shading, const glint_material *material);

/**
 * A power table for exponent p; weight, Q12, is the largest that its values are multiplied by. What falls below 1/16 of
 * an 8-bit step need not show.
 */
void glint_power_prepare(glint_power_table *table, int32_t exponent, uint32_t weight);

/** cos^p, Q15, for sin^2 in Q30 from the table; p is 2 or more. */
static inline uint32_t glint_power_at(const glint_power_table *table, uint32_t u) {
    if (u >= table->window)
        return 0;
    const uint16_t *node = &table->value[u >> table->index_shift];
    int32_t fraction =
        (int32_t)((u >> (table->index_shift - GLINT_POWER_FRACTION_BITS)) & ((1u << GLINT_POWER_FRACTION_BITS) - 1));
    return (uint32_t)(node[0] + glint_shift_right((node[1] - node[0]) * fraction, GLINT_POWER_FRACTION_BITS));
}

#endif
