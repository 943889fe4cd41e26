/* SPDX-License-Identifier: MIT */
/** @file geometry.h Brings vertices from the steps of a mesh to the screen, clips triangles, and decodes attributes of
 * meshes. */
#ifndef GLINT_GEOMETRY_H
#define GLINT_GEOMETRY_H

#include "../scene/view.h"

#define GLINT_VERTEX_CLIP 1u   /* in front of the near plane or outside the guard band: x, y and 1/w are not valid */
#define GLINT_VERTEX_LIT 2u    /* the vectors that it keeps are valid: light/suns.c */
#define GLINT_VERTEX_NORMAL 4u /* its normal is in camera space; until then attribute[0] is its number in the mesh */

typedef struct glint_vertex {
    int32_t inverse_w;    /* Q31 */
    int16_t x, y;         /* 28.4 */
    int16_t attribute[3]; /* unit normal in camera space; once lit, colour, 1 = GLINT_COLOUR_ONE */
    uint16_t flags;
} glint_vertex;

/** Full brightness of a colour in int16 is this. */
#define GLINT_COLOUR_ONE 32767

/** Clip coordinates are kept only where an object may have to be clipped. */
typedef struct glint_position {
    int32_t x, y, w;
} glint_position;

/** Transforms vertices of a mesh from `first` on, all but their normals; positions may be null if nothing clips. */
typedef void glint_transform_some(const glint_transform *transform, const glint_mesh *mesh, uint32_t first,
                                  uint32_t count, glint_vertex *vertex, glint_position *position);

/** Transforms vertices of a mesh that has an array of positions. */
glint_transform_some glint_transform_array;

/** Transforms vertices whose positions are given: `p` is the place of the first. */
void glint_transform_steps(const glint_transform *transform, const int16_t (*p)[3], uint32_t first, uint32_t count,
                           glint_vertex *vertex, glint_position *position);

/** Finds the screen position and 1/w of clip coordinates inside the guard band and beyond the near plane. */
void glint_project(const glint_transform *transform, const glint_position *position, glint_vertex *vertex);

/** A clipped triangle has at most so many corners: each of 5 planes adds one. */
#define GLINT_CLIP_CORNERS 8

/** A corner is on its way through clipping. */
typedef struct glint_corner {
    glint_position position;
    int16_t attribute[6]; /* a vertex's attribute and its extra one; normals get shorter where interpolated */
} glint_corner;

/**
 * Clips a triangle at the near plane and the guard band.
 * @param corners the triangle in, the polygon out
 * @return corners of the polygon: 0, or 3 to 8
 */
int glint_clip(const glint_transform *transform, glint_corner corners[GLINT_CLIP_CORNERS]);

/** Returns twice a triangle's area in 28.4 squared, above 0 when its corners run clockwise on the screen, y down. The
 * guard band keeps it in 32 bits. */
static inline int32_t glint_double_area(const glint_vertex *a, const glint_vertex *b, const glint_vertex *c) {
    return (b->x - a->x) * (c->y - a->y) - (c->x - a->x) * (b->y - a->y);
}

/** Does a triangle face the eye? A triangle without area does not. */
static inline int glint_faces(int mirrored, int double_sided, const glint_vertex *const v[3]) {
    int32_t area = glint_double_area(v[0], v[1], v[2]);
    return area != 0 && (double_sided || (area > 0) == mirrored);
}

/* ---- Attributes that are stored otherwise than in the arrays of a mesh ---- */

struct glint_draw;

/** Lights triangle i of a draw. */
typedef void glint_light_triangle(const glint_frame *frame, struct glint_draw *draw, const glint_transform *transform,
                                  uint32_t i);

struct glint_walk;

/** This stage is linked with any type of a layout. */
typedef struct glint_layout_stage {
    /** Checks the layout of a mesh. @return GLINT_ERROR_NULL, _TYPE or _STRIDE */
    glint_status (*check)(const glint_mesh *mesh);
    glint_transform_some *transform; /* of a mesh that has no array of positions */
    /** Lights a triangle of a mesh that has no array of normals. */
    glint_light_triangle *light;
    /** Finds the corners of a triangle of a mesh that has no array of triangles. */
    const uint16_t *(*corners)(struct glint_walk *walk, const glint_mesh *mesh, uint32_t triangle);
    /** Takes memory for all triangles of such a mesh, and decodes them. */
    const uint16_t (*(*list)(glint_frame *frame, const glint_mesh *mesh))[3];
} glint_layout_stage;

extern const glint_layout_stage glint_layouts;

/** These bits say which attributes a type serves. */
enum { GLINT_OF_POSITIONS = 1, GLINT_OF_NORMALS = 2, GLINT_OF_TRIANGLES = 4, GLINT_OF_COLOURS = 8 };

struct glint_attribute_type {
    uint8_t uses, size, alignment;
    /** Decodes `count` attributes to three numbers each, as the arrays of a mesh have them. 1 of a colour is 2^15 -
     * 1. */
    void (*fetch)(const uint8_t *from, size_t stride, uint32_t count, int16_t (*to)[3]);
    const glint_layout_stage *stage;
};

/** Decodes `count` of an attribute from number `first` on. */
static inline void glint_fetch(const glint_mesh_attribute *from, uint32_t first, uint32_t count, int16_t (*to)[3]) {
    const size_t stride = from->stride ? from->stride : from->type->size;
    from->type->fetch((const uint8_t *)from->data + first * stride, stride, count, to);
}

/** Returns a position of a mesh, in steps; decoded to `fetched` where the mesh has no array of positions. */
static inline const int16_t *glint_steps_of(const glint_mesh *mesh, uint32_t index, int16_t fetched[3]) {
    if (mesh->positions)
        return mesh->positions[index];
    glint_fetch(&mesh->layout->positions, index, 1, (int16_t(*)[3])(void *)fetched);
    return fetched;
}

/** Returns a triangle's corners, decoded to `fetched` where the mesh has no array of triangles. */
static inline const uint16_t *glint_triangle_of(const glint_mesh *mesh, uint32_t triangle, uint16_t fetched[3]) {
    if (mesh->triangles)
        return mesh->triangles[triangle];
    glint_fetch(&mesh->layout->triangles, triangle, 1, (int16_t(*)[3])(void *)fetched);
    return fetched;
}

/** Returns the corners of the next triangle of a run, in walk->fetched where the mesh has no array of triangles. */
static inline const uint16_t *glint_corners_of(struct glint_walk *walk, const glint_mesh *mesh, uint32_t triangle) {
    return mesh->triangles ? mesh->triangles[triangle]
                           : mesh->layout->triangles.type->stage->corners(walk, mesh, triangle);
}

/** Returns the function that transforms a mesh's vertices. */
static inline glint_transform_some *glint_transform_of(const glint_mesh *mesh) {
    return mesh->positions ? glint_transform_array : mesh->layout->positions.type->stage->transform;
}

/** Transforms vertices of any mesh. */
static inline void glint_transform_vertices(const glint_transform *transform, const glint_mesh *mesh, uint32_t first,
                                            uint32_t count, glint_vertex *vertex, glint_position *position) {
    if (mesh->positions)
        glint_transform_array(transform, mesh, first, count, vertex, position);
    else
        mesh->layout->positions.type->stage->transform(transform, mesh, first, count, vertex, position);
}

/** Do the vertices of a mesh have colours of their own? */
static inline int glint_has_colours(const glint_mesh *mesh) {
    return mesh->colours || mesh->colours565 || (mesh->layout && mesh->layout->colours.type);
}

/** Converts a channel of a vertex's colour from 8 bits, 1 = GLINT_COLOUR_ONE. The factor is 2^15 over the highest
 * level, Q8. */
static inline int16_t glint_channel_from8(uint32_t level) {
    return (int16_t)(level * 32896u >> 8);
}

/** Converts channel c of a vertex's colour from RGB565, likewise. */
static inline int16_t glint_channel_from565(uint32_t packed, int c) {
    return (int16_t)(c == 1 ? (packed >> 5 & 63) * 133152u >> 8 : (packed >> (c ? 0 : 11) & 31) * 1057u);
}

#endif
