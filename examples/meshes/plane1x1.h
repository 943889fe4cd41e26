/* SPDX-License-Identifier: MIT */
/*
 * plane:1x1: 4 vertices, 2 triangles, 60 bytes of flash. Generated, not to be edited, by
 *     glint convert plane:1x1 --name plane1x1 --licence MIT
 * from a source whose FNV-1a hash (64 bits) is d6c12cc7d3286ebf.
 *
 * positions  int16 steps: object space is offset + extent * step / 32768, per axis
 * normals    int16, Q15, unit length: 32767 is 1
 * triangles  uint16 indices, counter-clockwise seen from outside
 * offset     Q16.16, where step 0 lies
 * extent     Q16.16, the length of 32768 steps
 */
#ifndef PLANE1X1_MESH_H
#define PLANE1X1_MESH_H

#include "glint.h"

static const int16_t plane1x1_positions[4][3] = {
    {-32767, -32767, 0}, {32767, -32767, 0}, {-32767, 32767, 0}, {32767, 32767, 0},
};

static const int16_t plane1x1_normals[4][3] = {
    {0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767},
};

static const uint16_t plane1x1_triangles[2][3] = {
    {0, 1, 3}, {0, 3, 2},
};

static const glint_mesh plane1x1_mesh = {
    plane1x1_positions,
    plane1x1_normals,
    plane1x1_triangles,
    4u, /* vertices */
    2u, /* triangles */
    {0, 0, 0}, /* offset */
    {65538, 65538, 0}, /* extent */
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
