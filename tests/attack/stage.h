/* SPDX-License-Identifier: MIT */
/** @file stage.h A scene in pages that cannot be written, whose structures can be spoilt and made good again. */
#ifndef GLINT_ATTACK_STAGE_H
#define GLINT_ATTACK_STAGE_H

#include "fuzz/drawing.h"
#include "pages.h"

/** Arrays of a mesh: positions, normals, triangles, two of colours, four of a layout, clusters and borrowers. */
#define STAGE_ARRAYS 11

/** All structures of a scene. */
typedef struct props {
    glint_object objects[DRAWING_OBJECTS];
    glint_material materials[DRAWING_OBJECTS];
    glint_mesh_layout layouts[DRAWING_MESHES];
    glint_clusters clusters[DRAWING_MESHES];
    glint_mesh meshes[DRAWING_MESHES];
    glint_scene scene;
    glint_light lights[GLINT_LIGHTS_MAX]; /* last: reading on is a fault */
} props;

/** A scene, what it points to, and how it was. */
typedef struct attack_stage {
    pages arrays[DRAWING_MESHES][STAGE_ARRAYS];
    pages structures; /**< Props. */
    props *now;       /**< There. */
    props sound;      /**< What they were; pointers point into `now`. */
    int is_loose;     /**< As in drawing. */
} attack_stage;

void attack_stage_open(attack_stage *stage);

void attack_stage_close(attack_stage *stage);

/** Takes a scene from a source, of any values or one that users draw, into sealed pages; half of the arrays end at the
 * forbidden page behind, the others begin at the one before. */
void attack_stage_take(attack_stage *stage, source *s, int is_usual);

/** Spoils some numbers and pointers: extreme values, null, a step up or down. */
void attack_stage_spoil(attack_stage *stage, source *s);

/** Makes all good again. */
void attack_stage_restore(attack_stage *stage);

/** An extreme number, any, or `old` changed a little. */
uint32_t attack_number(source *s, uint32_t old);

#endif
