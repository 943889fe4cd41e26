/* SPDX-License-Identifier: MIT */
/**
 * @file materials.h
 * The materials of a model: from the names in an OBJ file to what its MTL files say, and to the library's own.
 */
#ifndef GLINT_HOST_MATERIALS_H
#define GLINT_HOST_MATERIALS_H

#include "glint.h"
#include "mesh.h"
#include "mtl.h"
#include "obj.h"

#include <stdint.h>

/** A file of materials that was read. */
typedef struct host_library {
    char *path;
    uint64_t hash; /**< FNV-1a, 64 bits, of its bytes. */
    host_warnings warnings;
} host_library;

/** Owns its arrays; zeroed it has no materials. */
typedef struct host_materials {
    mtl_library all;
    size_t *used; /**< Triangles of material i are of all.list[used[i - 1]]; those of material 0 are of none. */
    size_t used_count;
    host_library *libraries;
    size_t library_count, library_capacity;
} host_materials;

/**
 * Reads the MTL files that a model names, from its folder, and gives its triangles the materials that these define:
 * numbers that count from 1. Of several materials of one name the first holds. A name that none has leaves its
 * triangles without a material.
 * @param model the model's path
 * @param mesh its triangles are numbered as `named` has it, and then as `materials` has it
 * @param materials set, whatever it held before; the caller frees it with materials_free
 * @param warnings what is missing is added to these
 */
void materials_load(const char *model, const obj_materials *named, host_mesh *mesh, host_materials *materials,
                    host_warnings *warnings);

/**
 * Gives the triangles of a mesh the materials of `materials->all`, by the names that they have; the rest as above.
 * @param materials with no material in use
 */
void materials_name(const obj_materials *named, host_mesh *mesh, host_materials *materials, host_warnings *warnings);

/** The material of a number; null for 0. */
const mtl_material *materials_find(const host_materials *materials, uint32_t number);

/** Prints the warnings of the MTL files, a line each. */
void materials_print_warnings(const host_materials *materials);

/** Frees what materials_load made. */
void materials_free(host_materials *materials);

#endif
