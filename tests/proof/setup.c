/* SPDX-License-Identifier: MIT */
/* Set-up of a triangle's planes. */
#include "proof.h"

#include "../../src/setup.c"
#include "contracts.h"

/*
 * Any area above 0, by its bits, and corners in the guard band of any screen: 28.4, from -16360 to 24560.
 * @contract glint_reciprocal
 * @unreached 2 an area of 0
 */
PROOF(gradients_begin) {
    glint_vertex v[3];
    glint_gradients g;
    const glint_vertex *const corners[3] = {&v[0], &v[1], &v[2]};
    for (int i = 0; i < 3; i++) {
        v[i].x = (int16_t)ANY(-16360, 24560);
        v[i].y = (int16_t)ANY(-16360, 24560);
    }
    FOR_PARTS(bits, 1, 31) {
        gradients_begin(&g, corners, (int32_t)ANY_OF_BITS(bits));
    }
}

/*
 * Gradients of up to 2^30, values of corners up to 2^30 either way or 1/w.
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(glint_plane_begin) {
    const int32_t most = 1 << 30;
    glint_plane plane;
    glint_gradients g;
    g.x1 = ANY(-most, most);
    g.y1 = ANY(-most, most);
    g.x2 = ANY(-most, most);
    g.y2 = ANY(-most, most);
    g.to_center_x = ANY(-7, 8);
    g.to_center_y = ANY(-7, 8);
    FOR_PARTS(shift, 11, 42) {
        g.shift = (unsigned)shift;
        glint_plane_begin(&plane, &g, ANY(-most + 1, most - 1), ANY(-most + 1, most - 1), ANY(-most + 1, most - 1));
        glint_plane_begin(&plane, &g, ANY(0, 0x7fff0000), ANY(0, 0x7fff0000), ANY(0, 0x7fff0000));
    }
}
