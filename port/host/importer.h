/* SPDX-License-Identifier: MIT */
/**
 * @file importer.h
 * Models in other formats than OBJ, by the program glint-import (port/host/import), which is there where libassimp-dev
 * was when `make` ran. It runs under limits, and what it prints is read as any OBJ file is. Takes POSIX.
 */
#ifndef GLINT_HOST_IMPORTER_H
#define GLINT_HOST_IMPORTER_H

#include "child.h"
#include "materials.h"
#include "mesh.h"

/** Whether a file's name has an ending, and that is not .obj, in letters of either case. */
bool importer_takes(const char *name);

/**
 * Loads a model. Positions that are the same, and have the same colour, become one. The environment variable
 * GLINT_IMPORT names the program to run; else it is glint-import in the folder of this one.
 * @param mesh set up, whatever it held before; the caller frees it with mesh_free
 * @param materials set, whatever it held before; the caller frees it with materials_free
 * @param warnings set
 * @return false with a problem of line 0; nothing is then to be freed
 */
bool importer_load(const char *name, const child_limits *limits, host_mesh *mesh, host_materials *materials,
                   host_warnings *warnings, host_problem *problem);

#endif
