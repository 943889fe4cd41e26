/* SPDX-License-Identifier: MIT */
/* Blinn and Phong's model. */
#include "proof.h"

#include "../../src/light/blinn_phong.c"
#include "lit.h"

/*
 * Any light on any fragments, whose colours leave room for it. @contract glint_dot glint_unit glint_specular_power
 * @unsigned
 * @alarms 4 |N . (L + V)| <= |N| (|L| + |V|), at most 2^15 (2 32766.3) < 2^31: the image tests under UBSan
 * @unreached 1 what matt models do
 * @options -eva-slevel 0 -eva-min-loop-unroll 9
 */
PROOF(light_blinn_phong) {
    PROVE_LIGHT(light_blinn_phong);
}
