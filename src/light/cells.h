/* SPDX-License-Identifier: MIT */
/** @file cells.h Nodes of cells, and squares of pixels between them: cells.c. */
#ifndef GLINT_CELLS_H
#define GLINT_CELLS_H

#include "room.h"
#include "wear.h"

/** The places in a node of the number of lights that its surface faces away from, and of highlights. */
enum { FACED_AWAY = 3, HIGHLIGHT = 4 };

#define COLOUR_BITS 14

/** Half of GLINT_WORN_MARGIN, as nodes have half of their light; and the largest light that they hold, less than 2. */
#define HALF_MARGIN (GLINT_WORN_MARGIN / 2)
#define MOST_WORN ((1 << COLOUR_BITS) - HALF_MARGIN)

/* A channel of a square in the current row: its value at the first column, its change from column to column, and the
 * changes of both from row to row; Q24. */
typedef struct patch_channel {
    int32_t value, step, value_down, step_down;
} patch_channel;

/* The channels of a square. */
typedef struct patch {
    patch_channel red, green, blue;
} patch;

/* Begins with the first row of a square of 2^bits pixels between four nodes: two above, two below. */
static inline patch_channel begin_channel(const glint_cell_rows *r, int c, unsigned bits,
                                          const int16_t *const node[4]) {
    const int32_t most = r->most[c], up = 1 << (24 - COLOUR_BITS);
    const int32_t v = glint_least(node[0][c], most), right = glint_least(node[1][c], most) - v,
                  below = glint_least(node[2][c], most) - v, across = glint_least(node[3][c], most) - v - right - below;
    return (patch_channel){v * up, glint_shift_right(right * up, bits), glint_shift_right(below * up, bits),
                           glint_shift_right(across * up, 2 * bits)};
}

static inline patch begin_patch(const glint_cell_rows *r, unsigned bits, const int16_t *a, const int16_t *b,
                                const int16_t *below_a, const int16_t *below_b) {
    const int16_t *const node[4] = {a, b, below_a, below_b};
    return (patch){begin_channel(r, 0, bits, node), begin_channel(r, 1, bits, node), begin_channel(r, 2, bits, node)};
}

static inline void step_channel(patch_channel *channel) {
    channel->value += channel->value_down;
    channel->step += channel->step_down;
}

static inline void step_patch(patch *p) {
    step_channel(&p->red);
    step_channel(&p->green);
    step_channel(&p->blue);
}

/* Sets the lanes of a row of a square, from column x on, and their change from column to column. */
static inline void set_patch_lanes(const patch *p, uint32_t x, glint_lanes to[2]) {
    const uint32_t red_blue = ((uint32_t)glint_shift_right(p->blue.step + (1 << 7), 8) << 16) +
                              (uint32_t)glint_shift_right(p->red.step + (1 << 7), 8),
                   green_step = (uint32_t)p->green.step << 8;
    to[1].red_blue = red_blue;
    to[1].green = green_step;
    to[0].red_blue = ((uint32_t)glint_shift_right(p->blue.value, 8) << 16) +
                     (uint32_t)glint_shift_right(p->red.value, 8) - red_blue * x;
    to[0].green = ((uint32_t)p->green.value << 8) - green_step * x;
}

/* Finds the part of a row's cached span from column x to before `end`. @return 0 if there is none */
static inline int clip_to_columns(const glint_lamp_list *list, uint32_t row, uint32_t x, uint32_t end, uint32_t *left,
                                  uint32_t *right) {
    if (row < list->top || row >= list->bottom)
        return 0;
    *left = list->spans[row].left > x ? list->spans[row].left : x;
    *right = list->spans[row].right < end ? list->spans[row].right : end;
    return *left < *right;
}

#endif
