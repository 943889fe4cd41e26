/* SPDX-License-Identifier: MIT */
/** @file need.h What a scene takes of an arena, counted without one: as it is, or with its objects turned any way. */
#ifndef GLINT_NEED_H
#define GLINT_NEED_H

#include "frame.h"

/** What the parts of a scene add up to. */
typedef struct glint_tally {
    size_t vertices, references, clipped; /* bytes, counts */
    size_t of_quarter[4];                 /* references in each quarter of the tiles */
    size_t materials, tables;             /* bytes */
} glint_tally;

/** Checks a scene, all but its meshes' indices, prepares frame and view, and begins a tally with the materials. */
glint_status glint_need_begin(glint_frame *frame, glint_view *view, const glint_config *config,
                              const glint_scene *scene, glint_tally *sum);

/** Bytes of a draw of all of an object, whose material is prepared for it. */
size_t glint_need_object(glint_frame *frame, const glint_object *object, const glint_transform *transform);

/** What a tally of all objects comes to. */
void glint_need_end(const glint_frame *frame, const glint_tally *sum, glint_need *need);

#endif
