/* SPDX-License-Identifier: MIT */
/**
 * @file terms.h
 * Light as terms. A node is exact light at a point of a triangle; terms are polynomials through the nodes of a region,
 * a triangle or a cell of one; a row of colours is what terms make of pixels that follow each other.
 */
#ifndef GLINT_TERMS_H
#define GLINT_TERMS_H

#include "../geometry/draw.h"
#include "../light/shade.h"
#include "../pixel/format.h"
#include "../raster/polynomial.h"
#include "../raster/runs.h"

/* ---- Materials ---- */

/** Numbers of a light at a node: terms.h; and those of them that polynomials go through. */
#define GLINT_NUMBERS 6
#define GLINT_NUMBERS_DRAWN 5

/** Intervals of a power of the cosine from 1/2 to 1, and values of that: these, and the powers of 2^-i. */
#define GLINT_COSINE_HALF 64
#define GLINT_COSINE_VALUES (GLINT_COSINE_HALF + 1 + 31)

/** What a material makes of the frame's lights, for nodes and rows. Weights are Q12, in the format's levels. */
typedef struct glint_light_terms {
    int32_t ambient[3], half[3];               /* channels: of ambient light, and of half a level */
    uint16_t diffuse[GLINT_LIGHTS_MAX][3];     /* weights of diffuse light */
    uint16_t specular[GLINT_LIGHTS_MAX][3];    /* weights of specular light */
    int32_t share[GLINT_LIGHTS_MAX];           /* where all are of one chroma: a light's part of it, Q15 */
    int32_t chroma[3];                         /* its weight */
    int32_t gloss_share[GLINT_LIGHTS_MAX];     /* the same of specular light, which then is of one chroma too */
    glint_mix mix;                             /* of such light and specular light, where surfaces have no colours */
    uint32_t diffuse_levels[GLINT_LIGHTS_MAX]; /* what 1 makes at most, levels in Q8 */
    uint32_t specular_levels[GLINT_LIGHTS_MAX];
    uint32_t ambient_levels; /* of ambient light */
    uint32_t channels;       /* of a node's sum: 1 where all light is of one chroma of each kind, else 3 */
    unsigned sum_bits;       /* sums are below this power of two */
    uint32_t lobes;          /* bit i: light i has a highlight that is a term of its own */
    uint32_t placed, cones;  /* it has a position; and a cone */
    uint8_t at[GLINT_LIGHTS_MAX][GLINT_NUMBERS]; /* where a vertex keeps a light's numbers */
    uint32_t shown;                              /* how many lights do */
    uint32_t stride;                             /* numbers that a vertex keeps */
    uint32_t lobe_shift;                         /* a deviation, Q14, is kept times 2^this */
    int32_t lobe_cut, lobe_diagonal;             /* outside an octagon of this radius no highlight shows; as kept */
    uint32_t lobe_end;                           /* squared deviation, as kept, where the power table ends */
    uint32_t slope;                              /* of a highlight over its deviation, at most, Q8 */
    int32_t crest;                               /* the deviation, as kept, beyond which it falls */
    uint32_t spread;                             /* how many times as fast as light highlights turn, Q4; 0: unknown */
    uint8_t lobe_is_wide;                        /* small p: of a deviation there is the cosine alone, Q14 */
    uint8_t lobe_has_strip;                      /* p < 1: near the horizon polynomials do not fit */
    uint32_t limit, most;                        /* of the error of planes and of quadratics, levels in Q8; */
    uint32_t most_of_sums, most_of_one;          /* of that of light in quadratics' sums, and of one highlight */
    uint32_t pixel;                              /* 1/16 of one over the focal length, Q30 */
    uint16_t cosine[GLINT_COSINE_VALUES];        /* powers of the cosine, Q15, where lobes are wide */
} glint_light_terms;

/* ---- Nodes ---- */

/** Where glint_node_sum is to sum all lights that a point clearly faces. */
#define GLINT_ALL_LIT 0x100u

/** A light's numbers at a node, 15 bits and a sign. */
enum {
    GLINT_SIDE,     /* N.L times strength, Q14, but for the cone */
    GLINT_CONE,     /* how far within the cone, Q12: 0 at its outer edge, 1 at the inner */
    GLINT_STRENGTH, /* Q14, but for the cone */
    GLINT_LOBE_X,   /* deviation, Q14 times 2^lobe_shift */
    GLINT_LOBE_Y,
    GLINT_NEARNESS /* nearness.h */
};

/** Light at a point. */
typedef struct glint_node {
    int32_t sum[3];   /* of lights: 15 bits less sum_bits for 1 */
    int32_t shine[3]; /* of highlights, channels of the same */
    int16_t number[GLINT_LIGHTS_MAX][GLINT_NUMBERS];
    int32_t inverse_w;
    int16_t normal[3], surface[3]; /* the surface's colours, Q14 */
    uint32_t levels;               /* what all lights that it does not clearly face away from make: in Q4 */
    uint8_t lit, dark;             /* lights that it clearly faces, within their cones, and that it clearly does not */
    uint16_t outside;              /* lights whose cones it is clearly outside of, and from bit 8 on: by far */
    uint8_t far;                   /* lights whose deviation was cut off */
    uint8_t unfit;                 /* lights without a half vector here */
    uint8_t steep;                 /* lights whose cone was cut off */
    uint8_t left;                  /* lights without numbers here */
} glint_node;

/** Half a step of a polynomial whose high half is such a number: pixels' deviations are rounded to nearest. */
static inline uint32_t glint_half_of(uint32_t kind) {
    return kind == GLINT_LOBE_X || kind == GLINT_LOBE_Y ? 1u << 15 : 0;
}

/** Finds light at some points, but for its sum, each point for a node. Deviations are found of `lobes` among `lights`.
 * Unless it `tells` of regions, a node is without which lights it faces, how near they are, and what they make. */
void glint_nodes_light(const glint_frame *frame, const glint_shading *shading, glint_fragments *at, uint32_t lights,
                       uint32_t lobes, int tells, glint_node *const nodes[]);

/** Sums light at a node, of lights that are `held`. */
void glint_node_sum(const glint_light_terms *light, uint32_t held, glint_node *node);

/** Sums highlights at a node, of lights that are `summed`. */
void glint_node_shine(const glint_shading *shading, uint32_t summed, glint_node *node);

/** Tells a node of lights that are away from all of its region, for which it has not been lit. */
static inline void glint_node_leave(glint_node *node, uint32_t away) {
    node->left = (uint8_t)away;
    node->outside |= (uint16_t)(away | away << 8);
}

/** Ray towards the eye from a point of the screen, 27.5: middles lie between sixteenths. */
void glint_find_ray(const glint_frame *frame, int32_t x, int32_t y, int32_t ray[3]);

/* ---- Bound: which polynomials are close enough ---- */

/** What is known of the light on a region; angles Q12, lights by bits. */
typedef struct glint_region {
    uint32_t turn;                       /* of the normals, from corner to corner at most */
    uint32_t reach;                      /* how far the corners lie apart, over their depth; 4 stands for all beyond */
    uint32_t slant;                      /* the change of 1/w, times 1.85 */
    uint32_t colour;                     /* by how much the surface's colours differ, of 1 */
    uint32_t levels;                     /* what light makes, Q4 */
    uint32_t lit, dark, outside;         /* as nodes have it, at all of them */
    uint32_t far, unfit, steep, left;    /* at some */
    uint16_t nearness[GLINT_LIGHTS_MAX]; /* of each light, of all nodes */
    uint16_t strength[GLINT_LIGHTS_MAX]; /* its most at nodes, Q14, */
    int16_t side_least[GLINT_LIGHTS_MAX],
        side_most[GLINT_LIGHTS_MAX]; /* and N.L times that, of those with a position */
    /* what is found */
    int has_edge;                        /* may a highlight end at once within the region? */
    int folds;                           /* may sums be multiplied by the surface's colours at nodes? */
    uint32_t held, sides, cones, lobes;  /* lights in sums, with terms of their own, of these with cones; highlights */
    uint32_t summed;                     /* highlights in sums; `lobes` has the others */
    uint32_t shine;                      /* what quadratics make of these may be off by, levels in Q8 */
    uint16_t near_of[GLINT_LIGHTS_MAX];  /* how far corners lie apart, over the distance to a light, */
    uint32_t near;                       /* and at most to one that shines */
    uint16_t place_of[GLINT_LIGHTS_MAX]; /* what a light turns by as a place in space does, */
    uint16_t axis_of[GLINT_LIGHTS_MAX];  /* what a highlight's axis turns by, */
    uint32_t axis;                       /* and at most */
    uint32_t slope;                      /* of highlights that show, over their deviations, at most, Q8 */
    uint32_t place, of_colour;           /* what sums turn by but for the normals, and what colours make over w */
    uint32_t error, cone_error;          /* of quadratics, and of it what cones make, levels in Q8 */
    int32_t margin;                      /* of a light's N.L, Q14 */
} glint_region;

/** sqrt(square), Q24 to Q12, to 2^-12 of it and a step. */
uint32_t glint_root_above(uint32_t square);

/** |a - b|^2 of unit vectors, Q26, below 2^29. */
static inline int32_t glint_square_apart(const int16_t a[3], const int16_t b[3]) {
    const int32_t x = glint_shift_right(a[0] - b[0], 2), y = glint_shift_right(a[1] - b[1], 2),
                  z = glint_shift_right(a[2] - b[2], 2);
    return x * x + y * y + z * z;
}

/** The hypotenuse of sides below 2^26, by chords: longer by at most 2.8 %. */
static inline uint32_t glint_hypotenuse(uint32_t a, uint32_t b) {
    const uint32_t most = a > b ? a : b, least = a > b ? b : a;
    const uint32_t flat = 64 * most + 13 * least, steep = 55 * most + 37 * least;
    return ((flat > steep ? flat : steep) >> 6) + 1;
}

/** A triangle's longest edge, 28.4, to 2^-12 of it and a step. */
uint32_t glint_find_longest(const glint_vertex *const corners[3]);

/** Sets `reach` and `slant` of a region so long, 28.4, with this range of 1/w. @param pixel of the terms */
void glint_region_measure(uint32_t pixel, uint32_t longest, const glint_w_range *w, glint_region *region);

/** Sets how near these lights are, from their nearness; others of all lights are far. @return those whose cones the
 * region is outside of */
uint32_t glint_region_place(uint32_t all, uint32_t lights, glint_region *region);

/** Sets what becomes of lights, from `lit` and `dark` on. @return those whose highlights may show */
uint32_t glint_region_sort(const glint_frame *frame, const glint_shading *shading, glint_region *region);

/** May polynomials fit at all? Then sets what error is found from. */
int glint_region_fits(const glint_shading *shading, int has_surface, glint_region *region);

/** Moves highlights that turn no faster than sums' light does into these. @return are there any? */
int glint_region_sum_lobes(const glint_shading *shading, int has_surface, glint_region *region);

/** Moves them back. */
static inline void glint_region_part_lobes(glint_region *region) {
    region->lobes |= region->summed;
    region->summed = 0;
}

/** How far planes may be off, levels in Q8. */
uint32_t glint_plane_error(const glint_shading *shading, int has_surface, const glint_region *region);

/** Sets how far quadratics may be off. @return 0 where none fit */
int glint_region_bound(const glint_frame *frame, const glint_shading *shading, glint_region *region);

/** How far those may be where numbers are times the normal's length, levels in Q8, once the others' error is known;
 * sets the margin for these. */
uint32_t glint_error_over_length(const glint_frame *frame, const glint_shading *shading, glint_region *region);

/** What is more where nodes between corners are found from these. */
uint32_t glint_error_between(const glint_shading *shading, const glint_region *region);

/** How far a light's deviations between a triangle's corners may lie beyond these, as kept: planes' error of
 * highlights. */
int32_t glint_lobe_bulge(const glint_shading *shading, const glint_region *region, uint32_t light);

/** Where highlights may show: within an octagon of these radii; of wide ones, where the cosine is not below one of
 * these numbers, and clearly above the other. */
typedef struct glint_lobe_bounds {
    uint8_t is_wide;
    int32_t bulge;              /* how far deviations between nodes may lie beyond those of nodes */
    int32_t straight, diagonal; /* of an octagon */
    int32_t below, edge;        /* of a cosine */
} glint_lobe_bounds;

glint_lobe_bounds glint_find_lobe_bounds(const glint_shading *shading, int32_t bulge);

/** Least and most of numbers. */
typedef struct glint_interval {
    int32_t least, most;
} glint_interval;

static inline void glint_interval_take(glint_interval *range, int32_t x) {
    range->least = glint_least(range->least, x);
    range->most = glint_most(range->most, x);
}

/** Where deviations of some nodes lie: along x and y, and along the diagonals. Of wide lobes x is all there is. */
typedef struct glint_lobe_range {
    glint_interval x, y, rising, falling;
} glint_lobe_range;

/** That of one node. */
static inline glint_lobe_range glint_lobe_range_of(int32_t x, int32_t y) {
    return (glint_lobe_range){{x, x}, {y, y}, {x + y, x + y}, {x - y, x - y}};
}

/** And of one more. */
static inline void glint_lobe_range_take(glint_lobe_range *range, int32_t x, int32_t y) {
    glint_interval_take(&range->x, x);
    glint_interval_take(&range->y, y);
    glint_interval_take(&range->rising, x + y);
    glint_interval_take(&range->falling, x - y);
}

/** Adds a light's highlight to a region if it may show between nodes where it lies so. */
void glint_region_add_lobe(const glint_shading *shading, const glint_lobe_bounds *bounds, uint32_t light,
                           const glint_lobe_range *at, glint_region *region);

/* ---- Terms ---- */

/** Most polynomials of a region: of sums, of |M|^2, of the surface's colours, and of lights. */
#define GLINT_POLYNOMIALS_MAX (7 + GLINT_NUMBERS_DRAWN * GLINT_LIGHTS_MAX)

/** A light with terms of its own: polynomials from number `first` on, of the numbers in `kinds`, bit by bit. */
typedef struct glint_apart {
    uint8_t light, kinds, first;
} glint_apart;

/** What a region's polynomials mean. */
typedef struct glint_terms {
    const glint_light_terms *light;
    const glint_power_table *power;
    uint8_t has_surface; /* what sums and sides make is to be multiplied by the surface's colours */
    uint8_t takes_largest, is_ungated;
    uint8_t is_over_length; /* 1: numbers are times |M|, M the normal over w; 2: lobes' twice */
    uint8_t is_channels;    /* sums are three channels that hold ambient light, and the surface's colours */
    uint8_t has_shine;      /* they hold highlights */
    uint8_t is_fused;       /* they are all there is, and the format's own loop draws them */
    uint8_t is_curved;
    uint8_t apart_count, shown;    /* lights with terms of their own; and all that there are, by bits */
    uint8_t sums, square, surface; /* how many sums there are, the first polynomials; and which others these are */
    uint8_t end;                   /* of the polynomials in use */
    int32_t margin; /* above 0: pixels are not drawn by these whose N.L, Q14, is this near 0 and that may be gated */
    glint_apart apart[GLINT_LIGHTS_MAX];
} glint_terms;

/** A region's polynomials, by number, from the anchor. */
typedef struct glint_polynomials {
    glint_quadratic of[GLINT_POLYNOMIALS_MAX];
} glint_polynomials;

/** Tells what a region's polynomials are to mean. */
void glint_terms_name(const glint_frame *frame, const glint_draw *draw, const glint_region *region, int over_length,
                      glint_terms *terms);

/**
 * Of a node's sum, where sums are channels, that of c, 15 bits less sum_bits: in levels, with ambient light and the
 * surface's colours where the terms' sums hold them, and highlights. Surfaces are Q14.
 */
static inline int32_t glint_sum_at(const glint_terms *terms, const int32_t sums[3], const int32_t shine[3], int c,
                                   const int16_t *surface) {
    const glint_light_terms *light = terms->light;
    int32_t sum = light->channels == 1 ? glint_shift_right(sums[0] * light->chroma[c] + (1 << 11), 12) : sums[c];
    if (surface) {
        sum += glint_shift_right(light->ambient[c], 12 + light->sum_bits);
        sum = glint_shift_right(sum * surface[c] + (1 << 13), 14);
    }
    return terms->has_shine ? sum + shine[c] : sum;
}

/** What is added to sum c of channels: half a level, and ambient light where sums do not hold it nor it is apart. */
static inline uint32_t glint_finish_of(const glint_terms *terms, int has_surface, int c) {
    const glint_light_terms *light = terms->light;
    return (uint32_t)(light->half[c] + (has_surface || terms->takes_largest ? 0 : light->ambient[c]));
}

/**
 * What a vertex keeps: its sum; the lights it faces and does not; those whose deviation is cut off or unknown; those
 * whose cones are; what light there is; the highlights of lights it faces; and lights' numbers.
 */
enum {
    GLINT_KEPT_FACING,
    GLINT_KEPT_FLAGS,
    GLINT_KEPT_STEEP,
    GLINT_KEPT_OUTSIDE,
    GLINT_KEPT_LEVELS,
    GLINT_KEPT_SHINE, /* three channels */
    GLINT_KEPT = GLINT_KEPT_SHINE + 3,
    GLINT_KEPT_MAX = 3 + GLINT_KEPT + GLINT_NUMBERS * GLINT_LIGHTS_MAX /* most numbers that it keeps */
};

/** Bytes that a vertex keeps of light in a material. @return 0 where terms do not fit it, or none are wanted */
size_t glint_terms_measure(const glint_frame *frame, const glint_shading *shading);

/** Finds what all materials make of the lights, behind their shadings. */
glint_status glint_terms_prepare(glint_frame *frame);

/** Most runs that are drawn at once: of rows as long as two of a tile, half of their pixels, and of each row one more.
 */
#define GLINT_BATCH_RUNS (GLINT_TILE_MAX + GLINT_TILE_MAX / 2)

/** Cosines below which wide highlights are steep where p < 1, Q14. */
#define GLINT_HORIZON (1 << 11)

/** Finds pixels of a run that are not to be drawn by terms. @return how many */
uint32_t glint_terms_find_edge(const glint_terms *terms, const glint_quadratic *polynomials, const glint_part *part,
                               const glint_run *run, uint8_t columns[GLINT_TILE_MAX]);

/** Draws such pixels of a triangle's runs one by one. */
void glint_draw_edges(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                      const glint_triangle *triangle, const glint_part *part, const glint_terms *terms,
                      const glint_quadratic *polynomials, const glint_run *runs, const glint_run *end);

/* ---- Triangles ---- */

/** Twice the area, 28.4 squared, below which polynomials take more than fragments: of 8 pixels, measured. */
#define GLINT_NODES_LEAST_AREA (8 * 512)

/** Lights the vertices of a triangle, unless they are; finds their normals alone where the material has no terms. */
glint_light_triangle glint_terms_light;

/** Of a triangle: lights that do not shine on it, and those whose highlights may show where polynomials fit. */
typedef struct glint_reach {
    uint32_t away, lobes;
} glint_reach;

/** The light of a triangle that is not deep, from its corners on. @return 0 where polynomials do not fit: then sets its
 * reach */
int glint_terms_begin(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                      const glint_part *part, glint_terms *terms, glint_polynomials *polynomials, glint_reach *reach);

/** What is found of a triangle, or of a piece of it. */
typedef struct glint_found_terms {
    uint32_t fits;     /* 0: it has no polynomials, and what comes next is all that is known */
    glint_reach reach; /* of what is drawn in other ways */
    glint_terms terms;
    glint_polynomials polynomials; /* those in use */
} glint_found_terms;

/** Bytes of it that say something. */
static inline size_t glint_found_terms_size(const glint_found_terms *found) {
    return found->fits ? offsetof(glint_found_terms, polynomials) + found->terms.end * sizeof(glint_quadratic)
                       : offsetof(glint_found_terms, terms);
}

/** Draws a part: by the format's own loop where terms are fused, else runs of as many rows at once as two rows of a
 * tile have pixels. */
void glint_terms_draw_part(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                           const glint_triangle *triangle, const glint_part *part, const glint_terms *terms,
                           const glint_polynomials *polynomials);

#endif
