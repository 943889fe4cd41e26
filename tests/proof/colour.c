/* SPDX-License-Identifier: MIT */
/* Colours: gamma, clamping, and the perspective divide. */
#include "proof.h"

#include "../../src/colour.c"
#include "../../src/gamma.c"
#include "contracts.h"
#include "pixels.h"

/* Any colour through any table. */
PROOF(glint_apply_gamma) {
    uint16_t gamma[3][GLINT_GAMMA_ENTRIES];
    uint32_t colour[1][3] = {{ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX)}};
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < GLINT_GAMMA_ENTRIES; i++)
            gamma[c][i] = (uint16_t)ANY(0, UINT16_MAX);
    glint_apply_gamma((const uint16_t(*)[GLINT_GAMMA_ENTRIES])gamma, colour, 1);
}

/*
 * Any fragment of any tile, planes of any values, and 1/w that its scale leaves in 32 bits, by its bits.
 * @unreached 1 leading zeros of 0
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(glint_resolve_colour) {
    glint_frame frame;
    glint_fragments fragments;
    glint_attributes attributes;
    int16_t out[3];
    any_planes(&attributes);
    any_tile(&frame, &fragments, 1);
    fragments.attributes = &attributes;
    FOR_PARTS(bits, 0, 32) { /* of 1/w 2^scale, which is all that is used of the two */
        fragments.scale = bits == 32;
        fragments.inverse_w[0] = (int32_t)ANY_OF_BITS(bits == 32 ? 31 : bits);
        glint_resolve_colour(&frame, &fragments, 0, attributes.main, out);
        /*@ assert \subset(out[0 .. 2], (0 .. 32767)); */
    }
    FOR_PARTS(scale, 0, 30) {
        fragments.scale = (uint32_t)scale;
        fragments.inverse_w[0] = 1;
        glint_resolve_colour(&frame, &fragments, 0, attributes.main, out);
    }
}
