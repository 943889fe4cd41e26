/* SPDX-License-Identifier: MIT */
/* Colours: gamma, clamping, and the perspective divide. */
#include "proof.h"

#include "../../src/colour.c"
#include "../../src/gamma.c"
#include "contracts.h"

/* Any colour through any table. */
PROOF(glint_apply_gamma) {
    uint16_t gamma[3][GLINT_GAMMA_ENTRIES];
    uint32_t colour[1][3] = {{ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX)}};
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < GLINT_GAMMA_ENTRIES; i++)
            gamma[c][i] = (uint16_t)ANY(0, UINT16_MAX);
    glint_apply_gamma((const uint16_t(*)[GLINT_GAMMA_ENTRIES])gamma, colour, 1);
}
