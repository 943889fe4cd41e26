/* SPDX-License-Identifier: MIT */
/**
 * @file import.h
 * Parts of glint-import: the files that assimp may open, materials as MTL text, and pictures of JPEG.
 */
#ifndef GLINT_IMPORT_IMPORT_H
#define GLINT_IMPORT_IMPORT_H

#include <assimp/cfileio.h>
#include <assimp/scene.h>

/**
 * Gives assimp the model and regular files of its folder and of the folders in it, to be read only. One at a time.
 * @param model the model's path, which must stay
 * @return false when the folder is not there
 */
int folder_open(struct aiFileIO *files, const char *model);

/**
 * Prints the materials of a scene on stdout, the one that assimp makes where a file has none left out. Physically based
 * ones come to Kd, Ks and Ns by the formulas in docs/assets.md; of transparency and of textures that are not of the
 * base colour there is a line, so that the reader of MTL files can warn of them.
 */
void paint_print(const struct aiScene *scene);

/** Replaces characters that a name in OBJ and MTL files cannot have. */
void paint_plain(struct aiString *name);

/** Whether a material is that of what has none. */
int paint_is_none(const struct aiScene *scene, unsigned material);

/** Prints the `usemtl` of a material, which must not be none. */
void paint_use(const struct aiScene *scene, unsigned material);

/**
 * Prints the pixels of the JPEG file on stdin. What libjpeg cannot read ends the program with status 1.
 * @return null, or what else is wrong
 */
const char *jpeg_print(void);

#endif
