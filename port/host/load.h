/* SPDX-License-Identifier: MIT */
/**
 * @file load.h
 * A model by its name on the command line: a file or a generated shape.
 */
#ifndef GLINT_HOST_LOAD_H
#define GLINT_HOST_LOAD_H

#include "child.h"
#include "materials.h"
#include "mesh.h"
#include "problem.h"
#include "quantise.h"

/** What becomes of a model when it is loaded. */
typedef struct load_options {
    double crease; /**< As for mesh_average_normals. */
    mesh_weights weights;
    bool facets;          /**< Facet normals in place of averages. */
    bool repair;          /**< Turn triangles that are wound the wrong way. */
    quantise_types types; /**< How the mesh is stored. */
    bool plain;           /**< Without clusters, in the order of the model. */
    double weld;          /**< Distance within which positions become one; below 0 for not at all. */
    size_t simplify;      /**< Most triangles; 0 for as many as there are. */
    child_limits import;  /**< For what reads other formats than OBJ. */
} load_options;

/** A model with normals at every corner. */
typedef struct host_model {
    host_mesh mesh;
    host_materials materials; /**< As the triangles number them. */
    uint64_t hash;            /**< FNV-1a, 64 bits, of the file's bytes, or of a shape's name. */
    size_t corner_count;      /**< Corners of all triangles... */
    size_t given_normals;     /**< ...and those of them whose normal came with the model. */
    size_t welded_count;      /**< Positions that became one with others. */
    size_t read_count;        /**< Triangles before the model was simplified... */
    double error;             /**< ...and by how much it moved, in the file's units. */
    size_t turned_count;      /**< Triangles turned by the repair. */
    host_warnings warnings;
    double low[3], high[3]; /**< Its box, as options have it (place.h). */
    double fit;             /**< By what it was then scaled to fit; 1 for not at all. */
    host_problem note;      /**< That says so; empty for not at all. */
} host_model;

/**
 * Loads a model and makes the normals that are missing.
 * @return false with a problem; nothing is then to be freed, else the model with model_free
 */
bool load_model(const char *name, const load_options *options, host_model *model, host_problem *problem);

/** Frees what load_model made. */
void model_free(host_model *model);

#endif
