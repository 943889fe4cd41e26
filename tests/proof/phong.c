/* SPDX-License-Identifier: MIT */
/* Phong's model. */
#include "proof.h"

#include "../../src/light/phong.c"
#include "lit.h"

/*
 * Any light on any fragments, whose colours leave room for it.
 * @contract glint_dot glint_unit glint_specular_power glint_twice_over_square
 * @narrowing R is found modulo 2^32: at most 1.001 2^30
 * @unreached 1 what matt models do
 * @options -eva-slevel 0 -eva-min-loop-unroll 9
 */
PROOF(light_phong) {
    PROVE_LIGHT(light_phong);
}
