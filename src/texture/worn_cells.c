/* SPDX-License-Identifier: MIT */
/* Cells of surfaces that wear a texture: ../light/cells.c. */
#include "../light/cells.h"

#include "texture.h"

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
