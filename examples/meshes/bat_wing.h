/* SPDX-License-Identifier: MIT */
/*
 * bat-wing.obj: 13 vertices, 12 triangles, 228 bytes of flash. Generated, not to be edited, by
 *     glint convert bat-wing.obj --name bat_wing --licence MIT --double-sided
 * from a source whose FNV-1a hash (64 bits) is a2e1df428833c74d.
 *
 * positions  int16 steps: object space is offset + extent * step / 32768, per axis
 * normals    int16, Q15, unit length: 32767 is 1
 * triangles  uint16 indices, counter-clockwise seen from outside
 * offset     Q16.16, where step 0 lies
 * extent     Q16.16, the length of 32768 steps
 */
#ifndef BAT_WING_MESH_H
#define BAT_WING_MESH_H

#include "glint.h"

static const int16_t bat_wing_positions[13][3] = {
    {-32766, -32718, -9361}, {-29489, -29444, -21064}, {-26868, -26826, -9361}, {-3277, -3256, -32766}, {32766, 32754, -11702}, {19660, 19660, 0},
    {14417, 14422, 18724}, {1311, 1327, 7022}, {-6553, -6529, 25745}, {-17038, -17005, 11703}, {-26213, -26171, 25745}, {-32766, -32718, 32767},
    {-19660, -32718, -3510},
};

static const int16_t bat_wing_normals[13][3] = {
    {0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0},
    {0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0},
    {0, 32767, 0},
};

static const uint16_t bat_wing_triangles[12][3] = {
    {12, 1, 0}, {12, 2, 1}, {12, 3, 2}, {12, 4, 3}, {12, 5, 4}, {12, 6, 5},
    {12, 7, 6}, {12, 8, 7}, {12, 9, 8}, {12, 10, 9}, {12, 11, 10}, {12, 0, 11},
};

static const glint_mesh bat_wing_mesh = {
    bat_wing_positions,
    bat_wing_normals,
    bat_wing_triangles,
    13u, /* vertices */
    12u, /* triangles */
    {32768, 655, -1311}, /* offset */
    {32770, 656, 18351}, /* extent */
    GLINT_MESH_DOUBLE_SIDED,
    0,
    0, /* no colours */
    0, /* no clusters */
    0, /* no layout */
    0,
    {0, 0},
    {0, 0}, /* no texture */
};

#endif
