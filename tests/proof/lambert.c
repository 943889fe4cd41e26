/* SPDX-License-Identifier: MIT */
/* Matt and unlit surfaces. */
#include "proof.h"

#include "../../src/light/lambert.c"
#include "../../src/light/unlit.c"
#include "lit.h"

/*
 * Any light on any fragments, whose colours leave room for it. @contract glint_dot
 * @unsigned
 * @unreached 21 specular light
 * @options -eva-slevel 0 -eva-min-loop-unroll 9
 */
PROOF(light_lambert) {
    PROVE_LIGHT(light_lambert);
}

/* Any diffuse colour. */
PROOF(prepare_unlit) {
    glint_material material;
    glint_shading shading;
    material.diffuse = (glint_colour){ANY(0, GLINT_COLOUR_MAX), ANY(0, GLINT_COLOUR_MAX), ANY(0, GLINT_COLOUR_MAX)};
    shading.material = &material;
    prepare_unlit(&shading, ANY_UNSIGNED(0, 16u << 12));
}
