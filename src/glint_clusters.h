/* SPDX-License-Identifier: MIT */
/**
 * @file glint_clusters.h
 * Clusters of a mesh: what `glint convert` writes, and nothing else has to. glint.h includes this.
 */
#ifndef GLINT_CLUSTERS_H
#define GLINT_CLUSTERS_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Drops triangles that face away, many at once; a descriptor, one of those below. */
typedef struct glint_cull glint_cull;

/** Clusters whose triangles all face away, by their normals' cones. */
extern const glint_cull glint_cull_cones;

/**
 * Triangles that lie together and face much the same way, and vertices: those of a mesh follow each other as its
 * clusters do. `glint convert` makes clusters, and leaves them out with `--no-clusters`: where flash is short, or most
 * of a frame is lighting on the general path, which they do not save.
 *
 * With the eye at e, in steps, a triangle in the plane n.p = h faces away where n.e <= h. The normal n of each triangle
 * of a cluster can be scaled so that |n - axis| <= spread and h >= 256 height: where axis.e + spread |e| <= 256 height
 * all of them face away. Degenerate triangles constrain neither value.
 */
typedef struct glint_cluster {
    int8_t axis[3];     /**< As above. */
    uint8_t spread;     /**< As above. */
    int16_t height;     /**< As above. */
    uint16_t triangles; /**< Number of triangles. */
    uint16_t vertices;  /**< Number of vertices first used by this cluster. */
    uint16_t borrowers; /**< Number of other clusters with triangles at these vertices. */
} glint_cluster;

/**
 * Clusters of all triangles and vertices of a mesh. A triangle that faces away so little that rounding its corners to
 * 1/16 of a pixel turns it round is dropped with its cluster too.
 */
typedef struct glint_clusters {
    const glint_cull *cull;    /**< glint_cull_cones; null for no clusters. */
    const glint_cluster *list; /**< The clusters. */
    const uint16_t *borrowers; /**< Indices of the borrowers, cluster after cluster; an index >= count means "always
                                    visible". Null: every borrower is. */
    uint32_t count;            /**< 1 to 65536 clusters. */
} glint_clusters;

#ifdef __cplusplus
}
#endif

#endif
