/* SPDX-License-Identifier: MIT */
/**
 * @file cluster.h
 * Groups the triangles of a mesh into clusters (glint_cluster), so that those that face away are dropped together.
 */
#ifndef GLINT_HOST_CLUSTER_H
#define GLINT_HOST_CLUSTER_H

#include "glint.h"

/**
 * Gives a mesh clusters: puts its triangles and vertices into their order, which draws the same, and sets `clusters`.
 * Leaves a mesh as it is where clusters would not pay: one of few triangles, of triangles that all face much the same
 * way, or drawn from both sides.
 * @param mesh without clusters; what it points to must be the caller's to write
 */
void cluster_mesh(glint_mesh *mesh);

/** Frees what cluster_mesh made. */
void cluster_free(glint_mesh *mesh);

#endif
