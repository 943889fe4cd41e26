/* SPDX-License-Identifier: MIT */
/** @file grids.h Terrains and closed rooms of random scenes: square grids of two triangles a cell. */
#ifndef GLINT_STABILITY_GRIDS_H
#define GLINT_STABILITY_GRIDS_H

#include "glint_extras.h"

/** Adds to a mesh, which may be empty, a flat terrain as wide as all steps, its front up: (cells + 1)^2 vertices. */
void grid_add_terrain(glint_mesh *mesh, const glint_mesh_room *room, uint32_t cells);

/** Adds to a mesh the six walls of a room as large as all steps, their fronts inside. */
void grid_add_room(glint_mesh *mesh, const glint_mesh_room *room, uint32_t cells);

#endif
