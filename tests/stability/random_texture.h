/* SPDX-License-Identifier: MIT */
/** @file random_texture.h Textures of random scenes, and where on them vertices lie. */
#ifndef GLINT_STABILITY_RANDOM_TEXTURE_H
#define GLINT_STABILITY_RANDOM_TEXTURE_H

#include "glint.h"

struct source;

/** A texture, and all levels that it may have. */
typedef struct random_texture {
    glint_texture texture, levels[10];
} random_texture;

/**
 * Makes a texture of any type and size, some of them with levels, whose texels lie in memory that all share, and lets a
 * material wear it, with flags of either kind. Vertices get places on it: mostly those of a picture thrown along a
 * direction, once or several times over the mesh, else any, up to the extremes of all numbers.
 * @param coordinates room for the mesh's vertices
 */
void random_texture_dress(glint_mesh *mesh, int16_t (*coordinates)[2], glint_material *material,
                          random_texture *texture, struct source *random);

#endif
