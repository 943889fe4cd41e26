/* SPDX-License-Identifier: MIT */
/** @file cull.h Clusters of triangles that face away. */
#ifndef GLINT_CULL_H
#define GLINT_CULL_H

#include "../geometry/draw.h"

struct glint_bin_pass;

/** A mesh's clusters, one after the other. */
typedef struct glint_walk {
    glint_eye eye;
    const glint_cluster *cluster; /* the next */
    uint32_t end;                 /* its first triangle */
    uint8_t away;                 /* does the last one face away? */
    uint16_t fetched[3];          /* corners of a triangle that the mesh has no array of */
} glint_walk;

/** What is linked where meshes have clusters. */
struct glint_cull {
    /** @return GLINT_ERROR_NULL where there is no list, GLINT_ERROR_MESH where clusters do not add up to the mesh */
    glint_status (*check)(const glint_mesh *mesh);
    /** Loads the vertices of a draw of all that is left of a mesh. */
    void (*load)(glint_frame *frame, glint_draw *draw, const glint_mesh *mesh);
    /** glint_bin_some of all from `next` on, but for clusters that face away. */
    int (*bin)(struct glint_bin_pass *pass, glint_draw *draw, uint32_t next);
    /** Begins a run of triangles. */
    void (*begin)(glint_walk *walk, const glint_mesh *mesh, const glint_transform *transform);
    /** Corners of a run's triangles, in order: all the same where a cluster faces away. */
    const uint16_t *(*corners)(glint_walk *walk, const glint_mesh *mesh, uint32_t triangle);
};

/** What drops a mesh's clusters; null where it has none. */
static inline const glint_cull *glint_cull_of(const glint_mesh *mesh) {
    return mesh->clusters ? mesh->clusters->cull : 0;
}

#endif
