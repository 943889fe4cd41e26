/* SPDX-License-Identifier: MIT */
/**
 * @file undropped.h
 * Twins of the library's models and of its kernels for RGB565 that drop nothing: what faces away is lit by nothing,
 * what lies outside a highlight is looked up in its table, and where more than one light shows, so do those of weight
 * 0. The image is the same to the bit, or the library drops what shows. Their loops are the library's own, or like
 * them, so that the instructions they take more are those that dropping saves. Error budgets are not for them.
 */
#ifndef GLINT_UNDROPPED_H
#define GLINT_UNDROPPED_H

#include "glint.h"

/** Most objects of a scene. */
#define UNDROPPED_OBJECTS_MAX 32

/** How often the library would have dropped something; counted since the program began, but not in firmware. */
typedef struct undropped_drops {
    uint32_t lightings;          /**< Fragments and vertices lit by the models, once for each light. */
    uint32_t facing_away;        /**< Of these, those that face away from the light. */
    uint32_t out_of_reach;       /**< Of the others, those that a light with a position or a cone does not reach. */
    uint32_t no_highlight;       /**< Of the others, those that lie outside a highlight. */
    uint32_t no_specular;        /**< Materials without specular light. */
    uint32_t parts_ambient;      /**< Parts of triangles that face away all over, drawn in one colour. */
    uint32_t parts_matt;         /**< Parts outside the highlight, drawn without it. */
    uint32_t parts_interpolated; /**< The same, of those whose lighting is interpolated. */
    uint32_t squares_matt;       /**< Squares of triangles outside the highlight, drawn without it. */
} undropped_drops;

extern undropped_drops undropped;

/** A scene whose materials have the twins; not to be moved once made. */
typedef struct undropped_scene {
    glint_scene scene;
    glint_object objects[UNDROPPED_OBJECTS_MAX];
    glint_material materials[UNDROPPED_OBJECTS_MAX];
} undropped_scene;

/** Makes the twin of a scene. @return 0 when it has too many objects. */
int undropped_make(undropped_scene *twin, const glint_scene *scene);

/** The twin of a format: of RGB565, its own; of others, themselves. */
const glint_format *undropped_format(const glint_format *format);

#endif
