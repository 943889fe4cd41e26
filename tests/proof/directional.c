/* SPDX-License-Identifier: MIT */
/* Directional lights. */
#include "proof.h"

#include "../../src/light/directional.c"
#include "ranges.h"

/* Any direction, any camera; H never points away from the eye. @contract glint_direction_to_camera glint_unit */
PROOF(prepare_directional) {
    glint_view view;
    glint_light light;
    glint_prepared_light prepared;
    any_view(&view);
    light.vector = (glint_vector){ANY_INT, ANY_INT, ANY_INT};
    if (prepare_directional(&light, &prepared, &view) == GLINT_OK) {
        /*@ assert prepared.half_vector[2] >= 0; */
    }
}
