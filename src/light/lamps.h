/* SPDX-License-Identifier: MIT */
/**
 * @file lamps.h
 * Light at each fragment, in numbers of 16 bits and products of 32. Light does not care how long vectors are, so that
 * all of them are linear on the screen or nearly so: N/w, the way to the eye V, and the place P = -V w.
 *
 * Fragments that pass the depth test are listed; each light goes over the list with its numbers at hand.
 */
#ifndef GLINT_LAMPS_H
#define GLINT_LAMPS_H

#include "../pixel/pixel.h"
#include "../raster/triangle.h"
#include "shading.h"

/** Fragments that are lit together: fewer take less stack, and change no bit. */
#if GLINT_SMALL
#define GLINT_LIST_MAX 2
#else
#define GLINT_LIST_MAX 12
#endif

/** A fragment that is to be lit. */
typedef struct glint_lit_fragment {
    glint_list_pixel out; /* colours are Q27, in levels */
    uint32_t at;          /* its row in the tile 2^16, and its column */
    int32_t inverse_w;    /* 1/w, Q31, with glint_lamp_list's room */
    uint32_t square;      /* N'.N' of suns */
    uint8_t is_rough;     /* light changes so much around it that cells do not see how */
    uint8_t unseen;       /* lights that its surface faces away from; where cells look, as is_rough */
} glint_lit_fragment;

/** A view holds the vectors of a fragment while it is lit; they have any length. */
typedef struct glint_lit_view {
    glint_lit_fragment *at;
    int32_t n[3], over_n; /* N, 2^14 to 2^15 long, and 2^30 over that */
    int32_t v[3], over_v; /* V, likewise */
    int32_t facing;       /* N.V, Q15 */
    int32_t e[3];         /* from its place to the eye, 31 bits, in the unit of glint_lamps */
    int32_t w;            /* 2^31 over 1/w of 16 bits */
} glint_lit_view;

/** What arrives of a light at a fragment that faces it. */
typedef struct glint_arrival {
    int32_t cosine;    /* N.L, Q15 */
    int32_t along;     /* L.V, Q15, where the light shines */
    uint32_t strength; /* Q15 */
} glint_arrival;

/** Adds what lights add to the colours of fragments. */
typedef void glint_reflect(const glint_row_walk *walk, glint_lit_fragment *f, const glint_lit_fragment *end);

/** Fragments on their way to pixels. */
typedef struct glint_lamp_list {
    uint32_t count;
    uint32_t room;          /* 1/w of a far triangle has so many bits more, in walk->w; else 0 */
    uint32_t has_w;         /* walk->w is set */
    uint32_t up;            /* of a triangle's corners: their largest 1/w is 2^(30 - up) to 2^(31 - up) */
    glint_plane surface[3]; /* the surface's own colour over w 2^up */
    glint_reflect *light;   /* finds the colours of listed fragments */
    uint32_t top, bottom;   /* rows of spans that are kept, for cells */
    glint_span spans[GLINT_TILE_MAX];
    glint_lit_fragment fragment[GLINT_LIST_MAX];
} glint_lamp_list;

/** A light, as a draw has it in a tile. */
typedef struct glint_drawn_lamp {
    const glint_prepared_light *source;
    const struct glint_drawn_lamp *next; /* of those that the triangle may face */
    int32_t at[3];       /* towards it, 1 = 2^15; or its place, below 2^15, to which e 2^-down is added */
    uint32_t near;       /* the square of a way that is too short for its bits */
    uint32_t usual;      /* the same; of a light with a cone, or that does not weaken as most do, no less than all */
    uint32_t rough;      /* the square of a way that few pixels are as long as */
    uint32_t cone_rough; /* the same, or of ways along which few pixels are as wide as the cone */
    int32_t diffuse[3], specular[3]; /* Q12, in levels */
    int32_t cone_outer, cone_width;  /* of a cone: the cosine of its outer angle, and what that of the inner one is */
    uint32_t over_width;             /* more, Q16; and 2^30 over that */
    uint16_t linear, quadratic;      /* the source's, or 0 where it has no place */
    int8_t linear_shift, quadratic_shift; /* beyond those of the source */
    uint8_t down, fine_down;              /* place 2^-fine_down is `at` with 15 bits more */
    uint8_t shines, weakens, has_cone, has_place;
} glint_drawn_lamp;

/** The lights of a draw in a tile; they stand in the workspace. */
typedef struct glint_lamps {
    const glint_shading *shading;
    const struct glint_places *placed; /* where a light has a place, or null */
    int32_t gate;                      /* N.L up to this is not lit, */
    int32_t near_gate;                 /* N.D up to this is not lit, */
    int32_t far_gate;                  /* and from there to this by finer numbers */
    glint_row_walk *walk;              /* the triangle's */
    int32_t x, y, z, step;             /* the way to the eye of the tile's first pixel, Q12; from pixel to pixel */
    int32_t base[3];                   /* ambient light, Q27 in levels; with half a level where nothing follows */
    int32_t first[3];                  /* what fragments begin with */
    int32_t half[3];                   /* half a level, Q27 */
    int32_t unit;                      /* 1/w 2^-unit has 16 bits: what places are in */
    uint32_t least_w, up;   /* such a fragment's 1/w is from least_w up, and has `up` leading zeros; 0: look */
    uint32_t near, nearest; /* as in glint_drawn_lamp, of a light that is not far */
    int32_t least_whole;    /* 1 + L.V, Q15, below which L + V is too short for cosines of 15 bits, */
    int32_t usual_whole;    /* and below which a highlight is not found as most are */
    uint32_t count;
    const glint_drawn_lamp *along, *places; /* those that a triangle may face: directional ones, and those with a
                     place, or all in a library built for size */
    const uint16_t *power;                  /* values of the power table, by 2^(power_up - 16) of 1 - cos^2, Q15 */
    uint32_t power_up;
    uint32_t cut;        /* twice the least cos^2 of a highlight, Q15 */
    uint32_t least_view; /* the square of V below which it is not found as most are */
    uint8_t needs_w, has_gloss, is_local, has_colours, takes_most;
    uint8_t is_rare;  /* highlights are narrow, or their exponent is below 2 */
    uint8_t is_mixed; /* colours are not yet what is stored */
    uint8_t headroom; /* colours are 2^-headroom of what they are */
    glint_drawn_lamp lamps[GLINT_LIGHTS_MAX];
} glint_lamps;

/** Finds what arrives of a light at a fragment. @return 0 for nothing */
typedef int glint_arrive(const glint_lamps *lamps, const glint_drawn_lamp *lamp, glint_lit_view *s, glint_arrival *to);
#if GLINT_SMALL
glint_arrive glint_arrive_along GLINT_IF_LINKED, glint_arrive_from_place GLINT_IF_LINKED;
#else /* they are part of the models' loops */
#define glint_arrive_along 0
#define glint_arrive_from_place 0
#endif

/** Adds what lights of each model add. */
glint_reflect glint_reflect_matt GLINT_IF_LINKED, glint_reflect_half GLINT_IF_LINKED,
    glint_reflect_mirror GLINT_IF_LINKED;

/** Returns the value of a plane that begins with the tile's first pixel; modulo 2^32. */
static inline int32_t glint_lamp_plane(const glint_plane *p, int32_t row, int32_t column) {
    return glint_add_wrap(p->start,
                          glint_add_wrap(glint_multiply_wrap(p->dx, column), glint_multiply_wrap(p->dy, row)));
}

/** The row and the column of a fragment in its tile. */
static inline int32_t glint_fragment_row(const glint_lit_fragment *f) {
    return (int32_t)(f->at >> 16);
}

static inline int32_t glint_fragment_column(const glint_lit_fragment *f) {
    return (int32_t)(f->at & 0xffff);
}

/** Finds the way from a fragment to the eye, V in Q12, with all its bits. */
static inline void glint_find_fine_ray(const glint_lamps *lamps, const glint_lit_fragment *f, int32_t ray[3]) {
    const int32_t half = 1 << 11;
    ray[0] = lamps->x - half - lamps->step * glint_fragment_column(f);
    ray[1] = lamps->y - half + lamps->step * glint_fragment_row(f);
    ray[2] = lamps->z - half;
}

/** Multiplies a channel by a plane over w times that: by 15 bits. The plane has `down` bits more than 15, or `up` less.
 */
static inline int32_t glint_multiply_by_plane(const glint_plane *plane, int32_t row, int32_t column, uint32_t down,
                                              uint32_t up, int32_t w, int32_t channel) {
    int32_t of_15 = glint_shift_right(glint_lamp_plane(plane, row, column), down);
    if (GLINT_RARELY(up))
        of_15 = glint_shift_left(glint_most(glint_least(of_15, 1 << 15 >> up), 0), up);
    if (GLINT_RARELY((uint32_t)of_15 > 1u << 15))
        of_15 = of_15 < 0 ? 0 : 1 << 15;
    const uint32_t own = glint_saturate(of_15 * w, 15, 14) + 1;
    return (int32_t)(((uint32_t)channel >> 13) * own >> 2);
}

/** Multiplies a fragment's colour by its own; its 1/w has so many leading zeros, and its w is known. */
static inline void glint_multiply_by_own(const glint_lamp_list *list, const glint_lit_fragment *f, int32_t w,
                                         uint32_t zeros, int32_t colour[3]) {
    const int32_t row = glint_fragment_row(f), column = glint_fragment_column(f), half_w = glint_shift_right(w, 1);
    const int32_t more = 16 - (int32_t)(zeros + list->room) + (int32_t)list->up;
    const uint32_t down = (uint32_t)glint_least(glint_most(more, 0), 31),
                   up = (uint32_t)glint_least(glint_most(-more, 0), 15);
    colour[0] = glint_multiply_by_plane(&list->surface[0], row, column, down, up, half_w, colour[0]);
    colour[1] = glint_multiply_by_plane(&list->surface[1], row, column, down, up, half_w, colour[1]);
    colour[2] = glint_multiply_by_plane(&list->surface[2], row, column, down, up, half_w, colour[2]);
}

/** Exponents up to which vectors of 15 bits serve a narrow highlight: one of 2^10 changes by 20 a radian. */
#define GLINT_CHORD_EXPONENT (1024 * GLINT_ONE)

/** Returns 1 - cos^2 between N and L + V, Q30, of unit vectors, 1 = 2^15. */
uint32_t glint_sine_by_chord(const int32_t n[3], const int32_t v[3], const int32_t l[3]);

/** Sets walk->w: 1/w times 2^(up - 1), with the digits that depth lacks. */
void glint_set_fine_w(glint_row_walk *walk);

/** Brings the lights of a draw to a unit of places. */
void glint_set_lamps_unit(const glint_row_walk *walk, int32_t unit);

/** What lamps do with lights that have a place. */
typedef struct glint_places {
    /** Brings the lights of a draw to lamps->unit. */
    void (*bring_to_unit)(glint_lamps *lamps);
    /** Finds the ways from a triangle's corners to the eye. @return the leading zeros of 1/w there, or below 0 */
    int32_t (*find_corner_ways)(const glint_row_walk *walk, int32_t e[3][3]);
    /** Finds the way from a fragment to a light, with 15 bits more than glint_drawn_lamp's `at`: 31 bits. */
    void (*find_fine_way)(const glint_lamps *lamps, const glint_drawn_lamp *lamp, const glint_lit_view *s,
                          int32_t way[3]);
} glint_places;
extern const glint_places glint_lamp_places GLINT_IF_LINKED;

/** Lengthens V of a wide field of view. @return the square of its length */
uint32_t glint_lengthen_view(glint_lit_view *s, uint32_t square);

/** Finds w of a fragment that lies in another octave of 1/w, or V and w where rays are parallel; lights are brought to
 * its unit. */
void glint_find_other_w(const glint_row_walk *walk, glint_lit_view *s);

/** Brings a fragment's colour to what is stored; its 1/w has so many leading zeros, and its w is known. */
void glint_mix_own_colour(const glint_row_walk *walk, glint_lit_fragment *f, int32_t w, uint32_t zeros,
                          const int32_t gloss[3]);

/** Finds the colours of fragments, in levels, half a level included. */
void glint_lamps_light(const glint_row_walk *walk, glint_lit_fragment *f, const glint_lit_fragment *end);

/** Draws a span: lists the fragments that pass the depth test. */
void glint_list_span(glint_row_walk *walk, int32_t row, int32_t left, int32_t right);

/** Lights the fragments of the list, and stores them. */
void glint_light_listed(const glint_row_walk *walk);

/** Pixels of a triangle from which on its light is found at nodes of cells. */
#define GLINT_CELLS_LEAST 200

/** Keeps a span for glint_draw_cells, which draws all that are kept. */
void glint_keep_span(glint_row_walk *walk, int32_t row, int32_t left, int32_t right);
void glint_draw_cells(glint_row_walk *walk);

/** Sets a triangle's lights, and the planes of its surface's own colour. */
void glint_begin_lamp_list(glint_row_walk *walk);

/** Draws a triangle whose fragments are lit. */
void glint_draw_lamps(glint_row_walk *walk);

/** Draws it by way of walk->list, whatever that holds. */
void glint_draw_by_list(glint_row_walk *walk);

#endif
