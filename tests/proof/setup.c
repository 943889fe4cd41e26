/* SPDX-License-Identifier: MIT */
/* Set-up of a triangle's planes. */
#include "proof.h"

#include "../../src/setup.c"
#include "contracts.h"

/*
 * Wide gradients of up to 2^30, values of corners up to 2^30 either way or 1/w.
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 * @unreached 1 narrow ones: differences have 15 bits by the choice of `up`, a relation; suite `setup`, under UBSan too
 */
PROOF(glint_plane_begin) {
    const int32_t most = 1 << 30;
    glint_plane plane;
    glint_gradients g;
    g.reach = 0;
    g.reciprocal = 0;
    g.to_center_x = ANY(-7, 8);
    g.to_center_y = ANY(-7, 8);
    g.x1 = ANY(-most, most);
    g.y1 = ANY(-most, most);
    g.x2 = ANY(-most, most);
    g.y2 = ANY(-most, most);
    FOR_PARTS(shift, -5, 27) {
        g.shift = (int32_t)shift;
        glint_plane_begin(&plane, &g, ANY(-most + 1, most - 1), ANY(-most + 1, most - 1), ANY(-most + 1, most - 1));
        glint_plane_begin(&plane, &g, ANY(0, 0x7fff0000), ANY(0, 0x7fff0000), ANY(0, 0x7fff0000));
    }
}
