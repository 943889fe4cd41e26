/* SPDX-License-Identifier: MIT */
/**
 * @file shapes.h
 * Generated meshes with names such as `torus:24x12`, taken wherever a model file is.
 */
#ifndef GLINT_HOST_SHAPES_H
#define GLINT_HOST_SHAPES_H

#include "mesh.h"
#include "problem.h"

/** What can be generated. */
typedef struct host_shape {
    const char *name; /**< What stands before the colon. */
    const char *help; /**< The sizes and what they mean, in a few words. */
    int least[2];     /**< Smallest value of each size. */
    int most;         /**< Largest value of either. */
    void (*make)(host_mesh *mesh, int nu, int nv);
} host_shape;

/** All shapes, ended by one without a name. */
extern const host_shape host_shapes[];

/** The shape that a model's name begins with, or null when it is a file's name. */
const host_shape *shape_find(const char *name);

/** Generates the mesh of a name that shape_find knows. @return false with a problem when the sizes are bad */
bool shape_make(const host_shape *shape, const char *name, host_mesh *mesh, host_problem *problem);

#endif
