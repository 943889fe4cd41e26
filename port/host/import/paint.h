/* SPDX-License-Identifier: MIT */
/**
 * @file paint.h
 * Materials of a scene of assimp as MTL text.
 */
#ifndef GLINT_IMPORT_PAINT_H
#define GLINT_IMPORT_PAINT_H

#include <assimp/scene.h>

/**
 * Prints the materials of a scene on stdout, the one that assimp
 * makes where a file has none left out. Physically based ones come to Kd, Ks and Ns by the formulas in
 * docs/assets.md; of textures and transparency there is a line, so that the reader of MTL files can warn of them.
 */
void paint_print(const struct aiScene *scene);

/** Whether a material is that of what has none. */
int paint_is_none(const struct aiScene *scene, unsigned material);

/** Prints the `usemtl` of a material, which must not be none. */
void paint_use(const struct aiScene *scene, unsigned material);

#endif
