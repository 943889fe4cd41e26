/* SPDX-License-Identifier: MIT */
/*
 * box: 24 vertices, 12 triangles, 360 bytes of flash. Generated, not to be edited, by
 *     glint convert box --name box --licence MIT
 * from a source whose FNV-1a hash (64 bits) is 004d2e191349e4f2.
 *
 * positions  int16 steps: object space is offset + extent * step / 32768, per axis
 * normals    int16, Q15, unit length: 32767 is 1
 * triangles  uint16 indices, counter-clockwise seen from outside
 * offset     Q16.16, where step 0 lies
 * extent     Q16.16, the length of 32768 steps
 */
#ifndef BOX_MESH_H
#define BOX_MESH_H

#include "glint.h"

static const int16_t box_positions[24][3] = {
    {32767, -32767, -32767}, {32767, 32767, -32767}, {32767, 32767, 32767}, {32767, -32767, 32767}, {-32767, 32767, -32767}, {-32767, -32767, -32767},
    {-32767, -32767, 32767}, {-32767, 32767, 32767}, {-32767, 32767, -32767}, {-32767, 32767, 32767}, {32767, 32767, 32767}, {32767, 32767, -32767},
    {-32767, -32767, 32767}, {-32767, -32767, -32767}, {32767, -32767, -32767}, {32767, -32767, 32767}, {-32767, -32767, 32767}, {32767, -32767, 32767},
    {32767, 32767, 32767}, {-32767, 32767, 32767}, {32767, -32767, -32767}, {-32767, -32767, -32767}, {-32767, 32767, -32767}, {32767, 32767, -32767},
};

static const int16_t box_normals[24][3] = {
    {32767, 0, 0}, {32767, 0, 0}, {32767, 0, 0}, {32767, 0, 0}, {-32767, 0, 0}, {-32767, 0, 0},
    {-32767, 0, 0}, {-32767, 0, 0}, {0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0},
    {0, -32767, 0}, {0, -32767, 0}, {0, -32767, 0}, {0, -32767, 0}, {0, 0, 32767}, {0, 0, 32767},
    {0, 0, 32767}, {0, 0, 32767}, {0, 0, -32767}, {0, 0, -32767}, {0, 0, -32767}, {0, 0, -32767},
};

static const uint16_t box_triangles[12][3] = {
    {0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}, {8, 9, 10}, {8, 10, 11},
    {12, 13, 14}, {12, 14, 15}, {16, 17, 18}, {16, 18, 19}, {20, 21, 22}, {20, 22, 23},
};

static const glint_mesh box_mesh = {
    box_positions,
    box_normals,
    box_triangles,
    24u, /* vertices */
    12u, /* triangles */
    {0, 0, 0}, /* offset */
    {65538, 65538, 65538}, /* extent */
    0,
    0,
    0, /* no colours */
    0, /* no clusters */
    0, /* no layout */
    0,
    {0, 0},
    {0, 0}, /* no texture */
};

#endif
