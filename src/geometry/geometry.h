/* SPDX-License-Identifier: MIT */
/** @file geometry.h Vertices from the steps of a mesh to the screen, clipping, and how attributes of meshes are stored.
 */
#ifndef GLINT_GEOMETRY_H
#define GLINT_GEOMETRY_H

#include "../scene/view.h"

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

/* ---- Attributes that are stored otherwise than in the arrays of a mesh ---- */

struct glint_draw;

/** Lights triangle i of a draw. */
typedef void glint_light_triangle(const glint_frame *frame, struct glint_draw *draw, const glint_transform *transform,
                                  uint32_t i);

struct glint_walk;

/** What is linked with any type of a layout. */
typedef struct glint_layout_stage {
    /** @return GLINT_ERROR_NULL, _TYPE or _STRIDE */
    glint_status (*check)(const glint_mesh *mesh);
    glint_transform_some *transform; /* of a mesh that has no array of positions */
    /** Lights a triangle of a mesh that has no array of normals. */
    glint_light_triangle *light;
    /** Corners of a triangle of a mesh that has no array of them. */
    const uint16_t *(*corners)(struct glint_walk *walk, const glint_mesh *mesh, uint32_t triangle);
    /** Takes memory for all triangles of a mesh that has no array of them. */
    const uint16_t (*(*list)(glint_frame *frame, const glint_mesh *mesh))[3];
} glint_layout_stage;

extern const glint_layout_stage glint_layouts;

/** What types serve, as bits. */
enum { GLINT_OF_POSITIONS = 1, GLINT_OF_NORMALS = 2, GLINT_OF_TRIANGLES = 4, GLINT_OF_COLOURS = 8 };

struct glint_attribute_type {
    uint8_t uses, size, alignment;
    /** Decodes `count` of them to three numbers each, as a mesh's own arrays have them; of colours, 2^15 less 1 is 1.
     */
    void (*fetch)(const uint8_t *from, size_t stride, uint32_t count, int16_t (*to)[3]);
    const glint_layout_stage *stage;
};

/** Decodes `count` of an attribute from number `first` on. */
static inline void glint_fetch(const glint_mesh_attribute *from, uint32_t first, uint32_t count, int16_t (*to)[3]) {
    const size_t stride = from->stride ? from->stride : from->type->size;
    from->type->fetch((const uint8_t *)from->data + first * stride, stride, count, to);
}

/** A position of a mesh, in steps; decoded to `fetched` where it has no array of them. */
static inline const int16_t *glint_steps_of(const glint_mesh *mesh, uint32_t index, int16_t fetched[3]) {
    if (mesh->positions)
        return mesh->positions[index];
    glint_fetch(&mesh->layout->positions, index, 1, (int16_t(*)[3])(void *)fetched);
    return fetched;
}

/** The same of a triangle's corners. */
static inline const uint16_t *glint_triangle_of(const glint_mesh *mesh, uint32_t triangle, uint16_t fetched[3]) {
    if (mesh->triangles)
        return mesh->triangles[triangle];
    glint_fetch(&mesh->layout->triangles, triangle, 1, (int16_t(*)[3])(void *)fetched);
    return fetched;
}

/** The same in a run of triangles; they stand in walk->fetched where the mesh has no array of them. */
static inline const uint16_t *glint_corners_of(struct glint_walk *walk, const glint_mesh *mesh, uint32_t triangle) {
    return mesh->triangles ? mesh->triangles[triangle]
                           : mesh->layout->triangles.type->stage->corners(walk, mesh, triangle);
}

/** What transforms a mesh's vertices. */
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

/** Have the vertices of a mesh colours of their own? */
static inline int glint_has_colours(const glint_mesh *mesh) {
    return mesh->colours || mesh->colours565 || (mesh->layout && mesh->layout->colours.type);
}

/** A channel of a vertex's own colour from 8 bits, 1 = GLINT_COLOUR_ONE; factors are 2^15 over the highest level, Q8.
 */
static inline int16_t glint_channel_from8(uint32_t level) {
    return (int16_t)(level * 32896u >> 8);
}

/** Channel c of one in RGB565. */
static inline int16_t glint_channel_from565(uint32_t packed, int c) {
    return (int16_t)(c == 1 ? (packed >> 5 & 63) * 133152u >> 8 : (packed >> (c ? 0 : 11) & 31) * 1057u);
}

#endif
