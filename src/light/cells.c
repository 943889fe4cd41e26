/* SPDX-License-Identifier: MIT */
/*
 * Cells: draws large triangles in squares of 8 x 8 pixels, aligned to the screen. Light is computed at nodes, every
 * fourth pixel of every fourth row, which neighbouring cells share. Where the middle one of three nodes in a row or a
 * column is close to the mean of the other two, colours are interpolated between nodes; elsewhere each fragment is lit.
 * The values of nodes alone decide, and do not depend on depth or on the border of a tile.
 */
#include "../pixel/format.h"
#include "../raster/depth.h"
#include "room.h"
#include "wear.h"

/* The places in a node of the number of lights that its surface faces away from, and of highlights. */
enum { FACED_AWAY = 3, HIGHLIGHT = 4 };

#define COLOUR_BITS 14

/* Half of GLINT_WORN_MARGIN, as nodes have half of their light; and the largest light that they hold, less than 2. */
#define HALF_MARGIN (GLINT_WORN_MARGIN / 2)
#define MOST_WORN ((1 << COLOUR_BITS) - HALF_MARGIN)

/* Colours of dithered formats keep this margin in red and blue, as eight steps, each rounded to 2^-16, lose at most 5
 * times 2^-16. Green and luma are exact. */
#define LANE_MARGIN (2 << (COLOUR_BITS - 14))

void glint_keep_span(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    glint_lamp_list *list = walk->list;
    if (!list->bottom)
        list->top = list->bottom = (uint32_t)row;
    while (list->bottom < (uint32_t)row)
        list->spans[list->bottom++] = (glint_span){0, 0};
    list->spans[list->bottom++] = (glint_span){(uint8_t)left, (uint8_t)right};
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

/* ---- Nodes ---- */

/* Sets a channel of a node. @return whether it exceeds the largest value that can be stored */
static inline uint32_t set_channel(const glint_cell_rows *r, int c, int32_t from, int16_t *to) {
    const int32_t half = 1 << (GLINT_CHANNEL_BITS - COLOUR_BITS - 1),
                  value = glint_shift_right(from + half, GLINT_CHANNEL_BITS - COLOUR_BITS) - r->offset[c];
    to[c] = (int16_t)glint_least(glint_most(value, 0), INT16_MAX);
    return value > r->most[c];
}

/* Sets node n of a row from a fragment, whose colour is in levels, Q27, half a level included. */
static inline void set_node(glint_cell_rows *r, int k, uint32_t n, const glint_lit_fragment *f) {
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
static GLINT_HOT GLINT_NOINLINE void light_nodes(glint_cell_rows *r, int k, uint32_t y, uint32_t missing) {
    glint_row_walk *walk = r->walk;
    glint_lit_fragment *const first = walk->list->pixels.fragment, *f = first;
    walk->list->lights_nodes = (uint16_t)r->is_worn;
    for (uint32_t n = 0; missing >> n; n++) {
        const int32_t column = (int32_t)(n * GLINT_NODE_STEP), row = (int32_t)y,
                      z = (int32_t)glint_z_at(walk, row, column);
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
            if (!(--f)->is_rough) {
                const uint32_t at = (f->position & 0xffff) / GLINT_NODE_STEP;
                if (GLINT_RARELY(r->is_worn))
                    walk->draw->texture->type->stage->set_node(r, k, at, f);
                else
                    set_node(r, k, at, f);
            }
    }
    walk->list->lights_nodes = 0;
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
static inline int32_t channel_bend(const glint_cell_rows *r, int c, const int16_t *a, const int16_t *m,
                                   const int16_t *b) {
    const int32_t bend = 2 * m[c] - a[c] - b[c];
    return (bend < 0 ? -bend : bend) << r->level_bits[c];
}

/* Returns whether a light's horizon passes between nodes whose colours differ. The bends alone might not tell, as those
 * of two lights can cancel at the nodes. */
static inline int has_horizon(const glint_cell_rows *r, const int16_t *a, const int16_t *m, const int16_t *b) {
    int32_t most = 0;
    if (a[FACED_AWAY] == m[FACED_AWAY] && m[FACED_AWAY] == b[FACED_AWAY])
        return 0;
    for (int c = 0; c < 3; c++)
        most = glint_most(most, (a[c] < b[c] ? b[c] - a[c] : a[c] - b[c]) << r->level_bits[c]);
    return most > HORIZON_CHANGE;
}

/* Returns the largest bend of a channel, or INT32_MAX if there is a horizon. */
static inline int32_t find_node_bend(const glint_cell_rows *r, const int16_t *a, const int16_t *m, const int16_t *b) {
    if (has_horizon(r, a, m, b))
        return INT32_MAX;
    const int32_t bend =
        glint_most_of(channel_bend(r, 0, a, m, b), channel_bend(r, 1, a, m, b), channel_bend(r, 2, a, m, b));
    if (!GLINT_RARELY(r->is_worn))
        return bend;
    a += HIGHLIGHT, m += HIGHLIGHT, b += HIGHLIGHT;
    return glint_most(
        bend, glint_most_of(channel_bend(r, 0, a, m, b), channel_bend(r, 1, a, m, b), channel_bend(r, 2, a, m, b)));
}

/* Returns whether a channel can be stored at some known nodes of a cell, and at others exceeds the largest value. */
static int cell_is_saturated(const glint_cell_rows *r, uint32_t n) {
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

/* ---- Squares ---- */

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

/* Draws the parts of cached spans in a square of 2^bits x 2^bits pixels, with colours interpolated between its four
 * nodes. */
static GLINT_HOT void draw_patch(const glint_cell_rows *r, uint32_t x, uint32_t y, unsigned bits, const int16_t *a,
                                 const int16_t *b, const int16_t *below_a, const int16_t *below_b) {
    glint_row_walk *walk = r->walk;
    const glint_lamp_list *list = walk->list;
    const uint32_t end_x = x + (1u << bits), end_y = y + (1u << bits);
    const uint32_t end = end_y < list->bottom ? end_y : list->bottom;
    glint_draw_span *const smooth = walk->frame->config.format->smooth;
    patch colour = begin_patch(r, bits, a, b, below_a, below_b);
    walk->lanes[2] = (glint_lanes){0, 0};
    for (uint32_t row = y; row < end; row++) {
        uint32_t left, right;
        if (clip_to_columns(list, row, x, end_x, &left, &right)) {
            set_patch_lanes(&colour, x, walk->lanes);
            smooth(walk, (int32_t)row, (int32_t)left, (int32_t)right);
        }
        step_patch(&colour);
    }
}

/* ---- Where a texture multiplies light ---- */

/* Returns half of a channel of light that is in levels of so many bits, Q27. */
static inline int16_t half_of_light(int32_t channel, uint32_t bits) {
    /* 1 over the largest level as a part of 1, Q15 */
    static const uint32_t over_largest[9] = {32768, 65536, 43691, 37449, 34953, 33825, 33288, 33026, 32896};
    const int32_t half = glint_least((int32_t)(((uint32_t)glint_most(channel, 0) + (1u << 13)) >> 14), MOST_WORN);
    return (int16_t)glint_least((int32_t)((uint32_t)half * over_largest[bits] >> 15) + HALF_MARGIN, MOST_WORN);
}

/* Sets node n of a row from a fragment whose light is to be multiplied by a texture. */
void glint_set_worn_node(glint_cell_rows *r, int k, uint32_t n, const glint_lit_fragment *f) {
    const int32_t gloss[3] = {(int32_t)f->out.pixel, f->inverse_w, (int32_t)f->square};
    const uint8_t *const bits = r->walk->frame->config.format->channel;
    int16_t *const to = r->row[k][n];
    for (int c = 0; c < 3; c++) {
        to[c] = half_of_light(f->out.colour[c], bits[c]);
        to[HIGHLIGHT + c] = half_of_light(gloss[c], bits[c]);
        r->above[k] |= (uint32_t)(to[c] == MOST_WORN) << n;
    }
    to[FACED_AWAY] = f->unseen;
    r->known[k] |= 1u << n;
}

/* Returns whether a node has highlights, or light above 1. */
static inline int glows(const int16_t *node) {
    return glint_most_of(node[HIGHLIGHT], node[HIGHLIGHT + 1], node[HIGHLIGHT + 2]) > HALF_MARGIN ||
           glint_most_of(node[0], node[1], node[2]) > (1 << 13) + HALF_MARGIN;
}

/* Begins light or highlights of a square. This is out of line: what it uses of the stack is free again then. */
static GLINT_NOINLINE void begin_node_light(patch *to, const glint_cell_rows *r, unsigned bits, int place,
                                            const int16_t *const node[4]) {
    *to = begin_patch(r, bits, node[0] + place, node[1] + place, node[2] + place, node[3] + place);
}

/* Sets the lanes of a row of a square, as set_patch_lanes does, and steps to the next row. Out of line for the stack.
 */
static GLINT_NOINLINE void step_node_light(patch *p, uint32_t x, glint_lanes to[2]) {
    set_patch_lanes(p, x, to);
    step_patch(p);
}

/* Does what draw_patch does, where a texture is to multiply light. */
GLINT_HOT void glint_draw_worn_patch(const glint_cell_rows *r, uint32_t x, uint32_t y, unsigned bits, const int16_t *a,
                                     const int16_t *b, const int16_t *below_a, const int16_t *below_b) {
    glint_row_walk *walk = r->walk;
    const glint_lamp_list *list = walk->list;
    const glint_texture_stage *stage = walk->draw->texture->type->stage;
    const int is_glowing = glows(a) || glows(b) || glows(below_a) || glows(below_b);
    const int16_t *const node[4] = {a, b, below_a, below_b};
    patch light, gloss;
    begin_node_light(&light, r, bits, 0, node);
    if (is_glowing)
        begin_node_light(&gloss, r, bits, HIGHLIGHT, node);
    walk->lanes[2] = (glint_lanes){0, 0};
    walk->draw_span = is_glowing ? stage->glowing : stage->smooth;
    glint_leave_holes(walk);
    for (uint32_t row = y; row < y + (1u << bits); row++) {
        uint32_t left, right;
        step_node_light(&light, x, walk->lanes);
        if (is_glowing)
            step_node_light(&gloss, x, walk->gloss);
        if (clip_to_columns(list, row, x, x + (1u << bits), &left, &right))
            walk->draw_span(walk, (int32_t)row, (int32_t)left, (int32_t)right);
    }
}

/* ---- Cells ---- */

/* Returns whether a pixel of a cell passes the depth test. */
static int cell_is_seen(const glint_row_walk *walk, uint32_t x, uint32_t y) {
    for (uint32_t row = y; row < y + GLINT_CELL; row++) {
        uint32_t left, right;
        if (!clip_to_columns(walk->list, row, x, x + GLINT_CELL, &left, &right))
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
static GLINT_NOINLINE uint32_t find_bent(const glint_cell_rows *r, uint32_t n) {
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
    if ((r->above[0] | r->above[1] | r->above[2]) >> n & 7 && (r->is_worn || cell_is_saturated(r, n)))
        bent = 15;
    return bent | is_bent;
}

/* Draws the cell at column x and row y: as a whole, or square by square. Out of line, so that light_nodes is not below
 * what it uses of the stack. */
static GLINT_NOINLINE void draw_cell(glint_cell_rows *r, uint32_t x, uint32_t y) {
    const uint32_t n = x / GLINT_NODE_STEP, bent = find_bent(r, n);
    glint_draw_patch *const draw = r->is_worn ? r->walk->draw->texture->type->stage->draw_patch : draw_patch;
    if (!bent) {
        draw(r, x, y, 3, r->row[0][n], r->row[0][n + 2], r->row[2][n], r->row[2][n + 2]);
        return;
    }
    for (uint32_t i = 0; i < 4; i++) {
        const uint32_t left_x = x + (i & 1) * GLINT_NODE_STEP, top = y + (i >> 1) * GLINT_NODE_STEP;
        glint_cell_node *const above = r->row[i >> 1] + n + (i & 1), *const below = r->row[(i >> 1) + 1] + n + (i & 1);
        if (!(bent >> i & 1)) {
            draw(r, left_x, top, 2, above[0], above[1], below[0], below[1]);
            continue;
        }
        r->walk->draw_span = glint_list_span;
        glint_leave_holes(r->walk);
        for (uint32_t row = top; row < top + GLINT_NODE_STEP; row++) {
            uint32_t left, right;
            if (clip_to_columns(r->walk->list, row, left_x, left_x + GLINT_NODE_STEP, &left, &right))
                r->walk->draw_span(r->walk, (int32_t)row, (int32_t)left, (int32_t)right);
        }
    }
    if (r->walk->list->count)
        glint_light_listed(r->walk);
}

/* Draws a row of cells: lights the nodes of those that are visible, and draws them. */
static void draw_cell_row(glint_cell_rows *r, uint32_t y) {
    const glint_lamp_list *list = r->walk->list;
    uint32_t left = GLINT_TILE_MAX, right = 0, seen = 0, nodes = 0;
    for (uint32_t row = y < list->top ? list->top : y; row < y + GLINT_CELL && row < list->bottom; row++) {
        const glint_span span = list->spans[row];
        if (span.left >= span.right)
            continue;
        left = span.left < left ? span.left : left;
        right = span.right > right ? span.right : right;
    }
    left &= ~(GLINT_CELL - 1u);
    for (uint32_t x = left; x < right; x += GLINT_CELL) {
        if (cell_is_seen(r->walk, x, y)) {
            seen |= 1u << x / GLINT_CELL;
            nodes |= 7u << x / GLINT_NODE_STEP;
        }
    }
    for (int k = 0; k < 3; k++)
        if (nodes & ~r->known[k])
            light_nodes(r, k, y + (uint32_t)k * GLINT_NODE_STEP, nodes & ~r->known[k]);
    for (uint32_t x = left; x < right; x += GLINT_CELL)
        if (seen >> x / GLINT_CELL & 1)
            draw_cell(r, x, y);
}

/* Sets the numbers that depend on the format's channels. */
static void set_cell_levels(glint_cell_rows *r) {
    const glint_format *format = r->walk->frame->config.format;
    r->is_worn = r->walk->draw->texture != 0;
    for (int c = 0; c < 3; c++) {
        const unsigned bits = format->channel[1] ? format->channel[c] : format->bits;
        const int32_t level = 1 << (COLOUR_BITS - bits), margin = c == 1 || !format->channel[1] ? 0 : LANE_MARGIN;
        r->offset[c] = format->is_dithered ? level / 2 - margin : 0;
        r->level_bits[c] = (uint8_t)((bits > 4 ? bits : 8) + r->is_worn);
        r->most[c] = r->is_worn ? MOST_WORN : (1 << COLOUR_BITS) - (format->is_dithered ? level + margin : level / 2);
    }
}

GLINT_HOT GLINT_NOINLINE void glint_draw_cells(glint_row_walk *walk) {
    glint_cell_rows *const r = &walk->workspace->room->of.cells;
    r->walk = walk;
    for (int k = 0; k < 3; k++) {
        r->row[k] = r->nodes[k];
        r->known[k] = r->above[k] = 0;
    }
    set_cell_levels(r);
    for (uint32_t y = walk->list->top & ~(GLINT_CELL - 1u); y < walk->list->bottom; y += GLINT_CELL) {
        draw_cell_row(r, y);
        glint_cell_node *const last = r->row[0];
        r->row[0] = r->row[2];
        r->row[2] = last;
        r->known[0] = r->known[2];
        r->above[0] = r->above[2];
        r->known[1] = r->known[2] = r->above[1] = r->above[2] = 0;
    }
}
