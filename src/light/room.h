/* SPDX-License-Identifier: MIT */
/** @file room.h Memory of a workspace for the triangle that is drawn now, where fragments are lit. It is large, and so
 * not on the stack. */
#ifndef GLINT_ROOM_H
#define GLINT_ROOM_H

#include "lamps.h"
#include "suns.h"

/** Width and height of a cell, pixels; and nodes are so many pixels apart. */
#define GLINT_CELL 8
#define GLINT_NODE_STEP 4
#define GLINT_NODES (GLINT_TILE_MAX / GLINT_NODE_STEP + 1)

/** A node: its colour in levels, Q14, from 0 to 2, half a level or the margin of dithering included; and the number of
 * lights that its surface faces away from. Where a texture is to multiply light: its light without highlights, Q13 with
 * half of GLINT_WORN_MARGIN; that number; and the highlights likewise. */
typedef int16_t glint_cell_node[7];

/** The three rows of nodes of a row of cells: at its top, middle and bottom. */
typedef struct glint_cell_rows {
    glint_row_walk *walk;
    glint_cell_node *row[3];
    uint32_t known[3];     /* bit n: node n of the row has been lit */
    uint32_t above[3];     /* bit n: a channel of node n exceeds the largest value that can be stored */
    int32_t offset[3];     /* subtracted from fragments of dithered formats: half a level, less the margin; else 0 */
    int32_t most[3];       /* the largest value that can be stored */
    uint8_t level_bits[3]; /* bits of a channel's levels; 8 if the format has fewer than 5; one more for halves */
    uint8_t is_worn;       /* a texture is to multiply light */
    glint_cell_node nodes[3][GLINT_NODES];
} glint_cell_rows;

/** Cells are begun once suns are done with a triangle. */
typedef struct glint_lit_room {
    glint_lamp_list list;
    union {
        glint_sun_triangle suns;
        glint_cell_rows cells;
    } of;
} glint_lit_room;

#endif
