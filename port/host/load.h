/* SPDX-License-Identifier: MIT */
/**
 * @file load.h
 * A model by its name on the command line: an OBJ file or a generated shape.
 */
#ifndef GLINT_HOST_LOAD_H
#define GLINT_HOST_LOAD_H

#include "mesh.h"
#include "problem.h"

/** A model with normals at every corner. */
typedef struct host_model {
    host_mesh mesh;
    uint64_t hash;        /**< FNV-1a, 64 bits, of the file's bytes, or of a shape's name. */
    size_t corner_count;  /**< Corners of all triangles... */
    size_t given_normals; /**< ...and those of them whose normal came with the model. */
} host_model;

/**
 * Loads a model and makes the normals that are missing.
 * @param crease as for mesh_make_normals
 * @return false with a problem; nothing is then to be freed, else the mesh
 */
bool load_model(const char *name, double crease, host_model *model, host_problem *problem);

#endif
