/* SPDX-License-Identifier: MIT */
/**
 * @file shapes.h
 * The library's generators under names such as `torus:24x12` or `cone:32x4:1,2`, taken wherever a model file is: a
 * name, its counts unless it has none, and its sizes unless they are the usual ones.
 */
#ifndef GLINT_HOST_SHAPES_H
#define GLINT_HOST_SHAPES_H

#include "glint_extras.h"
#include "mesh.h"
#include "problem.h"

/** Most sizes of a shape. */
#define SHAPE_SIZES_MAX 3

/** What can be generated. */
typedef struct host_shape {
    const char *name;    /**< What stands before the first colon. */
    const char *syntax;  /**< What stands after the name. */
    const char *help;    /**< What counts and sizes mean, in a few words. */
    uint32_t least[2];   /**< Smallest value of each count; 0 when the shape has none. */
    uint32_t size_count; /**< How many sizes it has. */
    double sizes[SHAPE_SIZES_MAX];
    /** Calls the generator; what it returns is the library's. */
    glint_status (*generate)(glint_mesh *mesh, const glint_mesh_room *room, const uint32_t counts[2],
                             const glint_q16 sizes[SHAPE_SIZES_MAX]);
} host_shape;

/** All shapes, ended by one without a name. */
extern const host_shape host_shapes[];

/** The shape that a model's name begins with, or null when it is a file's name. */
const host_shape *shape_find(const char *name);

/**
 * Generates the mesh of a name that shape_find knows, and reads it back.
 * @return false with a problem when counts or sizes are bad; nothing is then to be freed
 */
bool shape_make(const host_shape *shape, const char *name, host_mesh *mesh, host_problem *problem);

#endif
