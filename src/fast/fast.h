/* SPDX-License-Identifier: MIT */
/**
 * @file fast.h
 * Fast lighting of fragments under one directional light: at each vertex N.L and the deviation of its normal from its
 * half vector, which are linear over a small triangle; tables of colour over both; and what makes triangles fit.
 */
#ifndef GLINT_FAST_H
#define GLINT_FAST_H

#include "../geometry/draw.h"
#include "../light/shading.h"
#include "../pixel/spread.h"
#include "../raster/raster.h"

/** Entries of a diffuse table: 256 for N.L from 0 to 1, the rest for what lengthened normals reach above it. */
#define GLINT_DIFFUSE_ENTRIES 272

/** A ray's z; its length goes into a table that ends at sqrt(12) times this. */
#define GLINT_FAST_RAY_Z (1 << 14)

/** Largest x and y of a deviation that a plane can hold. */
#define GLINT_FAST_REACH 15000

/** N.L, Q14, that is above 0 at every pixel: planes are off by at most 2^-10 of their corners' difference, and set-up
 * of quadratics rounds, too. */
#define GLINT_LEAST_LIT 150

/** @name What a vertex's flags say of its terms.
 * @{ */
#define GLINT_VERTEX_UNFIT 0x8u     /**< It cannot be lit this way. */
#define GLINT_VERTEX_DIM 0x10u      /**< N.L is below what highlights need. */
#define GLINT_VERTEX_DARK 0x20u     /**< N.L is so far below 0 that rounding cannot light it. */
#define GLINT_VERTEX_FAR 0x40u      /**< Beyond GLINT_FAST_REACH. */
#define GLINT_VERTEX_OUTSIDE 0x100u /**< Beyond side 0 of the highlight's octagon; the other sides follow. */
#define GLINT_VERTEX_ANY_OUTSIDE 0xff00u
/** @} */

/** Where the highlight of fast_exact.c lies, and how far a half vector can be taken for linear. */
typedef struct glint_exact_limits {
    int32_t scale;             /* of the deviation, Q15, above 2^14.5: what makes `end` a whole power of two */
    uint32_t shift;            /* a squared deviation over w^2, Q30, >> this has 16 bits where the highlight shows */
    uint32_t limit;            /* and is below this; 0 where no highlight ever shows */
    uint32_t end;              /* entries of the specular table, times 2^20 */
    int32_t cut, cut_diagonal; /* outside an octagon of this radius no highlight shows; scaled, Q14 */
    int32_t behind;            /* N.H at corners, Q15: the back of the highlight's cone shows at none above this */
    /* The local viewer's */
    int32_t error;        /* of a deviation, from a half vector that is not linear, Q14 */
    int32_t extent;       /* of a triangle that has one for linear, sixteenths */
    uint32_t cell;        /* a square of 2^cell pixels has one too; below 3, none has */
    int32_t pixel;        /* a pixel in units of the focal length, 14 bits */
    uint32_t pixel_shift; /* over 2^pixel_shift */
    /* Interpolation: sums of squares that keep its error small, Q15 */
    int32_t turn, turn_specular;
    int32_t large;        /* twice the area, 28.4 squared, above which these are halved */
    int32_t bend;         /* of what a ray turns by, as much the half vector turns by at most: Q15 */
    int32_t full;         /* N.L, Q14, up to which all light together, with a highlight, stays below 1 */
    uint32_t front;       /* squared, as the table's: corners with less face the half vector */
    int16_t across[2][3]; /* infinite viewer: what takes a normal to its deviation, scaled, Q15 */
} glint_exact_limits;

typedef struct glint_fast_terms {
    /* Tables, null where the arena had no room: then each word is computed when it is needed, the same to the bit. */
    const uint32_t *diffuse;    /* ambient and diffuse light over N.L, spread */
    const void *diffuse_stored; /* the same as it is stored: packed into 16 bits, or `diffuse` */
    const uint32_t *specular;   /* over the squared deviation, spread; `diffuse` lies behind it */
    uint32_t specular_end;      /* squared deviation where it ends; 0 where no highlight ever shows */
    uint16_t ambient;           /* packed */
    uint8_t local_viewer;       /* not without highlight */
    /* N.L, Q14: from which on highlights add to what tables hold; up to which it is ambient light */
    int16_t lit, unlit;
    /* For each vertex, triangle or pixel, to the quadratic's `end`: in 128 bytes, which Cortex-M0 loads from at once */
    int32_t long_light[3]; /* longer by a part in 2^13: UNIT^2 is short of 2^30 by 2^-12 */
    int32_t ray_scale;     /* from 28.4 to a ray with z = 2^14, Q16 */
    /* Places are counted from one ray_limit to the other, so far; and the ray at the first. */
    uint32_t ray_right, ray_bottom, ray_span, ray_start;
    int32_t wide_light[3];       /* Q30, half a step of Q15 included */
    int32_t reach;               /* deviation, Q14, that a plane can hold */
    uint32_t within;             /* the largest 2^n - 1 that is no more */
    int32_t scale;               /* from a deviation, Q14, to a scaled one, whose square is the table's: Q16 */
    int32_t scaled_half;         /* half a step of both, Q16 */
    uint32_t sides[2];           /* 2^15 less `side`, and less half of `side_diagonal`, in both halves of a word */
    int32_t turn, turn_specular; /* limits that keep the error small: glint_fast_fits */
    uint32_t slant;
    int32_t even;   /* change of N.L, Q14, that is too little to show; 0 without an error budget */
    int32_t extent; /* on the screen, 28.4 */
    glint_exact_limits exact;
    int16_t light[3], half_vector[3];
    int32_t side, side_diagonal; /* scaled: outside an octagon of this radius no highlight shows */
    int32_t cut, cut_diagonal;   /* its radius as a deviation, Q14 */
    uint32_t sine_square_end;    /* specular_end as sin^2, Q30 */
    int32_t ray_limit;           /* 28.4, from the centre */
    int32_t center_x, center_y;  /* of the screen, 28.4 */
    int32_t lit_exactly;         /* as `lit`, Q15, of pixels that are gated one by one */
    uint32_t tables_sum;         /* glint_sum */
    uint32_t ambient_word;
    uint8_t is_rounded; /* words hold half a level: they are stored as they are */
} glint_fast_terms;

/** How a triangle is drawn. */
typedef enum glint_fast_kind {
    GLINT_FAST_UNFIT,                            /* not by these kernels */
    GLINT_FAST_AMBIENT = GLINT_KERNEL_AMBIENT,   /* faces away from the light all over */
    GLINT_FAST_DIFFUSE = GLINT_KERNEL_DIFFUSE,   /* lit all over, without highlight */
    GLINT_FAST_GATED = GLINT_KERNEL_GATED,       /* without highlight, and N.L may be below 0 */
    GLINT_FAST_SPECULAR = GLINT_KERNEL_SPECULAR, /* lit all over */
    GLINT_FAST_EVEN = GLINT_KERNEL_EVEN,         /* without highlight, of one colour */
} glint_fast_kind;

/** Planes of a triangle. */
typedef struct glint_fast_planes {
    glint_plane cosine; /* N.L, Q30 */
    glint_plane x, y;   /* scaled deviation in the high half: the sum of the squares is 2^15 a table's entry */
} glint_fast_planes;

/** The weights of the one light that a material of fast lighting shows; 0 where it shows none. */
const glint_weights *glint_weights_shown(const glint_shading *shading);

/** Is it the larger of ambient light and all other, not the sum? */
static inline int glint_takes_largest(const glint_shading *shading) {
    return (shading->material->flags & GLINT_MATERIAL_MAX) != 0;
}

/** Can an object be lit this way? Its material is prepared. */
int glint_fast_serves(const glint_frame *frame, const glint_object *object);

/** Bytes that a material takes, and its tables. */
void glint_fast_need(const glint_frame *frame, const glint_shading *shading, size_t *least, size_t *tables);

/** The largest levels of red, green and blue. */
static const uint32_t glint_fast_levels[3] = {31, 63, 31};

/** Bytes of a material's tables, the specular one of so many entries. */
size_t glint_fast_tables_size(const glint_format *format, uint32_t specular);

/** Sets what words are like, and the colour of ambient light. */
void glint_fast_prepare_words(glint_fast_terms *fast, const glint_format *format, const glint_shading *shading);

/** Makes a material's tables, if they leave that much; not those that the last frame left. */
void glint_fast_make_tables(glint_frame *frame, glint_fast_terms *fast, const glint_shading *shading);

/** Prepares the materials of a frame; they are what the arena holds last. */
glint_status glint_fast_prepare(glint_frame *frame);

/** A pixel's word as the tables make it: N.L in Q30, and the squared deviation. Channels may be beyond 1. */
uint32_t glint_fast_word(const glint_shading *shading, int32_t cosine, uint32_t square);

/** UNIT 2^15 / (UNIT + z), z from 0 to UNIT; linear interpolation, off by at most 2. */
static inline int32_t glint_inverse_of_one_and(int32_t z) {
    const uint16_t *node = &glint_inverse_table[z >> 9];
    return node[0] - ((node[0] - node[1]) * (z & 511) >> 9);
}

/**
 * No less than what (1 - s^2)^(p/2) changes over s, Q8: 0.61 sqrt(p) where p is large, 2 where it is 2. p >= 2; with
 * less, a larger number.
 */
uint32_t glint_highlight_slope(glint_q16 p);

/**
 * sqrt(p / 32), at most 1, Q10. The contract counts a frame's pixels: wider highlights have their slopes in more of
 * them, and smaller errors.
 */
uint32_t glint_highlight_share(glint_q16 p);

/** V, unit; the focal length over that of its ray, and 1 / |L + V|: Q16, at most 1. */
typedef struct glint_view_vector {
    int32_t v[3], root, half_root;
} glint_view_vector;

/**
 * H = (L + V) / |L + V|, unit, at a point of the screen, 28.4.
 * @return 0 when it lies too far out, or |L + V| is below 1.
 */
int glint_fast_half_vector(const glint_fast_terms *fast, int32_t x, int32_t y, int16_t half_vector[3],
                           glint_view_vector *view);

/** glint_fast_half_vector between two points, x and y the sums of theirs; what the view holds may not be needed. */
static inline int glint_half_vector_inline(const glint_fast_terms *fast, int32_t x, int32_t y, int16_t half_vector[3],
                                           glint_view_vector *view) {
    int32_t z = GLINT_FAST_RAY_Z;
    const uint32_t right = fast->ray_right - (uint32_t)glint_shift_right(x, 1),
                   down = fast->ray_bottom + (uint32_t)glint_shift_right(y, 1), half = (uint32_t)fast->ray_scale >> 1,
                   left = (uint32_t)x & 1 ? half : 0, below = (uint32_t)y & 1 ? half : 0;
    if (right > fast->ray_span || down > fast->ray_span)
        return 0;
    x = glint_shift_right((int32_t)(right * (uint32_t)fast->ray_scale + fast->ray_start - left), 16);
    y = glint_shift_right((int32_t)(down * (uint32_t)fast->ray_scale + fast->ray_start + below), 16);
    int32_t root = glint_inverse_root_above((uint32_t)(x * x) + (uint32_t)(y * y)); /* z^2 is 2^28 */
    view->root = root;
    view->v[0] = glint_shift_right(x * root + 0x4000, 15);
    view->v[1] = glint_shift_right(y * root + 0x4000, 15);
    view->v[2] = glint_shift_right(z * root + 0x4000, 15);
    z = z * root + fast->wide_light[2];
    if (z < 0)
        return 0;
    /* half of L + V */
    x = glint_shift_right(x * root + fast->wide_light[0], 16);
    y = glint_shift_right(y * root + fast->wide_light[1], 16);
    z = glint_shift_right(z, 16);
    const int32_t c = x * x + y * y + z * z - (1 << 28);
    if (c < 0)
        return 0;
    root = glint_inverse_root_above((uint32_t)c);
    view->half_root = root;
    half_vector[0] = (int16_t)glint_shift_right(x * root, 15);
    half_vector[1] = (int16_t)glint_shift_right(y * root, 15);
    half_vector[2] = (int16_t)glint_shift_right(z * root, 15);
    return 1;
}

/** A vertex's terms: N.L, Q14, and its scaled deviation. */
static inline const int16_t *glint_fast_terms_of(const glint_draw *draw, const glint_vertex *vertex) {
    return draw->terms[vertex - draw->vertices];
}

/** Lights the vertices of a triangle, unless they are. */
glint_light_triangle glint_fast_light;

/** The word of a triangle of one colour: that of its plane of N.L at the anchor. */
uint32_t glint_fast_even(const glint_shading *shading, const glint_fast_planes *planes);

/** Pixels of a part's spans. */
uint32_t glint_fast_covered(const glint_part *part);

#endif
