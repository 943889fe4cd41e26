/* SPDX-License-Identifier: MIT */
/**
 * @file frame.h
 * What the stages hand to each other: view -> transform -> vertex -> batch -> fragments. Formats: numeric.h.
 */
#ifndef GLINT_FRAME_H
#define GLINT_FRAME_H

#include "glint.h"
#include "numeric.h"
#include "product.h"

/** Half width of the guard band in pixels: clip space x = w lies this far from the screen's centre. */
#define GLINT_GUARD_BAND 1023

/** Tile width and height where the configuration says 0. */
#define GLINT_TILE_DEFAULT 32

/** Largest tile width and height. */
#define GLINT_TILE_MAX 64

/** Fragments shaded together. */
#define GLINT_FRAGMENTS_MAX 9

/** Intervals of a power table, and bits of the position within one that are used. */
#define GLINT_POWER_TABLE_BITS 7
#define GLINT_POWER_INTERVALS (1 << GLINT_POWER_TABLE_BITS)
#define GLINT_POWER_FRACTION_BITS 12

/* ---- prepare: the scene, once a frame ---- */

/** A light in camera space. */
typedef struct glint_prepared_light {
    const glint_light_type *type;
    int16_t direction[3];   /* directional: towards the light, unit; spot: against its axis, unit */
    int16_t half_vector[3]; /* directional, for the infinite viewer; 0 when the light is straight behind */
    struct {
        int32_t mantissa[3]; /* position times 2 focal lengths over the frame's nearest w: mantissa 2^-shift, Q12, over
                                Q31 */
        int32_t shift;
        int32_t distance_mantissa; /* |light vector| UNIT / 2^15 over 1/w to world units: mantissa 2^-shift, 31 bits */
        int32_t distance_shift;
        uint32_t linear, quadratic; /* Q16, times 2 to the power of these bits: 2^31 or more, or 0 */
        uint32_t linear_bits, quadratic_bits;
    } point;
    struct {
        int32_t cosine_outer, cosine_inner; /* times GLINT_UNIT^2 */
        int32_t slope;                      /* Q15: 2^30 / (difference >> 15) */
    } spot;
} glint_prepared_light;

/** Camera and lights. */
typedef struct glint_view {
    int32_t rotation[3][3]; /* world to camera, Q16.16 */
    int32_t eye[3];         /* world, Q16.16 */
    int32_t focal;          /* twice the focal length in pixels, Q12 */
    int32_t focal_mantissa; /* focal length / guard band = mantissa 2^-shift, 2^23 to 2^24 */
    uint32_t focal_shift;
    int64_t near_plane; /* Q28 */
    int64_t nearest;    /* Q28: no visible w is smaller */
    uint32_t light_count;
    uint8_t local_viewer;
    uint8_t has_positions; /* some light has one */
    glint_prepared_light lights[GLINT_LIGHTS_MAX];
} glint_view;

/** Bytes of a view with so many lights. */
#define GLINT_VIEW_SIZE(count) (offsetof(glint_view, lights) + (count) * sizeof(glint_prepared_light))

/** x^p for x = 1 - u, or for x itself where p < 2. */
typedef struct glint_power_table {
    int32_t exponent;            /* p, Q16.16 */
    uint32_t direct;             /* p < 2: no table, the power is computed */
    uint32_t window;             /* Q30: the table spans sin^2 from 0 to this power of two; beyond, the power is 0 */
    uint32_t index_shift;        /* sin^2 in Q30 >> this is the interval */
    int32_t cosine_square_floor; /* Q15: below this cos^2 lies outside the window */
    uint16_t value[GLINT_POWER_INTERVALS + 1]; /* Q15 */
} glint_power_table;

/** What a material makes of a light, Q12. */
typedef struct glint_weights {
    uint32_t diffuse[3], specular[3];
} glint_weights;

/** Numbers of a light at a node: terms.h. */
#define GLINT_NUMBERS 5

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
    uint32_t diffuse_levels[GLINT_LIGHTS_MAX]; /* what 1 makes at most, levels in Q8 */
    uint32_t specular_levels[GLINT_LIGHTS_MAX];
    uint32_t ambient_levels; /* of ambient light */
    uint32_t channels;       /* of a node's sum: 1 where all diffuse light is of one chroma, else 3 */
    unsigned sum_bits;       /* sums are below this power of two */
    uint32_t lobes;          /* bit i: light i has a highlight that is a term of its own */
    uint8_t at[GLINT_LIGHTS_MAX][GLINT_NUMBERS]; /* where a vertex keeps a light's numbers */
    uint32_t light_count, shown;                 /* of the scene, and those of them that show */
    uint32_t stride;                             /* numbers that a vertex keeps */
    uint32_t lobe_shift;                         /* a deviation, Q14, is kept times 2^this */
    int32_t lobe_cut, lobe_diagonal;             /* outside an octagon of this radius no highlight shows; as kept */
    uint32_t lobe_end;                           /* squared deviation, as kept, where the power table ends */
    uint32_t slope;                              /* of a highlight over its deviation, at most, Q8 */
    uint8_t lobe_is_wide;                        /* small p: of a deviation there is the cosine alone, Q14 */
    uint8_t lobe_has_strip;                      /* p < 1: near the horizon polynomials do not fit */
    uint32_t limit;                              /* of the error of polynomials, levels in Q8 */
    uint32_t pixel;                              /* 1/16 of one over the focal length, Q30 */
    uint16_t cosine[GLINT_COSINE_VALUES];        /* powers of the cosine, Q15, where lobes are wide */
} glint_light_terms;

/** A material under the scene's lights. */
typedef struct glint_shading {
    const glint_material *material;
    int32_t shininess;
    uint32_t ambient[3]; /* Q23 */
    glint_weights weights[GLINT_LIGHTS_MAX];
    uint32_t lights;                         /* bit i: light i shows */
    uint32_t has_specular;                   /* bit i: its specular light does */
    uint32_t spare;                          /* of the error budget, Q12: what each light's specular light may lack */
    uint32_t changed;                        /* 0: all above is what the last frame left here, and so are its tables */
    const struct glint_deviation *deviation; /* tables of fast lighting, or null */
    const glint_light_terms *terms;          /* null where fragments are lit one by one */
    size_t node_size;                        /* bytes that a vertex keeps of light; 0 where it keeps none */
    glint_power_table power;
} glint_shading;

/** A material of the frame as it was prepared. */
static inline const glint_shading *glint_shading_of(const glint_frame *frame, const glint_material *material) {
    const glint_shading *shading = frame->shading;
    while (shading->material != material)
        shading++;
    return shading;
}

/* ---- transform: an object, once a pass ---- */

/** Mesh steps to clip space, and object normals to camera space. */
typedef struct glint_transform {
    glint_row matrix[3]; /* rows x, y, w: clip coordinate of 2^15 steps */
    int32_t translation[3];
    glint_row normal[3];
    int32_t exponent;            /* a clip unit is 2^-exponent */
    int32_t near_plane, least_w; /* w of the near plane, and of the nearest corner of the box */
    int32_t nearest;             /* w of the frame, no more than any of the object's that is seen */
    int32_t center_x, center_y;  /* of the screen, 28.4 and 11 bits for rounding */
    uint8_t visible, clips, mirrored;
} glint_transform;

/** The eye among a mesh's steps, homogeneous. */
typedef struct glint_eye {
    int32_t x, y, z;  /* times weight 2^-8: 20 bits and a sign */
    int32_t distance; /* from step 0, or a little more; times the same */
    int32_t weight;   /* 13 bits */
} glint_eye;

/** Finds the eye from an object's transform. */
void glint_transform_eye(const glint_transform *transform, glint_eye *eye);

/* ---- geometry: vertices ---- */

#define GLINT_VERTEX_CLIP 1u   /* in front of the near plane or outside the guard band: x, y and 1/w are not valid */
#define GLINT_VERTEX_LIT 2u    /* its terms of fast lighting are known */
#define GLINT_VERTEX_NORMAL 4u /* its normal is known; until then its number in the mesh stands in attribute[0] */
/* The other flags tell of these terms: deviation.c. */

typedef struct glint_vertex {
    int32_t inverse_w;    /* Q31 */
    int16_t x, y;         /* 28.4 */
    int16_t attribute[3]; /* unit normal in camera space; once lit, colour, 1 = GLINT_COLOUR_ONE */
    uint16_t flags;
} glint_vertex;

/** Full brightness of a colour in int16. */
#define GLINT_COLOUR_ONE 32767

/** Clip coordinates; kept only where an object may have to be clipped. */
typedef struct glint_position {
    int32_t x, y, w;
} glint_position;

/* ---- bin: what a pass draws ---- */

struct glint_draw;
struct glint_triangle;
struct glint_part;

/** Draws the spans of a triangle: tests and stores depth, and stores the pixels that pass. */
typedef void glint_kernel(const glint_frame *frame, glint_workspace *workspace, const struct glint_draw *draw,
                          const struct glint_triangle *triangle, const struct glint_part *part);

/** Lights triangle i of a draw. */
typedef void glint_light_triangle(const glint_frame *frame, struct glint_draw *draw, const glint_transform *transform,
                                  uint32_t i);

/** An object, or a run of its triangles. */
typedef struct glint_draw {
    struct glint_draw *next;
    const uint16_t (*triangles)[3]; /* the first one's indices */
    glint_vertex *vertices;
    glint_position *positions;   /* null unless the object may be clipped or is lit before it is drawn */
    int16_t (*extra)[3];         /* null, or per vertex: the surface's colour, or the back's colour when lit */
    int16_t (*terms)[3];         /* null, or per vertex: the terms of fast lighting */
    int16_t *nodes;              /* null, or per vertex: what it keeps of light */
    int16_t (*facets)[3];        /* null, or colours of the triangles */
    const int16_t (*normals)[3]; /* of the mesh */
    const glint_cull *cull;      /* null, or what drops the mesh's clusters */
    uint8_t *away; /* null, or which of them face away, 1 or 0; not of runs, which leave their triangles out */
    const glint_shading *shading;
    const glint_evaluation *evaluation;
    glint_light_triangle *light; /* what comes before a triangle is drawn, or null */
    glint_kernel *kernel;
    glint_transform transform;
    uint32_t vertex_count;
    uint32_t object;         /* index in the scene */
    uint32_t first_triangle; /* of the mesh */
    uint16_t first;          /* number in the pass of its first triangle */
    uint16_t count;
    uint8_t mirrored, double_sided;
} glint_draw;

/* ---- cull: clusters of triangles that face away ---- */

/** A mesh's clusters, one after the other. */
typedef struct glint_walk {
    glint_eye eye;
    const glint_cluster *cluster; /* the next */
    uint32_t end;                 /* its first triangle */
    uint8_t away;                 /* does the last one face away? */
} glint_walk;

/** What is linked where meshes have clusters. */
struct glint_cull {
    /** @return GLINT_ERROR_NULL where there is no list, GLINT_ERROR_MESH where clusters do not add up to the mesh */
    glint_status (*check)(const glint_mesh *mesh);
    /** Loads the vertices of a draw of all that is left of a mesh. */
    void (*load)(glint_frame *frame, glint_draw *draw, const glint_mesh *mesh);
    /** glint_bin_some of all from `next` on, but for clusters that face away. */
    int (*bin)(glint_frame *frame, glint_draw *draw, uint32_t next);
    /** Begins a run of triangles. */
    void (*begin)(glint_walk *walk, const glint_mesh *mesh, const glint_transform *transform);
    /** Corners of a run's triangles, in order: all the same where a cluster faces away. */
    const uint16_t *(*corners)(glint_walk *walk, const glint_mesh *mesh, uint32_t triangle);
};

/** What drops a mesh's clusters; null where it has none. */
static inline const glint_cull *glint_cull_of(const glint_mesh *mesh) {
    return mesh->clusters ? mesh->clusters->cull : 0;
}

/** A triangle made by clipping. */
typedef struct glint_clipped {
    glint_vertex corners[3];
    int16_t extra[3][3];
    uint16_t triangle; /* of the draw */
    const glint_draw *draw;
} glint_clipped;

/** Two halves that are stored and loaded as one word. */
#if defined(__GNUC__)
#define GLINT_WORD __attribute__((aligned(4)))
#else
#define GLINT_WORD
#endif

/**
 * A triangle in a tile's list, by its number: of a draw from 0 up, of the clipped from GLINT_CLIPPED_TOP down. The
 * first reference of a list is its tile's: it has no triangle, but the number of the last reference there, its own
 * where the list is empty.
 */
typedef struct GLINT_WORD glint_reference {
    uint16_t next; /* number of the next reference, or GLINT_LIST_END */
    uint16_t triangle;
} glint_reference;

#define GLINT_LIST_END 0xffffu
#define GLINT_CLIPPED_TOP 0xfffeu

/** Most triangles of draws in a pass: numbers above are left to clipped ones. */
#define GLINT_TRIANGLES_MAX 0xe000u

/** Tiles of a pass. */
static inline uint32_t glint_pass_tiles(const glint_frame *frame) {
    return (uint32_t)(frame->tile_end - frame->tile_first);
}

/* ---- raster and shade: fragments of one triangle, or vertices to be lit ---- */

/** A linear function of the pixel: value at the anchor, change per pixel in x and y. */
typedef struct glint_plane {
    int32_t start, dx, dy;
} glint_plane;

/**
 * How a triangle's planes come from values at its corners. Narrow: the sides across from the second and the third
 * corner, turned by a right angle, in sixteenths, and 1/area = reciprocal 2^-(16 + shift). Wide: these sides times
 * 1/area, the change of the corners' barycentric coordinates per pixel, times 2^shift, 31 bits; reciprocal is 0.
 */
typedef struct glint_gradients {
    int32_t x1, y1, x2, y2;
    int32_t reciprocal, shift;
    uint32_t reach; /* no less than the other corners lie from the first in x or y, in sixteenths, less 1 */
    int32_t to_center_x, to_center_y; /* from the first corner to the anchor's centre, in sixteenths */
} glint_gradients;

/** Pixels of one row of a tile: from column `left` to before `right`, none where they are equal. */
typedef struct glint_span {
    uint8_t left, right;
} glint_span;

/** A tile on the screen: its first pixel's centre in sixteenths, and how much of it the screen shows, in pixels. */
typedef struct glint_window {
    int32_t left, top, width, height;
    uint32_t origin, beyond; /* raster's own: of places, and the bits that none in the tile has */
} glint_window;

/** Most rows of a triangle that raster walks as a whole. */
#define GLINT_SHORT_ROWS 31

/** The part of a triangle that lies in one tile. Its anchor is the pixel of the triangle's first corner. */
typedef struct glint_part {
    glint_window window;
    int32_t x, y;         /* of the tile's first pixel, from the anchor: where planes are evaluated */
    uint32_t top, bottom; /* rows of the tile; bottom is exclusive */
    glint_plane depth;    /* 1/w, Q31 */
    glint_gradients gradients;
    glint_span above[GLINT_SHORT_ROWS]; /* raster's own, of rows above the tile */
    glint_span spans[GLINT_TILE_MAX];   /* of these rows */
} glint_part;

/** Up to two triples: a normal over w or a lit colour, and the surface's own colour. */
typedef struct glint_attributes {
    glint_plane main[3], extra[3];
} glint_attributes;

/** Fragments of one triangle in a tile; or vertices or a triangle's middle, which have no place. */
typedef struct glint_fragments {
    uint32_t count;
    const glint_part *part;
    int8_t column[GLINT_FRAGMENTS_MAX], row[GLINT_FRAGMENTS_MAX]; /* from the tile's first pixel */
    uint32_t scale;                                               /* attributes are interpolated over w 2^scale */
    const glint_attributes *attributes;
    int32_t inverse_w[GLINT_FRAGMENTS_MAX];
    int32_t ray[GLINT_FRAGMENTS_MAX][3];     /* towards the eye: minus the position times 1/w, Q12 */
    int16_t normal[GLINT_FRAGMENTS_MAX][3];  /* unit */
    int16_t view[GLINT_FRAGMENTS_MAX][3];    /* unit, towards the eye */
    int16_t light[GLINT_FRAGMENTS_MAX][3];   /* unit, towards a light that has a position */
    uint16_t strength[GLINT_FRAGMENTS_MAX];  /* of that light, Q15 */
    uint32_t length[GLINT_FRAGMENTS_MAX];    /* distance to it in the ray's units, times UNIT / 2^15: this times */
    int8_t exponent[GLINT_FRAGMENTS_MAX];    /* 2^exponent; 0 where it is right there */
    int16_t surface[GLINT_FRAGMENTS_MAX][3]; /* colours of their own */
    uint32_t colour[GLINT_FRAGMENTS_MAX][3];
} glint_fragments;

/** Fragments of a triangle as they are gathered, and its attributes. */
typedef struct glint_gathered {
    glint_fragments fragments;
    glint_attributes attributes;
} glint_gathered;

/* ---- pixel: channels of a colour ---- */

/** Fractional bits of a channel on its way into a pixel: sums below 16 fit. */
#define GLINT_CHANNEL_BITS 27
#define GLINT_CHANNEL_ONE (1 << GLINT_CHANNEL_BITS)

/** A channel from one of 15 bits, 1 = GLINT_COLOUR_ONE. */
static inline int32_t glint_channel_of(int16_t colour) {
    return (colour << (GLINT_CHANNEL_BITS - 15)) + (colour >> (30 - GLINT_CHANNEL_BITS));
}

/** A colour, Q23, as channels that are not in levels; those beyond 15 become 15. */
static GLINT_INLINE void glint_channels_of(const uint32_t colour[3], int32_t channel[3]) {
    const uint32_t most = 15u << 23;
    for (int c = 0; c < 3; c++) /* Q23 to Q27 */
        channel[c] = (int32_t)((colour[c] < most ? colour[c] : most) << (GLINT_CHANNEL_BITS - 23));
}

/** A channel as levels of so many bits, half a level included: cut off, it is rounded. 0 bits: as it is. */
static inline int32_t glint_to_levels(int32_t channel, unsigned bits) {
    return bits ? channel - glint_shift_right(channel, bits) + (1 << (GLINT_CHANNEL_BITS - 1 - bits)) : channel;
}

/* ---- descriptors ---- */

struct glint_model {
    /** Beyond the weights: what `light` needs. May be null. */
    void (*prepare)(glint_shading *shading, uint32_t largest_specular);
    /** Adds what one light gives to the fragments' colours; null for surfaces that are not lit. */
    void (*light)(const glint_shading *shading, uint32_t light, const glint_view *view, glint_fragments *fragments,
                  int has_surface);
    uint8_t lobe; /* what fast lighting takes it for */
};

/* What a model's specular light lies around. */
#define GLINT_LOBE_OTHER 0       /* what fast lighting does not know */
#define GLINT_LOBE_NONE 1        /* there is none */
#define GLINT_LOBE_HALF_VECTOR 2 /* Blinn's */
#define GLINT_LOBE_MIRROR 3      /* Phong's */

struct glint_light_type {
    /** Brings a light to camera space. @return GLINT_ERROR_DIRECTION, _ATTENUATION or _CONE when it is not valid. */
    glint_status (*prepare)(const glint_light *light, glint_prepared_light *prepared, const glint_view *view);
    /** Direction and strength at the fragments; null where both are the same everywhere. */
    void (*illuminate)(const glint_prepared_light *light, glint_fragments *fragments);
    /** The part of `prepare` that needs the frame's nearest w; may be null. */
    void (*place)(const glint_light *light, glint_prepared_light *prepared, const glint_view *view);
    uint8_t has_cone; /* prepared->spot holds one */
};

/** Where colours are found. */
typedef enum glint_lit_at { GLINT_LIT_AT_FRAGMENTS, GLINT_LIT_AT_VERTICES, GLINT_LIT_AT_FACETS } glint_lit_at;

/** What evaluations that light nodes link. */
typedef struct glint_node_stage {
    /** Behind all shadings: what each material makes of the frame's lights. Adds to frame->least_room. */
    glint_status (*prepare)(glint_frame *frame);
    /** Bytes that a vertex keeps of light in one material. @return 0 where nodes do not fit it, or none are lit of it
     */
    size_t (*measure)(const glint_frame *frame, const glint_shading *shading);
    size_t size; /* bytes that what a material makes of the lights takes */
} glint_node_stage;

struct glint_evaluation {
    glint_lit_at lit_at;
    glint_light_triangle *light; /* what comes before a triangle is drawn */
    glint_kernel *kernel;
    const glint_node_stage *nodes; /* or null */
};

struct glint_spans;
struct glint_quadratic;

struct glint_format {
    uint8_t bits;       /* per pixel */
    uint8_t channel[3]; /* bits of each channel's levels; 0 where it goes into luma */
    /** Stores a run of a row, from pixel `offset` of a tile on; colours are in levels. */
    void (*store)(void *pixels, unsigned tile_shift_x, uint32_t offset, uint32_t count, const int32_t (*colour)[3]);
    /** Gives all of a tile one colour. */
    void (*fill)(void *pixels, unsigned tile_shift_x, uint32_t height, const int32_t colour[3]);
    /* What the others do as well, in one loop; null in a library built for size. */
    /** Draws spans of one colour. */
    void (*draw_even)(const struct glint_spans *spans, const int32_t colour[3]);
    /** Draws spans of three polynomials; those that are not curved have no second degree. */
    void (*draw_channels)(const struct glint_spans *spans, const struct glint_quadratic *channels, int is_curved);
    const struct glint_fast *fast; /* or null */
};

/* ---- stages ---- */

/** Checks a scene, all but its meshes' indices. */
glint_status glint_check_scene(const glint_scene *scene);

/** Camera, lights and depth scale; and the last object's transform, but for what needs view->nearest. */
glint_status glint_prepare_view(glint_view *view, const glint_config *config, const glint_scene *scene,
                                glint_transform *last);

/**
 * A material's weights and power table.
 * @param shading all 0, or what the same place held in the last frame: tables are then kept if they would be the same
 */
glint_status glint_prepare_shading(const glint_frame *frame, glint_shading *shading, const glint_material *material);

/**
 * A power table for exponent p; weight, Q12, is the largest that its values are multiplied by. What falls below
 * `spare`, Q12, need not show: where that is 0, below 1/16 of an 8-bit step.
 */
void glint_power_prepare(glint_power_table *table, int32_t exponent, uint32_t weight, uint32_t spare);

/** Brings a world direction to camera space, unit. @return 0 when it has length 0. */
int glint_direction_to_camera(const glint_view *view, glint_vector world, int16_t out[3]);

/** x / 2^shift, rounded to nearest, halves up; shift from -62 to 62, |x| and the result below 2^62. */
int64_t glint_shift_round64(int64_t x, int shift);

/** Scales a vector of 64 bits to one of 30, its direction kept. @return n: it is 2^n times the result. */
unsigned glint_reduce(const int64_t in[3], int32_t out[3]);

/** An object's transform. Takes view->nearest as it stands. */
glint_status glint_transform_prepare(glint_transform *transform, const glint_view *view, const glint_config *config,
                                     const glint_object *object);

/** The part of it that needs view->nearest, anew. */
void glint_transform_place(glint_transform *transform, const glint_view *view);

/** Smallest w of the object's bounding box, Q28, no less than the near plane. */
int64_t glint_transform_nearest(const glint_transform *transform, const glint_view *view);

/** Transforms vertices of a mesh from `first` on, all but their normals; positions may be null if nothing clips. */
void glint_transform_vertices(const glint_transform *transform, const glint_mesh *mesh, uint32_t first, uint32_t count,
                              glint_vertex *vertex, glint_position *position);

/** Brings a vertex's normal to camera space. */
void glint_transform_normal(const glint_draw *draw, glint_vertex *vertex);

/** Brings the normals of a triangle's corners to camera space, unless they are. */
glint_light_triangle glint_transform_normals;

/** Screen position and 1/w of clip coordinates inside the guard band and beyond the near plane. */
void glint_project(const glint_transform *transform, const glint_position *position, glint_vertex *vertex);

/** Ray towards the eye and 1/w, as fragments have them, of the mean of some positions anywhere, given their sum. */
void glint_ray(const glint_transform *transform, const glint_view *view, const int64_t sum[3], int32_t count,
               int32_t ray[3], int32_t *inverse_w);

/** Most corners of a clipped triangle: each of 5 planes adds one. */
#define GLINT_CLIP_CORNERS 8

/** A corner on its way through clipping. */
typedef struct glint_corner {
    glint_position position;
    int32_t attribute[6]; /* a vertex's attribute and its extra one; normals get shorter where interpolated */
} glint_corner;

/**
 * Clips a triangle at the near plane and the guard band.
 * @param corners the triangle in, the polygon out
 * @return corners of the polygon: 0, or 3 to 8
 */
int glint_clip(const glint_transform *transform, glint_corner corners[GLINT_CLIP_CORNERS]);

/** A rectangle of pixels or tiles; right and bottom are exclusive. */
typedef struct glint_range {
    int32_t left, top, right, bottom;
} glint_range;

/**
 * Twice a triangle's area in 28.4 squared; above 0 when its corners run clockwise on the screen, y down.
 * The guard band keeps it in 32 bits.
 */
static inline int32_t glint_double_area(const glint_vertex *a, const glint_vertex *b, const glint_vertex *c) {
    return (b->x - a->x) * (c->y - a->y) - (c->x - a->x) * (b->y - a->y);
}

/** Fills in defaults. @return GLINT_ERROR_NULL, _SIZE or _TILE. */
glint_status glint_check_config(glint_config *config);

/** Bytes of arena that glint_render keeps for tiles. */
size_t glint_tile_buffers_size(const glint_config *config);

/** Puts triangles from (frame->object, frame->triangle) on into the lists of the pass's tiles. */
glint_status glint_bin(glint_frame *frame, int *complete);

/** Brings stats.arena_used up to date after binning. */
void glint_count_arena(glint_frame *frame);

/**
 * Where the last object's transform waits from when the view is prepared until vertices are loaded: at the arena's high
 * end, which none of that takes.
 */
static inline glint_transform *glint_last_transform(const glint_frame *frame) {
    return (glint_transform *)(void *)(frame->memory.base + frame->memory.high) - 1;
}

/** Loads `count` vertices of the mesh from `index` on into those of a draw from `slot` on. */
void glint_load_vertices(glint_frame *frame, glint_draw *draw, uint32_t index, uint32_t slot, uint32_t count);

/**
 * Bins the triangles of a draw from number `next` to before `end`.
 * @return the first that the arena had no room for, `end`, or GLINT_ERROR_INDEX
 */
int glint_bin_some(glint_frame *frame, glint_draw *draw, uint32_t next, uint32_t end);

/** Loads vertices of objects from (frame->object, frame->triangle) on, as many as fit. */
glint_status glint_load(glint_frame *frame);

/** Sets up all of a frame but its arena. */
glint_status glint_frame_grid(glint_frame *frame, const glint_config *config, const glint_scene *scene);

/** Does a triangle face the eye? Not when it has no area. */
static inline int glint_faces(int mirrored, int double_sided, const glint_vertex *const v[3]) {
    int32_t area = glint_double_area(v[0], v[1], v[2]);
    return area != 0 && (double_sided || (area > 0) == mirrored);
}

/** Tiles that a triangle may touch. @return 0 when it covers no pixel centre of the screen. */
int glint_find_tiles(const glint_frame *frame, const glint_vertex *const v[3], glint_range *range);

/** What everything in the arena is aligned to. */
#define GLINT_ALIGNMENT (sizeof(void *))

/** Bytes, rounded up to the alignment. */
#define GLINT_ALIGNED(size) (((size) + GLINT_ALIGNMENT - 1) & ~(GLINT_ALIGNMENT - 1))

/** The first aligned byte: at most GLINT_ALIGNMENT - 1 further. An arena gives those up wherever it starts. */
static inline uint8_t *glint_align(void *memory) {
    uint8_t *bytes = memory;
    return bytes + (-(uintptr_t)bytes & (GLINT_ALIGNMENT - 1));
}

/** Free bytes with which any triangle can be binned into one tile. */
#define GLINT_BIN_RESERVE                   \
    GLINT_ALIGNED(sizeof(glint_reference) + \
                  (GLINT_CLIP_CORNERS - 2) * (sizeof(glint_reference) + sizeof(glint_clipped)))

/** Bytes of arena that a draw of so many vertices and triangles takes, its own index list included if it has one. */
size_t glint_draw_size(const glint_frame *frame, const glint_object *object, const glint_transform *transform,
                       size_t vertices, size_t triangles, int has_list);

/** Bytes beyond what is prepared with which any scene can be drawn: a run of one triangle, and its bin. */
#define GLINT_LEAST_ROOM                                                                                        \
    (GLINT_ALIGNED(sizeof(glint_draw)) + GLINT_ALIGNED(3 * sizeof(glint_vertex)) +                              \
     GLINT_ALIGNED(3 * sizeof(glint_position)) + GLINT_ALIGNED(18) + 2 * GLINT_ALIGNED(36) + GLINT_ALIGNED(8) + \
     GLINT_ALIGNED(6) + GLINT_BIN_RESERVE)

/** A triangle to draw. */
typedef struct glint_triangle {
    const glint_vertex *corners[3]; /* counter-clockwise on the screen */
    const int16_t *extra[3];        /* where the draw has extra attributes */
    const int16_t *facet;           /* its colour, where the draw is lit by facet */
    int32_t area;                   /* twice its area, 28.4 squared, above 0 */
    int back;                       /* seen from the back */
} glint_triangle;

/** A window that shows so many pixels from pixel x, y of the screen on. */
void glint_window_begin(glint_window *window, int x, int y, int width, int height);

/**
 * Finds a triangle's rows and spans in a tile, the part's window. Corners v run counter-clockwise on the screen, within
 * 1535 pixels of the tile's first.
 * @return 0 when they hold no pixels: then neither does the part hold anything
 */
int glint_raster(glint_part *part, const glint_vertex *const v[3]);

/** Is all that a tile shows background, now that this pass is prepared? */
int glint_tile_is_empty(const glint_frame *frame, uint32_t tile);

/** Adds a part that covers so many pixels to what a kernel drew, where that is counted. */
static inline void glint_count(const glint_workspace *workspace, glint_kernel_name kernel, uint32_t covered) {
    if (!workspace->drawn)
        return;
    workspace->drawn[kernel].parts++;
    workspace->drawn[kernel].covered += covered;
}

/** The kernel for everything: fragments that pass the depth test are lit. */
glint_kernel glint_draw_any;

/** Kernels of triangles of one colour, and of those with colours at their corners. */
glint_kernel glint_draw_facet, glint_draw_unlit, glint_draw_lit;

/** Fast lighting: what a format that has it links. deviation.h. */
typedef struct glint_fast {
    int (*serves)(const glint_frame *frame, const glint_object *object);
    glint_status (*prepare)(glint_frame *frame); /* behind all shadings */
    /** Adds the bytes that a material takes at least, and its tables, which want as much room left behind them. */
    void (*need)(const glint_frame *frame, const glint_shading *shading, size_t *least, size_t *tables);
    glint_light_triangle *light;
    glint_kernel *draw;
} glint_fast;

/** Finds the colours of fragments that lie in a triangle of a draw, Q23. */
void glint_shade(const glint_frame *frame, glint_fragments *fragments, const glint_draw *draw);

/** Ambient and every light: colours of fragments with normals, rays, and colours of their own if has_surface. */
void glint_light_all(const glint_frame *frame, glint_fragments *fragments, const glint_shading *shading,
                     int has_surface);

/** A lit colour, clamped at 1, 1 = GLINT_COLOUR_ONE. */
void glint_clamp_colour(const uint32_t colour[3], int16_t out[3]);

/** Puts colours through the output tables, if there are any, and brings them to the format's levels. */
void glint_finish_colours(const glint_config *config, int32_t (*colour)[3], uint32_t count);

/** V at fragments: towards the eye for the local viewer, straight back for the infinite one. */
void glint_find_view_vectors(const glint_view *view, glint_fragments *fragments);

/** Are rays towards the eye needed under these lights? */
int glint_needs_rays(const glint_view *view, const glint_shading *shading);

/** `size` bytes from the arena's low end, aligned for pointers; null when it is full. */
void *glint_take(glint_memory *memory, size_t size);

#endif
