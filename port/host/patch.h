/* SPDX-License-Identifier: MIT */
/**
 * @file patch.h
 * Cuts a mesh into patches: triangles that hang together by edges and face much the same way.
 */
#ifndef GLINT_HOST_PATCH_H
#define GLINT_HOST_PATCH_H

#include "glint.h"

#include <stdbool.h>

/** No triangle, no patch. */
#define PATCH_NONE UINT32_MAX

/** Length of a triangle's direction. */
#define PATCH_DIRECTION_ONE 1048576.0

/** What a patch costs, in triangles that are drawn for nothing half of the time. */
#define PATCH_COST 1.5

/** Most triangles of a patch. */
#define PATCH_TRIANGLES_MAX 64

/** Triangles, as a list: the patch is named by its first one, which is its lowest. */
typedef struct triangle_patch {
    uint32_t last;    /**< Triangle of the list. */
    uint32_t count;   /**< Of triangles; 0 where this triangle is not the lowest of its patch. */
    uint32_t version; /**< How often it grew. */
    int64_t sum[3];   /**< Of the triangles' directions. */
    int64_t loss;     /**< Triangles times the sine of their spread. */
} triangle_patch;

/** A mesh's patches. Owns its arrays. */
typedef struct mesh_patches {
    const glint_mesh *mesh;
    int32_t (*directions)[3]; /**< Normals of the triangles, PATCH_DIRECTION_ONE long; 0 for those without area. */
    uint32_t *opposite;       /**< Of half edge 3 * triangle + corner: the next on the same edge, or itself. */
    uint32_t *patch_of;       /**< Of each triangle. */
    uint32_t *next;           /**< Triangle of the same patch, or PATCH_NONE. */
    triangle_patch *patches;  /**< Of each triangle. */
} mesh_patches;

/** Cuts a mesh into patches. */
void patch_mesh(const glint_mesh *mesh, mesh_patches *out);

/** Frees what patch_mesh made. */
void patch_free(mesh_patches *patches);

/** Normal of a triangle's plane in steps, unit length. @return false for a triangle without area */
bool patch_normal(const glint_mesh *mesh, uint32_t triangle, double unit[3]);

/** Of a patch's triangles with area, the one that is turned farthest from `vector`; or PATCH_NONE. */
uint32_t patch_farthest(const mesh_patches *patches, uint32_t patch, const int64_t vector[3]);

/** Length of a sum of directions. */
double patch_length(const int64_t sum[3]);

#endif
