/* SPDX-License-Identifier: MIT */
/** @file random_layers.h Objects of random scenes that are not opaque, and fog. */
#ifndef GLINT_STABILITY_RANDOM_LAYERS_H
#define GLINT_STABILITY_RANDOM_LAYERS_H

#include "glint.h"
#include "source.h"

/**
 * Lets half of a scene's objects blend, in any order, and one scene of two have fog, about as far as its first object
 * or of extreme depths. Integers only: the same on every machine.
 * @param objects,materials those of the scene
 * @param fog room for it
 */
void random_layers_add(glint_scene *scene, glint_object *objects, glint_material *materials, glint_fog *fog,
                       source *random);

#endif
