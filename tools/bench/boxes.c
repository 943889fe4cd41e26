/* SPDX-License-Identifier: MIT */
#include "boxes.h"

#include "../../examples/scenes/stage.h"

/* ---- Meshes ---- */

/* The cube's half edge, of 32767: the extent is 1, and its corners lie on the unit sphere. */
enum { HALF = 18918 };

/* Four corners a side: right, left, top, bottom, front, back. */
static const int16_t cube_positions[24][3] = {
    {HALF, -HALF, HALF},  {HALF, -HALF, -HALF},  {HALF, HALF, -HALF},   {HALF, HALF, HALF},   {-HALF, -HALF, -HALF},
    {-HALF, -HALF, HALF}, {-HALF, HALF, HALF},   {-HALF, HALF, -HALF},  {-HALF, HALF, HALF},  {HALF, HALF, HALF},
    {HALF, HALF, -HALF},  {-HALF, HALF, -HALF},  {-HALF, -HALF, -HALF}, {HALF, -HALF, -HALF}, {HALF, -HALF, HALF},
    {-HALF, -HALF, HALF}, {-HALF, -HALF, HALF},  {HALF, -HALF, HALF},   {HALF, HALF, HALF},   {-HALF, HALF, HALF},
    {HALF, -HALF, -HALF}, {-HALF, -HALF, -HALF}, {-HALF, HALF, -HALF},  {HALF, HALF, -HALF},
};

#define FOUR(x, y, z)                  \
    {x, y, z}, {x, y, z}, {x, y, z}, { \
        x, y, z                        \
    }

static const int16_t cube_normals[24][3] = {
    FOUR(32767, 0, 0), FOUR(-32767, 0, 0), FOUR(0, 32767, 0), FOUR(0, -32767, 0), FOUR(0, 0, 32767), FOUR(0, 0, -32767),
};

static const uint16_t cube_triangles[12][3] = {
    {0, 1, 2},    {0, 2, 3},    {4, 5, 6},    {4, 6, 7},    {8, 9, 10},   {8, 10, 11},
    {12, 13, 14}, {12, 14, 15}, {16, 17, 18}, {16, 18, 19}, {20, 21, 22}, {20, 22, 23},
};

static const glint_mesh cube = {
    .positions = cube_positions,
    .normals = cube_normals,
    .triangles = cube_triangles,
    .vertex_count = 24,
    .triangle_count = 12,
    .extent = XYZ(1, 1, 1),
};

/* Half of its base's edge, and its depth below the middle; the tip is 1 above. */
enum { BASE = 24576, BELOW = -16384, TIP = 32767 };

/* A side's normal goes up by BASE where it goes out by TIP - BELOW: to a length of 1. */
enum { UP = 14654, OUT = 29307 };

/* Three corners a side: front, right, back, left; then the base. */
static const int16_t pyramid_positions[16][3] = {
    {-BASE, BELOW, BASE},  {BASE, BELOW, BASE},   {0, TIP, 0},          {BASE, BELOW, BASE},
    {BASE, BELOW, -BASE},  {0, TIP, 0},           {BASE, BELOW, -BASE}, {-BASE, BELOW, -BASE},
    {0, TIP, 0},           {-BASE, BELOW, -BASE}, {-BASE, BELOW, BASE}, {0, TIP, 0},
    {-BASE, BELOW, -BASE}, {BASE, BELOW, -BASE},  {BASE, BELOW, BASE},  {-BASE, BELOW, BASE},
};

#define THREE(x, y, z)      \
    {x, y, z}, {x, y, z}, { \
        x, y, z             \
    }

static const int16_t pyramid_normals[16][3] = {
    THREE(0, UP, OUT), THREE(OUT, UP, 0), THREE(0, UP, -OUT), THREE(-OUT, UP, 0), FOUR(0, -32767, 0),
};

static const uint16_t pyramid_triangles[6][3] = {{0, 1, 2},   {3, 4, 5},    {6, 7, 8},
                                                 {9, 10, 11}, {12, 13, 14}, {12, 14, 15}};

static const glint_mesh pyramid = {
    .positions = pyramid_positions,
    .normals = pyramid_normals,
    .triangles = pyramid_triangles,
    .vertex_count = 16,
    .triangle_count = 6,
    .extent = XYZ(1, 1, 1),
};

/* ---- Scenes ---- */

const boxes_definition boxes_definitions[BOXES_SCENES] = {
    {"cube", 128, 64, 1, 1, &cube},
    {"pyramid", 128, 64, 1, 1, &pyramid},
    {"boxes20", 128, 64, 20, 5, &cube},
    {"boxes200", 320, 240, 200, 20, &cube},
};

/* Rows that lie one behind the other as they rise, so that some hide others. */
static glint_vector place_of(const boxes_definition *definition, uint32_t i) {
    const int32_t columns = definition->columns, rows = definition->count / columns;
    const int32_t column = (int32_t)i % columns, row = (int32_t)i / columns;
    const glint_q16 step = GLINT_Q16(6) / columns;
    const glint_vector middle = XYZ(0, 0, -3.7);
    if (definition->count == 1) {
        return middle;
    }
    return (glint_vector){(2 * column - columns + 1) * step / 2, (2 * row - rows + 1) * step / 3,
                          GLINT_Q16(-6) - row * step / 2};
}

void boxes_place(glint_object objects[BOXES_MAX], const boxes_definition *definition, uint32_t frame) {
    const glint_q16 size = definition->count == 1 ? GLINT_ONE : GLINT_Q16(3) / definition->columns;
    for (uint32_t i = 0; i < definition->count; i++) {
        const glint_pose turned = stage_place((glint_vector){size, size, size}, GLINT_Q16(7) * (int32_t)(i + frame),
                                              (glint_vector)XYZ(0, 0, 0));
        const glint_pose tilted = glint_pose_rotate_x(GLINT_Q16(20) + GLINT_Q16(2) * (int32_t)frame);
        const glint_vector at = place_of(definition, i);
        const glint_pose moved = glint_pose_translate(at.x, at.y, at.z), posed = glint_pose_then(&turned, &tilted);

        objects[i].mesh = definition->mesh;
        objects[i].pose = glint_pose_then(&posed, &moved);
    }
}
