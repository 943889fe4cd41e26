/* SPDX-License-Identifier: MIT */
/** @file checks.h What the host's readers promise of what they give, whatever they were given. */
#ifndef GLINT_FUZZ_CHECKS_H
#define GLINT_FUZZ_CHECKS_H

#include "mesh.h"
#include "model.h"
#include "source.h"

/** One line of printable characters. */
void check_problem(const host_problem *problem);

/** Warnings, each of a line from `least_line` on. */
void check_warnings(const host_warnings *warnings, size_t least_line);

/** What a reader of materials keeps is in range. */
void check_materials(const mtl_library *library);

/**
 * A mesh as it was read, colours included: normals can be made for it, its topology be told, it quantises into
 * meshes, with clusters, as the library documents them, or ends in a problem, and its winding is repaired. Its normals
 * are others then.
 */
void check_mesh(host_mesh *mesh);

#endif
