/* SPDX-License-Identifier: MIT */
/** @file draw.h A pass draws objects, or runs of their triangles. This header has them, the triangles that clipping
 * makes, and the room that these need. */
#ifndef GLINT_DRAW_H
#define GLINT_DRAW_H

#include "../scene/arena.h"
#include "geometry.h"

struct glint_triangle;
struct glint_part;
struct glint_shading;

/**
 * A colour in the levels of a format is two words that are interpolated: one has blue in its high half and red in its
 * low half, the other has green. The high bits of each half, and of the whole word of green, are the level, as many as
 * the format has for the channel; the rest is its fraction. Formats of luma have luma in place of green. Half a level
 * or a threshold of dithering is added to a colour before it is cut off, and never carries into the next channel.
 */
typedef struct glint_lanes {
    uint32_t red_blue, green;
} glint_lanes;

struct glint_row_walk;

/** Draws the pixels of a row of the tile from column `left` to before `right`; there is at least one. */
typedef void glint_draw_span(struct glint_row_walk *walk, int32_t row, int32_t left, int32_t right);

/** Hidden fragments should not be begun; and slopes serve triangles that are not small (raster/triangle.h). */
enum { GLINT_ARE_COSTLY = 1, GLINT_HAVE_LONG_SLOPES = 2 };

/** A draw is an object, or a part of its triangles. */
typedef struct glint_draw {
    struct glint_draw *next;
    glint_position *positions; /* null unless the object may be clipped or is lit before it is drawn */
    int16_t (*extra)[3];       /* null, or per vertex: the surface's colour, or the back's colour when lit */
    int16_t (*facets)[3];      /* null, or the levels of the triangles' colours */
    uint8_t *away; /* null, or which of the clusters face away, 1 or 0; not of parts, which leave their triangles out */
    const uint16_t *origin;         /* of parts: the numbers of their triangles, from the first on */
    const uint16_t (*triangles)[3]; /* indices of the first triangle; what stands before them begins as 0 */
    glint_vertex *vertices;
    struct glint_sun_term *terms; /* what vertices keep of lights: light/suns.h */
    const int16_t (*normals)[3];  /* of the mesh */
    const glint_cull *cull;       /* what drops the mesh's clusters, or null */
    const struct glint_shading *shading;
    const glint_evaluation *evaluation;
    const glint_texture *texture;                       /* that it wears, or null */
    glint_light_triangle *light;                        /* lights a triangle before it is drawn, or null */
    void (*draw_triangle)(struct glint_row_walk *walk); /* draws the part of a triangle that lies in a tile */
    uint32_t vertex_count;
    uint32_t unreached;      /* lights of its shading that do not reach it, by bits */
    uint32_t object;         /* index in the scene */
    uint32_t first_triangle; /* all triangles of the mesh are from this on, */
    uint32_t end;            /* and before this */
    uint16_t first;          /* number in the pass of its first triangle */
    uint16_t count;
    uint8_t mirrored, double_sided;
    uint8_t is_wide;   /* whether 1/w of a triangle may differ by a factor above 8, or rays are parallel */
    uint8_t fragments; /* GLINT_ARE_COSTLY and GLINT_HAVE_LONG_SLOPES, or 0 where none are lit */
    glint_lanes flat;  /* of objects of one colour: the colour, and its pixel */
    uint32_t packed;
    glint_transform transform;
} glint_draw;

/** Returns the object that a frame draws at a place of its order. */
static inline const glint_object *glint_object_at(const glint_frame *frame, uint32_t place) {
    return &frame->scene->objects[frame->order ? frame->order[place] : place];
}

/** Samples are drawn as the pixels of a frame of twice the width and height. All that is public counts pixels. */
struct glint_sampling {
    /** Makes a configuration that has been checked one of samples, without `samples`. */
    void (*enlarge)(glint_config *config);
    /** Makes a tile of samples of the background's pixels. */
    void (*spread)(const glint_frame *frame, void *pixels);
    /** Makes pixels of a tile's samples. */
    void (*average)(const glint_frame *frame, void *pixels);
    /** Makes the depth of pixels of that of samples. */
    void (*keep_nearest)(const glint_frame *frame, uint16_t *depth);
};

/** Returns the binary logarithm of samples a pixel. */
static inline unsigned glint_sample_bits(const glint_config *config) {
    return config->samples ? 2 : 0;
}

/** Returns that of samples a pixel in x, and in y. */
static inline unsigned glint_sample_shift(const glint_frame *frame) {
    return frame->samples != 0;
}

/** Brings a vertex's normal to camera space. */
void glint_transform_normal(const glint_draw *draw, glint_vertex *vertex);

/** Brings the normals of a triangle's corners to camera space, unless they are. */
glint_light_triangle glint_transform_normals;

/** Clipping makes triangles of this kind. */
typedef struct glint_clipped {
    glint_vertex corners[3];
    int16_t extra[3][3];
    uint16_t triangle; /* of the draw */
    const glint_draw *draw;
} glint_clipped;

/** A type so marked has two halves that are stored and loaded as one word. */
#if defined(__GNUC__)
#define GLINT_WORD __attribute__((aligned(4)))
#else
#define GLINT_WORD
#endif

/**
 * A reference is a triangle in a tile's list, by its number: draws number theirs from 0 up, clipped ones are numbered
 * from GLINT_CLIPPED_TOP down. The first reference of a list is its tile's. It has no triangle, but the number of the
 * last reference of the list, its own where the list is empty.
 */
typedef struct GLINT_WORD glint_reference {
    uint16_t next; /* number of the next reference, or GLINT_LIST_END */
    uint16_t triangle;
} glint_reference;

#define GLINT_LIST_END 0xffffu
#define GLINT_CLIPPED_TOP 0xfffeu

/** A pass has at most so many triangles of draws. Higher numbers are left to clipped triangles. */
#define GLINT_TRIANGLES_MAX 0xe000u

/** With so many free bytes any triangle can be binned into one tile. */
#define GLINT_BIN_RESERVE                   \
    GLINT_ALIGNED(sizeof(glint_reference) + \
                  (GLINT_CLIP_CORNERS - 2) * (sizeof(glint_reference) + sizeof(glint_clipped)))

/** With so many bytes beyond what is prepared any scene can be drawn: a part of one triangle, and its bin. */
#define GLINT_LEAST_ROOM                                                                                        \
    (GLINT_ALIGNED(sizeof(glint_draw)) + GLINT_ALIGNED(3 * sizeof(glint_vertex)) +                              \
     GLINT_ALIGNED(3 * sizeof(glint_position)) + GLINT_ALIGNED(24 * GLINT_LIGHTS_MAX) + 2 * GLINT_ALIGNED(36) + \
     2 * GLINT_ALIGNED(12) + GLINT_ALIGNED(8) + GLINT_ALIGNED(6) + GLINT_BIN_RESERVE)

/** Returns the bytes that have to be free behind tables of a size: for any scene, light at a triangle's nodes, and some
 * more. */
static inline size_t glint_room_behind_tables(size_t tables) {
    return GLINT_LEAST_ROOM + 512 + tables / 4;
}

#endif
