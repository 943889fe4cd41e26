/* SPDX-License-Identifier: MIT */
/* Clusters that face away. */
#include "proof.h"

#include "../../src/cull.c"
#include "ranges.h"

/*
 * Not proven: load_clusters, load, bin, corners: numbers that find_eye adds up, and addresses in the arena. `make fuzz`
 * draws meshes whose clusters err under sanitizers.
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
