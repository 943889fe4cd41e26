/* SPDX-License-Identifier: MIT */
/* Clusters that face away. */
#include "proof.h"

#include "../../src/frame/cull.c"
#include "ranges.h"

/*
 * Not proven: load_clusters, load, bin, corners: numbers that check adds up, and addresses in the arena. Suite
 * `identity`, and fuzzing of meshes whose clusters err, under ASan.
 */

/* Any clusters, seen from any eye. */
PROOF(face) {
    glint_cluster clusters[3];
    glint_eye eye = {ANY(-(1 << 20), 1 << 20), ANY(-(1 << 20), 1 << 20), ANY(-(1 << 20), 1 << 20),
                     ANY(-(1 << 22), 1 << 22), ANY(0, 1 << 13)};
    uint8_t away[3];
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            clusters[i].axis[j] = (int8_t)ANY(-128, 127);
        clusters[i].spread = (uint8_t)ANY(0, 255);
        clusters[i].height = ANY_SHORT;
    }
    face(&eye, clusters, 3, away);
}

/* Any counts of up to 3 clusters, and more than there may be. */
PROOF(check) {
    glint_cluster list[3];
    glint_clusters clusters = {0, ANY(0, 1) ? list : 0, 0, ANY_UNSIGNED(0, 3)};
    glint_mesh mesh;
    for (int i = 0; i < 3; i++) {
        list[i].triangles = (uint16_t)ANY(0, UINT16_MAX);
        list[i].vertices = (uint16_t)ANY(0, UINT16_MAX);
    }
    mesh.clusters = &clusters;
    mesh.triangle_count = ANY_UNSIGNED(0, UINT_MAX);
    mesh.vertex_count = ANY_UNSIGNED(0, UINT_MAX);
    check(&mesh);
    clusters.count = ANY_UNSIGNED(65537, UINT_MAX);
    check(&mesh);
}
