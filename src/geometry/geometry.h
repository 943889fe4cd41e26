/* SPDX-License-Identifier: MIT */
/** @file geometry.h From a mesh's steps to the screen: transforms, vertices, clipping. */
#ifndef GLINT_GEOMETRY_H
#define GLINT_GEOMETRY_H

#include "../math/product.h"
#include "../scene/view.h"

/**
 * Mesh steps to the screen in products of 16 bits, for objects that are nowhere clipped, whose w differs by a factor of
 * 4 at most, and that lie within a quarter of the guard band, 256 pixels, of the screen's centre. Off by less than half
 * a sixteenth of a pixel beyond rounding, and by 2^-15 of 1/w.
 */
typedef struct glint_short_matrix {
    /* Clip coordinates of a step, 15 bits and a sign, and of step 0, 31 bits, of x and y with a half for rounding; rows
     * of x and y are times one power of two, that of w times another. */
    int32_t x[4], y[4], w[4];
    uint32_t nearest; /* of the frame, 16 bits */
    uint8_t serves;
    uint8_t shift;       /* from X / W to sixteenths, Q11, and from a reciprocal to 1/w, for a W of 31 bits */
    uint8_t depth_shift; /* the same of 1/w */
} glint_short_matrix;

/** Mesh steps to clip space, and object normals to camera space. */
typedef struct glint_transform {
    glint_row matrix[3]; /* rows x, y, w: clip coordinate of 2^15 steps */
    int32_t translation[3];
    glint_row normal[3];         /* of draws that are lit */
    int32_t exponent;            /* a clip unit is 2^-exponent */
    int32_t near_plane, least_w; /* w of the near plane, and of the nearest corner of the box */
    int32_t nearest;             /* w of the frame, no more than any of the object's that is seen; of parallel rays w */
    int32_t center_x, center_y;  /* of the screen, 28.4 and 11 bits for rounding */
    uint8_t visible, clips, mirrored;
    uint8_t skipped; /* it has nothing to draw, and is left out */
    glint_short_matrix brief;
} glint_transform;

/** A bit of glint_transform.clips: rays are parallel, and positions have their distance in place of w. */
#define GLINT_PARALLEL 2u

/** The eye among a mesh's steps, homogeneous. */
typedef struct glint_eye {
    int32_t x, y, z;  /* times weight 2^-8: 20 bits and a sign */
    int32_t distance; /* from step 0, or a little more; times the same */
    int32_t weight;   /* 13 bits */
} glint_eye;

/** Finds the eye from an object's transform. */
void glint_transform_eye(const glint_transform *transform, glint_eye *eye);

#define GLINT_VERTEX_CLIP 1u   /* in front of the near plane or outside the guard band: x, y and 1/w are not valid */
#define GLINT_VERTEX_LIT 2u    /* the vectors that it keeps are known: light/suns.c */
#define GLINT_VERTEX_NORMAL 4u /* its normal is known; until then its number in the mesh stands in attribute[0] */

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

/** Has a mesh nothing to draw? */
static inline int glint_mesh_is_empty(const glint_mesh *mesh) {
    return !mesh->vertex_count || !mesh->triangle_count;
}

/** An object's transform. Takes view->nearest as it stands. */
glint_status glint_transform_prepare(glint_transform *transform, const glint_view *view, const glint_config *config,
                                     const glint_object *object);

/** Sets an object's matrix of normals. */
void glint_transform_begin_normals(glint_transform *transform, const glint_view *view, const glint_pose *pose);

/** The part of it that needs view->nearest, anew. */
void glint_transform_place(glint_transform *transform, const glint_view *view);

/** Smallest w of the object's bounding box, Q28, no less than the near plane. */
int64_t glint_transform_nearest(const glint_transform *transform, const glint_view *view);

/**
 * May w of an object's corners differ by a factor above 8, or 1/w be so small that its differences need all their bits,
 * or are rays parallel?
 */
static inline uint8_t glint_transform_is_wide(const glint_transform *transform) {
    const int32_t least = transform->least_w, half = transform->translation[2] - least;
    return transform->clips || half / 4 > least || /* the farthest is twice the half more */
           glint_shift_right(least / 2 + half, 12) > transform->nearest;
}

/** Transforms vertices of a mesh from `first` on, all but their normals; positions may be null if nothing clips. */
typedef void glint_transform_some(const glint_transform *transform, const glint_mesh *mesh, uint32_t first,
                                  uint32_t count, glint_vertex *vertex, glint_position *position);

/** The same of those that have an array of positions. */
glint_transform_some glint_transform_array;

/** The same, given the first one's place in such an array. */
void glint_transform_steps(const glint_transform *transform, const int16_t (*p)[3], uint32_t first, uint32_t count,
                           glint_vertex *vertex, glint_position *position);

/** Screen position and 1/w of clip coordinates inside the guard band and beyond the near plane. */
void glint_project(const glint_transform *transform, const glint_position *position, glint_vertex *vertex);

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

/**
 * Twice a triangle's area in 28.4 squared; above 0 when its corners run clockwise on the screen, y down.
 * The guard band keeps it in 32 bits.
 */
static inline int32_t glint_double_area(const glint_vertex *a, const glint_vertex *b, const glint_vertex *c) {
    return (b->x - a->x) * (c->y - a->y) - (c->x - a->x) * (b->y - a->y);
}

/** Does a triangle face the eye? Not when it has no area. */
static inline int glint_faces(int mirrored, int double_sided, const glint_vertex *const v[3]) {
    int32_t area = glint_double_area(v[0], v[1], v[2]);
    return area != 0 && (double_sided || (area > 0) == mirrored);
}

#endif
