/* SPDX-License-Identifier: MIT */
/**
 * @file suns.h
 * Light at each fragment where all lights are directional ("suns"): three scalars for each light take the place of
 * vectors, and fragments have no normal.
 *
 * N' = N/w is linear on the screen, so that N'.L is a plane and N'.N' a quadratic; N.L = N'.L / |N'|. The half vector H
 * of a local viewer is interpolated between corners and made unit to second order, so that N'.H is a quadratic too, and
 * sin^2 = 1 - (N.H)^2 is (N'.N' - (N'.H)^2) / N'.N'. Phong has the view vector V in place of H: of half the angle
 * between R and V, sin^2 = (1 - R.V) / 2 = (N'.N' (1 + L.V) / 2 - N'.L N'.V) / N'.N'. Tables turn N.L and sin^2 into
 * packed colours.
 *
 * | quantity | format |
 * | --- | --- |
 * | N' at corners, 1 being nearly the largest of a triangle | int32, 1 = 2^14 |
 * | L | 1 = 2^15 |
 * | H and V | 1 = 2^14 |
 * | N'.L at fragments | 1 = 2^29 |
 * | N'.H, N'.V and (1 + L.V) / 2 there | 1 = 2^28 |
 * | N'.N' at fragments, below 1 | uint32, 1 = 2^32 |
 * | 1 / length of N' | 1 = 2^14, 16 bits |
 */
#ifndef GLINT_SUNS_H
#define GLINT_SUNS_H

#include "../pixel/format.h"
#include "../raster/triangle.h"
#include "shading.h"

/** Number of entries of a table of diffuse light, over N.L from 0 to 1 ("ramp"). */
#define GLINT_RAMP_ENTRIES 513

/** Number of entries of a table of highlights, over sin^2 ("gloss"); the last ones are 0. */
#define GLINT_GLOSS_ENTRIES 512

/** sin^2 N'.N', 1 = 2^32, counts as below 0 from here on: rounding takes it no lower, and N'.N' is less. */
#define GLINT_SINE_WRAPPED 0xff800000u

/** A directional light on a material. */
typedef struct glint_drawn_sun {
    const uint32_t *ramp;  /* colours over N.L; null without room in the arena: each is then computed, bit for bit */
    const uint32_t *gloss; /* colours over sin^2, behind the ramp; null if the light does not shine */
    uint32_t number;       /* of the light in the scene */
    uint32_t shines;       /* its highlight is visible */
    int32_t light[3];      /* L, unit */
    uint32_t sum;          /* glint_sum of the tables */
} glint_drawn_sun;

/** Values of a vertex for a light that shines. */
typedef struct glint_sun_term {
    int16_t v[3];     /* H, or 0 if L + V is too short; of Phong V */
    uint16_t outside; /* sin^2 between N and H, of Phong of half the angle between R and V: Q16, rounded down; 0 if
                         L + V is too short */
} glint_sun_term;

/** Functions that draw spans where one light is all: without highlight, by the half vector, by the mirrored L. */
typedef struct glint_sun_spans {
    glint_draw_span *matt, *half, *mirror;
    glint_draw_span *small; /* spans of small triangles, by the half vector */
} glint_sun_spans;

/** The directional lights on a material. */
typedef struct glint_suns {
    uint32_t count;
    uint32_t sum_mask;   /* 0 if the ramp of the only light includes ambient light, else all bits */
    uint32_t first;      /* the word that a sum of lights begins with */
    uint32_t dark;       /* the word of ambient light, half a level included */
    uint32_t half_level; /* the word of half a level, or 0 */
    uint32_t shift;      /* sin^2, Q30, shifted right by this is the index of an entry of gloss */
    uint32_t end;        /* sin^2, Q30, where highlights end; 0 if none is visible */
    uint32_t far;        /* a highlight is outside of a triangle if `outside` of all corners exceeds this, Q16, */
    uint32_t far_slope;  /* plus this, Q10, times a square of changes of N' and H */
    uint32_t bend;       /* scalars serve triangles over which the square of H's change is at most this, 1 = 2^28 */
    int32_t small_bend;  /* between corners that bend so far, |H|^2, 1 = 2^28, is less than 1 by at most this */
    int32_t gate;        /* a fragment is lit if N'.L exceeds this: 0, or INT32_MIN for always */
    uint32_t terms;      /* number of terms of a vertex */
    uint8_t is_local;    /* V differs from fragment to fragment: the viewer is local */
    uint8_t is_mirror;   /* highlights are those of Phong */
    uint8_t takes_most;  /* the larger of ambient light and all other is taken, not their sum */
    uint8_t is_rounded;  /* the format cuts words off, so that they include half a level */
    uint8_t is_fine;     /* packed words are too coarse: sun_fine.c lights all triangles */
    uint8_t bits;        /* bits of the format's green, or 8 with output tables */
    uint8_t is_plain;    /* lights add to the word that is there, and all have their tables */
    uint8_t has_own;     /* packed words serve surfaces with colours of their own, too */
    const glint_sun_spans *spans; /* set if there is one light only, whose ramp includes ambient light; else null */
    glint_draw_span *small;       /* draws spans of small triangles */
    int32_t ray_limit;            /* x and y on the screen have rays up to this from its centre, sixteenths */
    int32_t ray_z;                /* z of V */
    glint_drawn_sun suns[1];
} glint_suns;

/** Returns the bytes of the glint_suns of `count` lights. */
#define GLINT_SUNS_SIZE(count) GLINT_ALIGNED(offsetof(glint_suns, suns) + (count) * sizeof(glint_drawn_sun))

/**
 * A quadratic on the screen, modulo 2^32: value + x column + y row + xx column^2 + xy column row + yy row^2.
 */
typedef struct glint_quadratic {
    uint32_t value, x, y, xx, xy, yy;
} glint_quadratic;

/** A quadratic's value at a pixel, and its change to the next column, modulo 2^32. */
typedef struct glint_stepped_quadratic {
    uint32_t value, step;
} glint_stepped_quadratic;

/** Begins with a quadratic at column x and row y. */
static inline glint_stepped_quadratic glint_begin_quadratic(const glint_quadratic *q, uint32_t x, uint32_t y) {
    const uint32_t slope = q->x + y * q->xy, curve = x * q->xx;
    return (glint_stepped_quadratic){q->value + y * (q->y + y * q->yy) + x * (slope + curve),
                                     slope + 2 * curve + q->xx};
}

/** Steps to the next column; `bend` is twice the quadratic's xx. */
static inline void glint_step_quadratic(glint_stepped_quadratic *q, uint32_t bend) {
    q->value += q->step;
    q->step += bend;
}

/** A plane on the screen, modulo 2^32: value + x column + y row. */
typedef struct glint_sun_plane {
    uint32_t value, x, y;
} glint_sun_plane;

/** A light on a triangle. */
typedef struct glint_lit_sun {
    const glint_drawn_sun *sun;
    const struct glint_drawn_lamp *lamp; /* the same light, for sun_fine.c */
    uint8_t is_plain;                    /* suns->is_plain, and gated or faced by all corners: light_list serves */
    uint8_t gloss;                       /* its highlight may be visible, and `half` is set */
    glint_sun_plane light;               /* N'.L */
    glint_quadratic half;                /* N'.H; of Phong N'.V */
    glint_quadratic light_view;          /* (1 + L.V) / 2; set for Phong */
} glint_lit_sun;

/** A triangle under suns. Its planes and quadratics count columns and rows from the first pixel of walk->slopes. */
typedef struct glint_sun_triangle {
    const glint_suns *suns;
    /* copies that spans of one light use at each pixel: of the light, of `suns`, of the walk and of fields below */
    const uint32_t *ramp, *gloss;
    uint32_t shift, dark, z_dx;
    uintptr_t from_depth; /* the bytes from a pixel's depth to its colour */
    uint32_t light_dx, square_bend, half_bend, light_view_bend;
    const glint_vertex *corners[3];
    const glint_sun_term *terms[3];
    int32_t weight[3];             /* of small triangles: 1/w at corners, 15 bits, below 0 if seen from behind */
    int32_t n[3][3], d1[3], d2[3]; /* N' at corners, and differences of the others from the first one */
    const int16_t *own_at[3];      /* the surface's own colours at corners, 1 = GLINT_COLOUR_ONE */
    glint_sun_plane own[3];        /* the surface's own colours at fragments, 1 = 2^29 */
    uint32_t least;                /* the least N'.N' of a corner, 1 = 2^28 */
    uint32_t change;               /* the largest square of a difference between N' of two corners, 1 = 2^28 */
    unsigned zeros;                /* leading zeros of the slopes */
    glint_quadratic normal;        /* N'.N' */
    uint32_t count;                /* number of lights that a corner faces */
    glint_lit_sun lit[GLINT_LIGHTS_MAX];
} glint_sun_triangle;

/** Computes a word of a light's ramp, bit for bit as the table has it. */
uint32_t glint_ramp_word(const glint_shading *shading, const glint_drawn_sun *sun, uint32_t index);

/** Computes a word of a light's gloss, bit for bit as the table has it. */
uint32_t glint_gloss_word(const glint_shading *shading, const glint_drawn_sun *sun, uint32_t index);

/** The largest x or y of V before it is made unit. */
#define GLINT_MOST_RAY 37000

/** The least N'.N' of a triangle's fragments for which the table of roots has entries. 1 = 2^28 */
#define GLINT_LEAST_NORMAL (1u << 25)

/** Sets the normals and terms of a triangle's vertices that have none yet. */
void glint_light_sun_vertices(const glint_frame *frame, glint_draw *draw, const glint_transform *transform, uint32_t i);

/** Returns sin^2 between N and H, Q30, of Phong of half the angle between R and V, at a pixel: by vectors, given N,
 * 1 = 2^15. */
uint32_t glint_find_sine(const glint_row_walk *walk, const glint_drawn_sun *sun, int32_t row, int32_t column,
                         const int32_t n[3]);

/** Sets N' at corners, and N'.N'. @return 0 if normals or 1/w change too much */
int glint_begin_sun_normals(const glint_row_walk *walk, glint_sun_triangle *t);

/** Sets all lights that a corner faces. @return 0 if scalars do not serve the triangle */
int glint_begin_suns(const glint_row_walk *walk, glint_sun_triangle *t);

/** Finds the word of a triangle whose corners have the same normal. @return 0 if a highlight may be visible on it */
int glint_find_one_word(const glint_row_walk *walk, uint32_t *word);

/** Draws a span: lists its visible pixels, adds each light to all of them, and stores them. */
glint_draw_span glint_draw_sun_list;

/** Sets the planes of a surface's own colours. */
void glint_begin_own(glint_sun_triangle *t, const glint_slopes *slopes);

/** Returns a word times a surface's own colour, 1 = 2^15, plus half a level if words include it. */
uint32_t glint_multiply_word(const glint_suns *suns, uint32_t word, int32_t red, int32_t green, int32_t blue);

/** Adds a light to a pixel's colour, given N'.L and the index of its entry of gloss. */
void glint_add_sun(const glint_row_walk *walk, const glint_drawn_sun *sun, glint_spread *p, int32_t light,
                   uint32_t entry);

/** Replaces each channel of pixels by that of ambient light, if the latter is larger. */
void glint_take_larger(uint32_t dark, glint_spread *p, const glint_spread *end);

/** Sets the weights of a small triangle's corners. */
void glint_begin_small_suns(const glint_row_walk *walk, glint_sun_triangle *t);

/** Draws a span of a small triangle. */
glint_draw_span glint_draw_small_suns;

/** Draw a span of a small triangle where one light with a highlight around H is all, in 16 bits a pixel. */
glint_draw_span glint_draw_small_rgb565, glint_draw_small_rgb565_be;

/** Begins with a triangle that scalars serve and packed words do not. @return the function that draws its spans, or
 * null if the triangle is so far that 1/w has too few bits for its own colours */
glint_draw_span *glint_begin_fine_suns(glint_row_walk *walk);

/** Sets the words of ambient light, and the limits of highlights. */
void glint_ramps_prepare(glint_suns *suns, const glint_shading *shading);

/** Makes a light's tables, of glint_ramps_size bytes, unless the last frame left them in the same place. */
void glint_ramps_make(const glint_shading *shading, glint_drawn_sun *sun, uint32_t *tables,
                      const uint32_t *last_tables);

/** Returns the bytes of a light's tables. */
static inline size_t glint_ramps_size(const glint_drawn_sun *sun) {
    return (GLINT_RAMP_ENTRIES + 3 + (sun->shines ? GLINT_GLOSS_ENTRIES : 0u)) * sizeof(uint32_t);
}

/** Returns a channel of a word times that of a colour, 1 = 2^15, with half a step; rounding may have taken the colour
 * below 0. */
static inline uint32_t glint_times_channel(uint32_t channel, int32_t own) {
    return channel * (uint32_t)glint_most(own, 0) + (1u << 14);
}

/** Returns a word times a colour. */
static inline uint32_t glint_times_colour(uint32_t word, int32_t red, int32_t green, int32_t blue) {
    return (glint_times_channel(word >> 10 & 0x3ff, red) >> 15 << 10) +
           (glint_times_channel(word >> 21, green) >> 15 << 21) + (glint_times_channel(word & 0x1ff, blue) >> 15);
}

/** Clamps each channel of a sum of two words at 1, and clears the guard bits. */
static inline uint32_t glint_clamp_word(uint32_t word) {
    const uint32_t over = word & GLINT_SPREAD_GUARD;
    return over ? (word | (over - (over >> 9))) - over : word;
}

/** Returns 2^14 / sqrt(x 2^-32), rounded, x from 2^28 up: of the middle of the 2^22 values that share an entry. */
static inline uint32_t glint_over_normal(uint32_t square) {
    return *(const uint16_t *)(const void *)((const uint8_t *)glint_root_table + (2 * (int32_t)(square >> 22) - 128));
}

/** Returns the index of a pixel's entry of gloss, given N'.N' sin^2, 1 = 2^32, and `over` = glint_over_normal. */
static inline uint32_t glint_entry_of_sine(const glint_suns *suns, uint32_t sine, uint32_t over) {
    return sine >= GLINT_SINE_WRAPPED ? 0 : ((sine >> 16) * over >> 14) * over >> suns->shift;
}

#endif
