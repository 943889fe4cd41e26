/* SPDX-License-Identifier: MIT */
/**
 * @file lamps.h
 * Light at each fragment from lights of any type ("lamps"), in numbers of 16 bits and products of 32. Vectors may have
 * any length, as lengths are divided out last. So all of them are linear on the screen or nearly so: the normal N/w,
 * the vector V to the eye, and the place P = -V w.
 *
 * Fragments that pass the depth test are listed, and a full list is lit at once.
 */
#ifndef GLINT_LAMPS_H
#define GLINT_LAMPS_H

#include "../pixel/pixel.h"
#include "../raster/triangle.h"
#include "shading.h"

/** Number of fragments, or of packed words, that are lit together: a smaller number uses less memory, and changes no
 * bit. */
#if GLINT_SMALL
#define GLINT_LIST_MAX 2
#define GLINT_WORDS_MAX 8
#else
#define GLINT_LIST_MAX 12
#define GLINT_WORDS_MAX 16
#endif

/** A fragment to be lit. */
typedef struct glint_lit_fragment {
    glint_list_pixel out; /* the colour is in levels, Q27 */
    uint32_t position;    /* row in the tile times 2^16, plus column */
    int32_t inverse_w;    /* 1/w, Q31, times 2^room of glint_lamp_list */
    uint32_t square;      /* N'.N', where suns light it: suns.h */
    uint8_t is_rough;     /* light changes too much around it to be interpolated; set for cells.c alone */
    uint8_t unseen;       /* number of lights that its surface faces away from; for cells.c alone */
} glint_lit_fragment;

/** The vectors of a fragment while it is lit; they have any length. */
typedef struct glint_lit_view {
    glint_lit_fragment *fragment;
    int32_t n[3], over_n; /* N, 2^14 to 2^15 long, and 2^30 over its length */
    int32_t v[3], over_v; /* V, 2^14 to 2^15 long, and 2^30 over its length */
    int32_t facing;       /* N.V of unit vectors, Q15 */
    int32_t e[3];         /* from the fragment's place to the eye, 31 bits, in the unit of glint_lamps */
    int32_t w;            /* 2^31 over 1/w, which has 16 bits */
} glint_lit_view;

/** The light that arrives at a fragment, from one light; L and V are unit vectors. */
typedef struct glint_arrival {
    int32_t cosine;         /* N.L, Q15 */
    int32_t light_dot_view; /* L.V, Q15; set where materials have highlights */
    uint32_t strength;      /* attenuation by distance and cone, Q15 */
} glint_arrival;

/** Finds the colours of fragments from `f` to before `end`: ambient light and all lights. */
typedef void glint_reflect(const glint_row_walk *walk, glint_lit_fragment *f, const glint_lit_fragment *end);

/** The fragments of a triangle that wait to be lit and stored. */
typedef struct glint_lamp_list {
    uint32_t count;
    uint32_t room;          /* if not 0, the triangle is far, and walk->w has 1/w with so many bits more */
    uint16_t has_w;         /* walk->w is set */
    uint16_t lights_nodes;  /* fragments are nodes of cells, which keep highlights apart from light: cells.c */
    uint32_t up;            /* the largest 1/w of the triangle's corners is 2^(30 - up) to 2^(31 - up) */
    glint_plane surface[3]; /* the surface's own colour over w, times 2^up */
    glint_reflect *light;   /* finds the colours of listed fragments */
    uint32_t top, bottom;   /* the first row that has a cached span, and the row after the last one: cells.c */
    glint_span spans[GLINT_TILE_MAX];
    union {
        glint_lit_fragment fragment[GLINT_LIST_MAX];
        glint_spread words[GLINT_WORDS_MAX]; /* of suns: sun_lists.c */
    } pixels;
} glint_lamp_list;

/** A light on the material of a draw, in one tile. */
typedef struct glint_drawn_lamp {
    const glint_prepared_light *source;
    const struct glint_drawn_lamp *next; /* the next light of a list of those that the triangle may face */
    int32_t place[3];    /* below 2^15; e 2^-down plus it is the way to it. Directional: unit vector to it, 1 = 2^15 */
    uint32_t near;       /* 15 bits are too few for a way whose square is below this */
    uint32_t usual;      /* if its square is below this, a way is near, or the light has a cone, or it weakens oddly */
    uint32_t rough;      /* a way whose square is below this is a few pixels long */
    uint32_t cone_rough; /* if its square is below this, it may be, or a few pixels may be as wide as the cone */
    int32_t diffuse[3], specular[3]; /* weights in levels, Q12 */
    int32_t cone_outer, cone_width;  /* cosine of a cone's outer angle, and that of the inner angle less this; Q16 */
    uint32_t over_width;             /* 2^30 / cone_width */
    uint16_t linear, quadratic;      /* as in `source`; 0 without a place */
    int8_t linear_shift, quadratic_shift; /* those of `source`, in the unit of glint_lamps */
    uint8_t down, fine_down;              /* source->lamp.place 2^-fine_down is `place` with 15 bits more */
    uint8_t shines;                       /* its highlight is visible */
    uint8_t weakens;                      /* 0: it has no attenuation; 2: its shifts are below 0; else 1 */
    uint8_t has_cone, has_place;
} glint_drawn_lamp;

/** The lights of a draw in a tile; the workspace holds them. */
typedef struct glint_lamps {
    const glint_shading *shading;
    const struct glint_places *placed; /* functions of lights that have a place; null if no light has one */
    int32_t gate;                      /* a fragment is lit if N.L exceeds this, Q30; INT32_MIN: always */
    int32_t near_gate;                 /* a fragment is not lit if N.D is at most this; */
    int32_t far_gate;                  /* if it is between both, N.D is found with more bits */
    glint_row_walk *walk;              /* of the triangle */
    int32_t x, y, z, step;             /* V of the tile's first pixel, Q12, and its change from pixel to pixel */
    int32_t base[3];                   /* ambient light in levels, Q27; half a level included unless is_mixed */
    int32_t first[3];                  /* the sum of lights begins with this */
    int32_t half[3];                   /* half a level, Q27 */
    int32_t unit;                      /* the unit of places: 1/w 2^-unit has 16 bits */
    uint32_t least_w, up;      /* 1/w from least_w to 2 least_w has `up` leading zeros and fits `unit`. 0: none fits */
    uint32_t near, nearest;    /* `near` of a light that is not far; below `nearest` w lacks bits, too */
    int32_t least_half_square; /* if 1 + L.V = |L + V|^2 / 2, Q15, is below this, 15 bits are too few, */
    int32_t usual_half_square; /* and if it is below this, find_odd_power finds the highlight */
    uint32_t count;
    const glint_drawn_lamp *directional, *positional; /* lists of lights that the triangle may face; a library built
                                                         for size has all in `positional` */
    const uint16_t *power; /* values of the power table: 2^(power_up - 16) (1 - cos^2), Q15, is the index */
    uint32_t power_up;
    uint32_t cut;        /* twice the least cos^2 of a highlight, Q15 */
    uint32_t least_view; /* V is lengthened if its square is below this */
    uint8_t needs_w;     /* a light has a place, or the surface has colours */
    uint8_t has_gloss;   /* a light has a visible highlight */
    uint8_t is_local;    /* V differs from fragment to fragment: the viewer is local */
    uint8_t has_colours; /* the surface has colours of its own */
    uint8_t takes_most;  /* the larger of ambient light and all other is taken, not their sum */
    uint8_t is_rare;     /* highlights are narrow, or their exponent is below 2 */
    uint8_t is_mixed;    /* glint_mix_own_colour finishes colours */
    uint8_t headroom;    /* colours are scaled by 2^-headroom */
    glint_drawn_lamp lamps[GLINT_LIGHTS_MAX];
} glint_lamps;

/** Finds direction and strength of a light at a fragment. @return 0 if nothing arrives */
typedef int glint_arrive(const glint_lamps *lamps, const glint_drawn_lamp *lamp, glint_lit_view *view,
                         glint_arrival *to);
#if GLINT_SMALL
glint_arrive glint_arrive_from_direction GLINT_IF_LINKED, glint_arrive_from_place GLINT_IF_LINKED;
#else /* the loops of the models inline both */
#define glint_arrive_from_direction 0
#define glint_arrive_from_place 0
#endif

/** Each of these lights fragments of one kind of model: without highlights, by the half vector, by the mirrored L. */
glint_reflect glint_reflect_matt GLINT_IF_LINKED, glint_reflect_half GLINT_IF_LINKED,
    glint_reflect_mirror GLINT_IF_LINKED;

/** Returns the value of a plane at a pixel of the tile, modulo 2^32; plane->start is its value at the first pixel. */
static inline int32_t glint_lamp_plane(const glint_plane *plane, int32_t row, int32_t column) {
    return glint_add_wrap(plane->start,
                          glint_add_wrap(glint_multiply_wrap(plane->dx, column), glint_multiply_wrap(plane->dy, row)));
}

/** Returns the row of a fragment in its tile. */
static inline int32_t glint_fragment_row(const glint_lit_fragment *f) {
    return (int32_t)(f->position >> 16);
}

/** Returns the column of a fragment in its tile. */
static inline int32_t glint_fragment_column(const glint_lit_fragment *f) {
    return (int32_t)(f->position & 0xffff);
}

/** Finds V, the vector from a fragment to the eye, in Q12 with all its bits. */
static inline void glint_find_fine_ray(const glint_lamps *lamps, const glint_lit_fragment *f, int32_t ray[3]) {
    const int32_t half = 1 << 11;
    ray[0] = lamps->x - half - lamps->step * glint_fragment_column(f);
    ray[1] = lamps->y - half + lamps->step * glint_fragment_row(f);
    ray[2] = lamps->z - half;
}

/** Multiplies a channel by the surface's own, 1 = 2^15, which is the value of a plane over w times w. The plane has
 * `down` bits more than 15, or `up` bits less. */
static inline int32_t glint_multiply_by_plane(const glint_plane *plane, int32_t row, int32_t column, uint32_t down,
                                              uint32_t up, int32_t w, int32_t channel) {
    int32_t own_over_w = glint_shift_right(glint_lamp_plane(plane, row, column), down); /* 15 bits */
    if (GLINT_RARELY(up))
        own_over_w = glint_shift_left(glint_most(glint_least(own_over_w, 1 << 15 >> up), 0), up);
    if (GLINT_RARELY((uint32_t)own_over_w > 1u << 15))
        own_over_w = own_over_w < 0 ? 0 : 1 << 15;
    const uint32_t own = glint_saturate(own_over_w * w, 15, 14) + 1;
    return (int32_t)(((uint32_t)channel >> 13) * own >> 2);
}

/** Multiplies a fragment's colour by the surface's own there, given w of 16 bits and the leading zeros of 1/w. */
static inline void glint_multiply_by_own(const glint_lamp_list *list, const glint_lit_fragment *f, int32_t w,
                                         uint32_t zeros, int32_t colour[3]) {
    const int32_t row = glint_fragment_row(f), column = glint_fragment_column(f), half_w = glint_shift_right(w, 1);
    const int32_t surplus = 16 - (int32_t)(zeros + list->room) + (int32_t)list->up; /* bits beyond 15 */
    const uint32_t down = (uint32_t)glint_least(glint_most(surplus, 0), 31),
                   up = (uint32_t)glint_least(glint_most(-surplus, 0), 15);
    colour[0] = glint_multiply_by_plane(&list->surface[0], row, column, down, up, half_w, colour[0]);
    colour[1] = glint_multiply_by_plane(&list->surface[1], row, column, down, up, half_w, colour[1]);
    colour[2] = glint_multiply_by_plane(&list->surface[2], row, column, down, up, half_w, colour[2]);
}

/** Vectors of 15 bits serve narrow highlights up to this exponent: with exponent 2^10 a highlight changes by 20 a
 * radian. */
#define GLINT_CHORD_EXPONENT (1024 * GLINT_ONE)

/** Returns 1 - cos^2 of the angle between N and L + V, Q30, of unit vectors, 1 = 2^15; off by 2^-14.5 of an angle. */
uint32_t glint_sine_by_chord(const int32_t n[3], const int32_t v[3], const int32_t l[3]);

/** Sets walk->w, the plane of 1/w times 2^(list->up - 1): it has bits that depth lacks. */
void glint_set_fine_w(glint_row_walk *walk);

/** Changes lamps->unit, and brings the lights of the draw to it. */
void glint_set_lamps_unit(const glint_row_walk *walk, int32_t unit);

/** Functions that are linked where a light has a place. */
typedef struct glint_places {
    /** Brings the lights of a draw to lamps->unit. */
    void (*bring_to_unit)(glint_lamps *lamps);
    /** Finds the vectors from a triangle's corners to the eye.
     * @return the leading zeros of 1/w at the corners, or a number below 0 if no one unit of places fits them all */
    int32_t (*find_corner_ways)(const glint_row_walk *walk, int32_t e[3][3]);
    /** Finds the vector from a fragment to a light, 31 bits: 15 more than `place` of glint_drawn_lamp has. */
    void (*find_fine_way)(const glint_lamps *lamps, const glint_drawn_lamp *lamp, const glint_lit_view *view,
                          int32_t way[3]);
} glint_places;
extern const glint_places glint_lamp_places GLINT_IF_LINKED;

/** Scales V, which is short where the field of view is wide, by a power of two. @return the square of its length */
uint32_t glint_lengthen_view(glint_lit_view *view, uint32_t square);

/** Finds w of a fragment whose 1/w lies in another octave, or V and w where rays are parallel, and brings lights to the
 * unit of that octave. */
void glint_find_other_w(const glint_row_walk *walk, glint_lit_view *view);

/** Finishes a fragment's colour, given w of 16 bits, the leading zeros of 1/w, and the highlights that have been kept
 * apart: multiplies by the surface's own colour, adds highlights, takes the larger of ambient and other light, undoes
 * the headroom and adds half a level. */
void glint_mix_own_colour(const glint_row_walk *walk, glint_lit_fragment *f, int32_t w, uint32_t zeros,
                          const int32_t gloss[3]);

/** Finds the colours of fragments, in levels, Q27, half a level included. */
void glint_lamps_light(const glint_row_walk *walk, glint_lit_fragment *f, const glint_lit_fragment *end);

/** Draws a span: lists the fragments that pass the depth test, and lights the list when it is full. */
void glint_list_span(glint_row_walk *walk, int32_t row, int32_t left, int32_t right);

/** Lights the fragments of the list, and stores them. */
void glint_light_listed(const glint_row_walk *walk);

/** Light of triangles of this many pixels or more is interpolated between nodes of cells. */
#define GLINT_CELLS_LEAST 200

/** Caches a span for glint_draw_cells. */
void glint_keep_span(glint_row_walk *walk, int32_t row, int32_t left, int32_t right);

/** Draws all spans that are cached. */
void glint_draw_cells(glint_row_walk *walk);

/** Sets the lights of a triangle's draw, unless the last triangle had the same, and the planes of its own colour. */
void glint_begin_lamp_list(glint_row_walk *walk);

/** Draws a triangle whose fragments are lit. */
void glint_draw_lamps(glint_row_walk *walk);

#endif
