/* SPDX-License-Identifier: MIT */
/** @file meshes.h The meshes of the example scenes, and how the converter makes them; meshes.py writes the list. */
#ifndef GLINT_WEB_MESHES_H
#define GLINT_WEB_MESHES_H

#include "glint.h"

typedef struct web_mesh {
    glint_mesh *mesh;  /**< Filled when the page starts. */
    const char *words; /**< Of the converter, each ended by 0. */
    size_t size;
} web_mesh;

/** Ended by one without a mesh. */
extern const web_mesh web_meshes[];

#endif
