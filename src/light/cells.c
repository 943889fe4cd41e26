/* SPDX-License-Identifier: MIT */
/*
 * Cells: draws large triangles in squares of 8 x 8 pixels, aligned to the screen. Light is computed at nodes, every
 * fourth pixel of every fourth row, which neighbouring cells share. Where the middle one of three nodes in a row or a
 * column is close to the mean of the other two, colours are interpolated between nodes; elsewhere each fragment is lit.
 * The values of nodes alone decide, and do not depend on depth or on the border of a tile.
 */
#include "../pixel/format.h"
#include "../raster/depth.h"
#include "lamps.h"

#define CELL 8
#define NODE_STEP 4
#define NODES (GLINT_TILE_MAX / NODE_STEP + 1)

/* A node: its colour in levels, Q14, from 0 to 2, half a level or the margin of dithering included; and the number of
 * lights that its surface faces away from. */
typedef int16_t cell_node[4];
enum { FACED_AWAY = 3 };

#define COLOUR_BITS 14

/* Colours of dithered formats keep this margin in red and blue, as eight steps, each rounded to 2^-16, lose at most 5
 * times 2^-16. Green and luma are exact. */
#define LANE_MARGIN (2 << (COLOUR_BITS - 14))

/* The three rows of nodes of a row of cells: at its top, middle and bottom. */
typedef struct cell_rows {
    glint_row_walk *walk;
    cell_node *row[3];
    uint32_t known[3];      /* bit n: node n of the row has been lit */
    uint32_t above[3];      /* bit n: a channel of node n exceeds the largest value that can be stored */
    int32_t offset[3];      /* subtracted from fragments of dithered formats: half a level, less the margin; else 0 */
    int32_t most[3];        /* the largest value that can be stored */
    uint32_t level_bits[3]; /* bits of a channel's levels; 8 if the format has fewer than 5 */
    cell_node nodes[3][NODES];
} cell_rows;

void glint_keep_span(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    glint_lamp_list *list = walk->list;
    if (!list->bottom)
        list->top = list->bottom = (uint32_t)row;
    while (list->bottom < (uint32_t)row)
        list->spans[list->bottom++] = (glint_span){0, 0};
    list->spans[list->bottom++] = (glint_span){(uint8_t)left, (uint8_t)right};
}

/* ---- Nodes ---- */

/* Sets a channel of a node. @return whether it exceeds the largest value that can be stored */
static inline uint32_t set_channel(const cell_rows *r, int c, int32_t from, int16_t *to) {
    const int32_t half = 1 << (GLINT_CHANNEL_BITS - COLOUR_BITS - 1),
                  value = glint_shift_right(from + half, GLINT_CHANNEL_BITS - COLOUR_BITS) - r->offset[c];
    to[c] = (int16_t)glint_least(glint_most(value, 0), INT16_MAX);
    return value > r->most[c];
}

/* Sets node n of a row from a fragment, whose colour is in levels, Q27, half a level included. */
static inline void set_node(cell_rows *r, int k, uint32_t n, const glint_lit_fragment *f) {
    const glint_format *format = r->walk->frame->config.format;
    const int32_t *const colour = f->out.colour;
    int32_t from[3] = {colour[0], colour[1], colour[2]};
    if (!format->channel[1]) { /* the format stores luma (ITU-R BT.601) */
        int32_t part[3];       /* Q15, clamped */
        for (int c = 0; c < 3; c++)
            part[c] = glint_least(glint_most(glint_shift_right(colour[c], GLINT_CHANNEL_BITS - 15), 0), 1 << 15);
        const int32_t luma = glint_shift_right(part[0] * 9798 + part[1] * 19235 + part[2] * 3735, 3);
        from[0] = from[1] = from[2] = glint_to_levels(luma, format->bits);
    }
    int16_t *const to = r->row[k][n];
    const uint32_t above =
        set_channel(r, 0, from[0], to) | set_channel(r, 1, from[1], to) | set_channel(r, 2, from[2], to);
    to[FACED_AWAY] = f->unseen;
    r->above[k] |= above << n;
    r->known[k] |= 1u << n;
}

/* Lights the nodes n of a row for which bit n of `missing` is set. A node stays unknown if its 1/w is out of range, or
 * if light is rough around it. */
static GLINT_NOINLINE void light_nodes(cell_rows *r, int k, uint32_t y, uint32_t missing) {
    glint_row_walk *walk = r->walk;
    glint_lit_fragment *const first = walk->list->fragment, *f = first;
    for (uint32_t n = 0; missing >> n; n++) {
        const int32_t column = (int32_t)(n * NODE_STEP), row = (int32_t)y, z = (int32_t)glint_z_at(walk, row, column);
        if (missing >> n & 1 && z > (int32_t)GLINT_DEPTH_BIAS &&
            (!walk->list->room || glint_lamp_plane(&walk->w, row, column) > 0)) {
            f->position = y << 16 | (uint32_t)column;
            f->inverse_w = (z - (int32_t)GLINT_DEPTH_BIAS) | 1;
            f->is_rough = f->unseen = 0;
            f++;
        }
        if (f == first || (f != first + GLINT_LIST_MAX && missing >> n >> 1))
            continue;
        glint_lamps_light(walk, first, f);
        while (f != first)
            if (!(--f)->is_rough)
                set_node(r, k, (f->position & 0xffff) / NODE_STEP, f);
    }
}

/* ---- Colours between nodes ---- */

/* The bend of three nodes in a line is twice the difference between the middle one and the mean of the others, in
 * levels, Q14. Colours are interpolated within squares of 4 or 8 pixels if no bend exceeds this. */
#define MOST_BEND_OF_4 (7 << 10)
#define MOST_BEND_OF_8 (7 << 9)

/* The horizon of a light is where surfaces begin to face away from it. Nodes on both sides of a horizon may differ by
 * this, in levels, Q14. */
#define HORIZON_CHANGE (1 << 14)

/* Returns the bend of a channel. */
static inline int32_t channel_bend(const cell_rows *r, int c, const int16_t *a, const int16_t *m, const int16_t *b) {
    const int32_t bend = 2 * m[c] - a[c] - b[c];
    return (bend < 0 ? -bend : bend) << r->level_bits[c];
}

/* Returns whether a light's horizon passes between nodes whose colours differ. The bends alone might not tell, as those
 * of two lights can cancel at the nodes. */
static inline int has_horizon(const cell_rows *r, const int16_t *a, const int16_t *m, const int16_t *b) {
    int32_t most = 0;
    if (a[FACED_AWAY] == m[FACED_AWAY] && m[FACED_AWAY] == b[FACED_AWAY])
        return 0;
    for (int c = 0; c < 3; c++)
        most = glint_most(most, (a[c] < b[c] ? b[c] - a[c] : a[c] - b[c]) << r->level_bits[c]);
    return most > HORIZON_CHANGE;
}

/* Returns the largest bend of a channel, or INT32_MAX if there is a horizon. */
static inline int32_t find_node_bend(const cell_rows *r, const int16_t *a, const int16_t *m, const int16_t *b) {
    if (has_horizon(r, a, m, b))
        return INT32_MAX;
    return glint_most_of(channel_bend(r, 0, a, m, b), channel_bend(r, 1, a, m, b), channel_bend(r, 2, a, m, b));
}

/* Returns whether a channel can be stored at some known nodes of a cell, and at others exceeds the largest value. */
static int cell_is_saturated(const cell_rows *r, uint32_t n) {
    for (int c = 0; c < 3; c++) {
        uint32_t above = 0, below = 0;
        for (int k = 0; k < 3; k++) {
            for (uint32_t i = n; i < n + 3; i++) {
                const int is_above = r->known[k] >> i & 1 && r->row[k][i][c] > r->most[c];
                above |= (uint32_t)is_above;
                below |= r->known[k] >> i & (uint32_t)!is_above;
            }
        }
        if (above & below & 1)
            return 1;
    }
    return 0;
}

/* A channel of a square in the current row: its value at the first column, its change from column to column, and the
 * changes of both from row to row; Q24. */
typedef struct patch_channel {
    int32_t value, step, value_down, step_down;
} patch_channel;

/* Begins with the first row of a square of 2^bits pixels between four nodes: two above, two below. */
static inline patch_channel begin_channel(const cell_rows *r, int c, unsigned bits, const int16_t *const node[4]) {
    const int32_t most = r->most[c], up = 1 << (24 - COLOUR_BITS);
    const int32_t v = glint_least(node[0][c], most), right = glint_least(node[1][c], most) - v,
                  below = glint_least(node[2][c], most) - v, across = glint_least(node[3][c], most) - v - right - below;
    return (patch_channel){v * up, glint_shift_right(right * up, bits), glint_shift_right(below * up, bits),
                           glint_shift_right(across * up, 2 * bits)};
}

static inline void step_channel(patch_channel *channel) {
    channel->value += channel->value_down;
    channel->step += channel->step_down;
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

/* Draws the parts of cached spans in a square of 2^bits x 2^bits pixels, with colours interpolated between its four
 * nodes. */
static void draw_patch(const cell_rows *r, uint32_t x, uint32_t y, unsigned bits, const int16_t *a, const int16_t *b,
                       const int16_t *below_a, const int16_t *below_b) {
    glint_row_walk *walk = r->walk;
    const glint_lamp_list *list = walk->list;
    const uint32_t end_x = x + (1u << bits), end_y = y + (1u << bits);
    const uint32_t end = end_y < list->bottom ? end_y : list->bottom;
    const int16_t *const node[4] = {a, b, below_a, below_b};
    glint_draw_span *const smooth = walk->frame->config.format->smooth;
    patch_channel red = begin_channel(r, 0, bits, node), green = begin_channel(r, 1, bits, node),
                  blue = begin_channel(r, 2, bits, node);
    walk->lanes[2] = (glint_lanes){0, 0};
    for (uint32_t row = y; row < end; row++) {
        uint32_t left, right;
        if (clip_to_columns(list, row, x, end_x, &left, &right)) {
            const uint32_t red_blue = ((uint32_t)glint_shift_right(blue.step + (1 << 7), 8) << 16) +
                                      (uint32_t)glint_shift_right(red.step + (1 << 7), 8),
                           green_step = (uint32_t)green.step << 8;
            walk->lanes[1].red_blue = red_blue;
            walk->lanes[1].green = green_step;
            walk->lanes[0].red_blue = ((uint32_t)glint_shift_right(blue.value, 8) << 16) +
                                      (uint32_t)glint_shift_right(red.value, 8) - red_blue * x;
            walk->lanes[0].green = ((uint32_t)green.value << 8) - green_step * x;
            smooth(walk, (int32_t)row, (int32_t)left, (int32_t)right);
        }
        step_channel(&red);
        step_channel(&green);
        step_channel(&blue);
    }
}

/* ---- Cells ---- */

/* Returns whether a pixel of a cell passes the depth test. */
static int cell_is_seen(const glint_row_walk *walk, uint32_t x, uint32_t y) {
    for (uint32_t row = y; row < y + CELL; row++) {
        uint32_t left, right;
        if (!clip_to_columns(walk->list, row, x, x + CELL, &left, &right))
            continue;
        const uint16_t *depth = walk->depth + (row << walk->shift);
        uint32_t z = glint_z_at(walk, (int32_t)row, (int32_t)left);
        for (; left < right; left++, z += (uint32_t)walk->z.dx)
            if (z >> 15 > depth[left])
                return 1;
    }
    return 0;
}

/* Finds which parts of a cell bend too much to be interpolated. @return bit i is set for square i of 4 x 4 pixels, row
 * by row, bit 4 for the whole cell */
static uint32_t find_bent(const cell_rows *r, uint32_t n) {
    uint32_t bent = 0, is_bent = 0;
    for (uint32_t k = 0; k < 3; k++) {
        static const uint8_t of_row[3] = {3, 15, 12}, of_column[3] = {5, 15, 10}; /* squares that border on it */
        const int is_row_known = (r->known[k] >> n & 7) == 7,
                  is_column_known = (int)(r->known[0] >> (n + k) & r->known[1] >> (n + k) & r->known[2] >> (n + k) & 1);
        const int32_t across = is_row_known ? find_node_bend(r, r->row[k][n], r->row[k][n + 1], r->row[k][n + 2])
                                            : INT32_MAX,
                      down = is_column_known ? find_node_bend(r, r->row[0][n + k], r->row[1][n + k], r->row[2][n + k])
                                             : INT32_MAX;
        is_bent |= glint_most(across, down) > MOST_BEND_OF_8 ? 16 : 0;
        if (across > MOST_BEND_OF_4)
            bent |= of_row[k];
        if (down > MOST_BEND_OF_4)
            bent |= of_column[k];
    }
    if ((r->above[0] | r->above[1] | r->above[2]) >> n & 7 && cell_is_saturated(r, n))
        bent = 15;
    return bent | is_bent;
}

/* Draws the cell at column x and row y: as a whole, or square by square. */
static void draw_cell(cell_rows *r, uint32_t x, uint32_t y) {
    const uint32_t n = x / NODE_STEP, bent = find_bent(r, n);
    if (!bent) {
        draw_patch(r, x, y, 3, r->row[0][n], r->row[0][n + 2], r->row[2][n], r->row[2][n + 2]);
        return;
    }
    for (uint32_t i = 0; i < 4; i++) {
        const uint32_t left_x = x + (i & 1) * NODE_STEP, top = y + (i >> 1) * NODE_STEP;
        cell_node *const above = r->row[i >> 1] + n + (i & 1), *const below = r->row[(i >> 1) + 1] + n + (i & 1);
        if (!(bent >> i & 1)) {
            draw_patch(r, left_x, top, 2, above[0], above[1], below[0], below[1]);
            continue;
        }
        for (uint32_t row = top; row < top + NODE_STEP; row++) {
            uint32_t left, right;
            if (clip_to_columns(r->walk->list, row, left_x, left_x + NODE_STEP, &left, &right))
                glint_list_span(r->walk, (int32_t)row, (int32_t)left, (int32_t)right);
        }
    }
    if (r->walk->list->count)
        glint_light_listed(r->walk);
}

/* Draws a row of cells: lights the nodes of those that are visible, and draws them. */
static void draw_cell_row(cell_rows *r, uint32_t y) {
    const glint_lamp_list *list = r->walk->list;
    uint32_t left = GLINT_TILE_MAX, right = 0, seen = 0, nodes = 0;
    for (uint32_t row = y < list->top ? list->top : y; row < y + CELL && row < list->bottom; row++) {
        const glint_span span = list->spans[row];
        if (span.left >= span.right)
            continue;
        left = span.left < left ? span.left : left;
        right = span.right > right ? span.right : right;
    }
    left &= ~(CELL - 1u);
    for (uint32_t x = left; x < right; x += CELL) {
        if (cell_is_seen(r->walk, x, y)) {
            seen |= 1u << x / CELL;
            nodes |= 7u << x / NODE_STEP;
        }
    }
    for (int k = 0; k < 3; k++)
        if (nodes & ~r->known[k])
            light_nodes(r, k, y + (uint32_t)k * NODE_STEP, nodes & ~r->known[k]);
    for (uint32_t x = left; x < right; x += CELL)
        if (seen >> x / CELL & 1)
            draw_cell(r, x, y);
}

/* Sets the numbers that depend on the format's channels. */
static void set_cell_levels(cell_rows *r) {
    const glint_format *format = r->walk->frame->config.format;
    for (int c = 0; c < 3; c++) {
        const unsigned bits = format->channel[1] ? format->channel[c] : format->bits;
        const int32_t level = 1 << (COLOUR_BITS - bits), margin = c == 1 || !format->channel[1] ? 0 : LANE_MARGIN;
        r->offset[c] = format->is_dithered ? level / 2 - margin : 0;
        r->level_bits[c] = bits > 4 ? bits : 8;
        r->most[c] = (1 << COLOUR_BITS) - (format->is_dithered ? level + margin : level / 2);
    }
}

GLINT_NOINLINE void glint_draw_cells(glint_row_walk *walk) {
    cell_rows r;
    r.walk = walk;
    for (int k = 0; k < 3; k++) {
        r.row[k] = r.nodes[k];
        r.known[k] = r.above[k] = 0;
    }
    set_cell_levels(&r);
    for (uint32_t y = walk->list->top & ~(CELL - 1u); y < walk->list->bottom; y += CELL) {
        draw_cell_row(&r, y);
        cell_node *const last = r.row[0];
        r.row[0] = r.row[2];
        r.row[2] = last;
        r.known[0] = r.known[2];
        r.above[0] = r.above[2];
        r.known[1] = r.known[2] = r.above[1] = r.above[2] = 0;
    }
}
