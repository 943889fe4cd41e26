/* SPDX-License-Identifier: MIT */
/**
 * @file folder.h
 * Files as assimp opens them: the model, and regular files of its folder and of the folders in it, to be read only.
 */
#ifndef GLINT_IMPORT_FOLDER_H
#define GLINT_IMPORT_FOLDER_H

#include <assimp/cfileio.h>

/**
 * Gives assimp the files of a model's folder, and no others. One at a time.
 * @param model the model's path, which must stay
 * @return false when the folder is not there
 */
int folder_open(struct aiFileIO *files, const char *model);

#endif
