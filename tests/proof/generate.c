/* SPDX-License-Identifier: MIT */
/* Generators. */
#include "proof.h"

#include "../../src/extras/generate.c"
#include "contracts.h"

/*
 * Not proven: glint_generate_torus, glint_generate_cylinder, glint_generate_cone, glint_generate_plane: a ring's radius
 * and a step's place are parts of a whole, at most 1. Unit tests of generators under UBSan.
 */
#define ROOM 32

static int16_t positions[ROOM][3], normals[ROOM][3];
static uint16_t triangles[ROOM][3];

/* Room for any number up to 32. */
static glint_mesh_room any_room(void) {
    const glint_mesh_room room = {positions, normals, triangles, ANY_UNSIGNED(0, ROOM), ANY_UNSIGNED(0, ROOM)};
    return room;
}

/*
 * Divisions as they are let through, and others; any size. @contract glint_sine
 * @unreached 3 more vertices than 65536: there is room for 32
 * @options -eva-slevel 0
 */
PROOF(glint_generate_sphere) {
    const glint_mesh_room room = any_room();
    glint_mesh mesh;
    glint_generate_sphere(&mesh, &room, ANY_UNSIGNED(3, 32768), ANY_UNSIGNED(2, 32768), ANY(1, SIZE_MAX_Q16));
    glint_generate_sphere(&mesh, &room, ANY_UNSIGNED(0, UINT_MAX), ANY_UNSIGNED(0, UINT_MAX), ANY(INT32_MIN, 0));
    glint_generate_sphere(&mesh, &room, 3, 2, ANY(SIZE_MAX_Q16 + 1, INT32_MAX));
    glint_generate_sphere(ANY(0, 1) ? &mesh : 0, 0, 3, 2, GLINT_ONE);
}

/* Any sizes. @unreached 3 more vertices than 65536 @options -eva-slevel 0 */
PROOF(glint_generate_box) {
    const glint_mesh_room room = any_room();
    glint_mesh mesh;
    glint_generate_box(&mesh, &room, ANY(1, SIZE_MAX_Q16), ANY(1, SIZE_MAX_Q16), ANY(1, SIZE_MAX_Q16));
    glint_generate_box(&mesh, &room, ANY(INT32_MIN, 0), ANY_INT, ANY_INT);
    glint_generate_box(&mesh, &room, GLINT_ONE, ANY(SIZE_MAX_Q16 + 1, INT32_MAX), ANY_INT);
    glint_generate_box(&mesh, &room, GLINT_ONE, GLINT_ONE, ANY(SIZE_MAX_Q16 + 1, INT32_MAX));
    glint_generate_box(ANY(0, 1) ? &mesh : 0, 0, GLINT_ONE, GLINT_ONE, GLINT_ONE);
}
