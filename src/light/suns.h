/* SPDX-License-Identifier: MIT */
/**
 * @file suns.h
 * Light of directional lights ("suns") alone, at each fragment, from three scalars a light. No normal is made there.
 *
 * N' = N/w is linear on the screen, so that N'.L is a plane and N'.N' a quadratic; N.L = N'.L / |N'|. The half vector H
 * of a local viewer is taken as linear between corners and made unit to second order, so that N'.H is a quadratic too,
 * and sin^2 = 1 - (N.H)^2 is (N'.N' - (N'.H)^2) / N'.N'. Phong takes the view vector V in place of H:
 * (1 - R.V) / 2 = (N'.N' (1 + L.V) / 2 - N'.L N'.V) / N'.N'. Tables turn N.L and sin^2 into packed colours.
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

/** Entries of a table over N.L from 0 to 1, and of one over sin^2, whose last ones are 0. */
#define GLINT_RAMP_ENTRIES 513
#define GLINT_GLOSS_ENTRIES 512

/** Rounding takes sin^2 N'.N', 1 = 2^32, below 0 by less than that is below 2^32; N'.N' is below that. */
#define GLINT_SINE_WRAPPED 0xff800000u

/** A directional light on a material. */
typedef struct glint_drawn_sun {
    const uint32_t *ramp;  /* colours over N.L; null where the arena had no room: then each is computed, */
    const uint32_t *gloss; /* to the same bits; and over sin^2, of lights that shine: behind the ramp */
    uint32_t number;       /* of the light */
    uint32_t shines;       /* its highlight is visible */
    int32_t light[3];      /* towards it */
    uint32_t sum;          /* glint_sum of the tables */
} glint_drawn_sun;

/** What a vertex keeps of a light that shines. */
typedef struct glint_sun_term {
    int16_t v[3];     /* H, or 0 where L + V is too short; V of Phong */
    uint16_t outside; /* sin^2 of the angle from the highlight, of Phong of half of it, Q16; rather less than more, and
                         0 where L + V is too short */
} glint_sun_term;

/** Draws spans of one light: without highlight, by the half vector, by the mirrored one. */
typedef struct glint_sun_spans {
    glint_draw_span *matt, *half, *mirror;
    glint_draw_span *small; /* of small triangles, by the half vector */
} glint_sun_spans;

/** The directional lights on a material. */
typedef struct glint_suns {
    uint32_t count;
    uint32_t keeps;      /* all bits, or 0 where the only light's ramp holds ambient light */
    uint32_t first;      /* the word that a sum of lights begins with */
    uint32_t dark;       /* the word of ambient light, */
    uint32_t half;       /* of which this is half a level, or 0 */
    uint32_t shift;      /* sin^2, Q30, 2^-shift is an entry of gloss */
    uint32_t end;        /* sin^2, Q30, where highlights end; 0 where none is visible */
    uint32_t far;        /* sin^2, Q16, that is outside at corners which turn by nothing, */
    uint32_t far_turned; /* and how much more it is for a third of a turn squared, Q10 */
    uint32_t bend;       /* largest square of a turn of H in a triangle whose highlight scalars give, 1 = 2^28; */
    int32_t small_bend;  /* what |H|^2, 1 = 2^28, may lack of 1 between corners that bend so far */
    int32_t gate;        /* N'.L up to this is not lit */
    uint32_t terms;      /* how many of these a vertex keeps */
    uint8_t is_local, is_mirror, takes_most, is_rounded;
    uint8_t is_fine;              /* no packed words serve: all triangles are lit by lists, */
    uint8_t bits;                 /* of channels of so many bits */
    uint8_t is_plain;             /* lights add to what there is, and their tables are there */
    uint8_t has_own;              /* words serve surfaces with colours of their own, too */
    const glint_sun_spans *spans; /* of an only light whose ramp holds all light, or null */
    glint_draw_span *small;       /* of small triangles */
    int32_t ray_limit;            /* from the centre of the screen, sixteenths */
    int32_t ray_z;                /* of the way to the eye */
    glint_drawn_sun suns[1];
} glint_suns;

/** Returns the bytes of so many lights on a material. */
#define GLINT_SUNS_SIZE(count) GLINT_ALIGNED(offsetof(glint_suns, suns) + (count) * sizeof(glint_drawn_sun))

/**
 * A quadratic on the screen, modulo 2^32: value + x column + y row + xx column^2 + xy column row + yy row^2.
 */
typedef struct glint_quadratic {
    uint32_t value, x, y, xx, xy, yy;
} glint_quadratic;

/** A plane on the screen, modulo 2^32: value + x column + y row. */
typedef struct glint_sun_plane {
    uint32_t value, x, y;
} glint_sun_plane;

/** What of a light a triangle has. */
typedef struct glint_lit_sun {
    const glint_drawn_sun *sun;
    const struct glint_drawn_lamp *lamp; /* the same: sun_fine.c */
    uint8_t is_plain;                    /* add_sun */
    uint8_t gloss;                       /* its highlight may be visible, and `half` is set */
    glint_sun_plane light;               /* N'.L */
    glint_quadratic half;                /* N'.H, or N'.V of Phong */
    glint_quadratic along;               /* (1 + L.V) / 2, of Phong */
} glint_lit_sun;

/** A triangle that is lit by suns, from the pixel walk->slopes.column, row on. */
typedef struct glint_sun_triangle {
    const glint_suns *suns;
    const uint32_t *ramp, *gloss;                          /* of an only light, */
    uint32_t shift, dark;                                  /* of suns, */
    uint32_t z_dx;                                         /* of the walk, */
    uintptr_t from_depth;                                  /* from depth to pixels, */
    uint32_t light_dx, square_bend, half_bend, along_bend; /* and of what is below, for spans of one light */
    const glint_vertex *corners[3];
    const glint_sun_term *terms[3];
    int32_t weight[3];             /* of a small triangle: 1/w at corners, 15 bits, below 0 of a back */
    int32_t n[3][3], d1[3], d2[3]; /* N' at corners, and differences from the first one */
    const int16_t *own_at[3];      /* the surface's own colours at corners, 1 = GLINT_COLOUR_ONE; */
    glint_sun_plane own[3];        /* and between, 1 = 2^29 */
    uint32_t least;                /* the least N'.N' there, 1 = 2^28 */
    uint32_t turn;                 /* largest square of a difference of two corners */
    unsigned zeros;                /* leading zeros of its slopes */
    glint_quadratic normal;        /* N'.N' */
    uint32_t count;
    glint_lit_sun lit[GLINT_LIGHTS_MAX];
} glint_sun_triangle;

/** Returns a word of a light's tables, however it is found. */
uint32_t glint_ramp_word(const glint_shading *shading, const glint_drawn_sun *sun, uint32_t index);
uint32_t glint_gloss_word(const glint_shading *shading, const glint_drawn_sun *sun, uint32_t index);

/** The largest x or y of the way to the eye. */
#define GLINT_MOST_RAY 37000

/** The least N'.N' of a triangle's fragments: what the table of roots has. 1 = 2^28 */
#define GLINT_LEAST_NORMAL (1u << 25)

/** Finds what the corners of a triangle keep. */
void glint_light_sun_vertices(const glint_frame *frame, glint_draw *draw, const glint_transform *transform, uint32_t i);

/** Returns sin^2 of an angle from a highlight, Q30, of Phong of half of it, by vectors, given N, 1 = 2^15. */
uint32_t glint_find_sine(const glint_row_walk *walk, const glint_drawn_sun *sun, int32_t row, int32_t column,
                         const int32_t n[3]);

/** Sets N' at corners, and N'.N'. @return 0 where normals turn too far, or 1/w changes too much */
int glint_begin_sun_normals(const glint_row_walk *walk, glint_sun_triangle *t);

/** Sets all lights that a corner faces. @return 0 where the triangle does not fit */
int glint_begin_suns(const glint_row_walk *walk, glint_sun_triangle *t);

/** Finds the word of a triangle whose corners have one normal. @return 0 where it may have a highlight */
int glint_find_one_word(const glint_row_walk *walk, uint32_t *word);

/** Draws a span: lists its pixels, each light goes over the list, and all are stored. */
glint_draw_span glint_draw_sun_list;

/** The same of a surface with its own colours, which multiply ambient and diffuse light. */
glint_draw_span glint_draw_own_list;

/** Sets how a surface's own colours change over a triangle. */
void glint_begin_own(glint_sun_triangle *t, const glint_slopes *slopes);

/** Multiplies a word by a surface's own colour, 1 = 2^15, and adds half a level where a format asks for it. */
uint32_t glint_multiply_word(const glint_suns *suns, uint32_t word, int32_t red, int32_t green, int32_t blue);

/** Adds a light to a pixel's colour, given N'.L and its entry of gloss. */
void glint_add_sun(const glint_row_walk *walk, const glint_drawn_sun *sun, glint_spread *p, int32_t light,
                   uint32_t entry);

/** Takes the larger of each channel and ambient light. */
void glint_take_larger(uint32_t dark, glint_spread *p, const glint_spread *end);

/** Begins with a small triangle, and draws spans of it. */
void glint_begin_small_suns(const glint_row_walk *walk, glint_sun_triangle *t);
glint_draw_span glint_draw_small_suns;

/** The same of one light with a highlight around H, stored in 16 bits a pixel. */
glint_draw_span glint_draw_small_rgb565, glint_draw_small_rgb565_be;

/** Begins with a triangle that fits, whose fragments are to be listed. @return what draws its spans, or null where it
 * does not fit for that */
glint_draw_span *glint_begin_fine_suns(glint_row_walk *walk);

/** Finds the words of ambient light, and where highlights end. */
void glint_ramps_prepare(glint_suns *suns, const glint_shading *shading);

/** Makes a light's tables, in so many bytes, unless they are there. */
void glint_ramps_make(const glint_shading *shading, glint_drawn_sun *sun, uint32_t *at, const uint32_t *before);

/** Returns the bytes of a light's tables. */
static inline size_t glint_ramps_size(const glint_drawn_sun *sun) {
    return (GLINT_RAMP_ENTRIES + 3 + (sun->shines ? GLINT_GLOSS_ENTRIES : 0u)) * sizeof(uint32_t);
}

/** Returns a sum of two words, each channel clamped at 1, without guard bits. */
static inline uint32_t glint_clamp_word(uint32_t word) {
    const uint32_t over = word & GLINT_SPREAD_GUARD;
    return over ? (word | (over - (over >> 9))) & ~GLINT_SPREAD_GUARD : word;
}

/** Returns 2^14 / sqrt(x 2^-32), rounded, x from 2^28 up; of each 2^22 the middle. */
static inline uint32_t glint_over_normal(uint32_t square) {
    return *(const uint16_t *)(const void *)((const uint8_t *)glint_root_table + (2 * (int32_t)(square >> 22) - 128));
}

/** Returns the entry of gloss of a pixel, given N'.N' sin^2, 1 = 2^32. */
static inline uint32_t glint_entry_of_sine(const glint_suns *suns, uint32_t sine, uint32_t over) {
    return sine >= GLINT_SINE_WRAPPED ? 0 : ((sine >> 16) * over >> 14) * over >> suns->shift;
}

#endif
