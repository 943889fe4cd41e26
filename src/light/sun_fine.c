/* SPDX-License-Identifier: MIT */
/*
 * Lights lists of fragments by the scalars of suns.h where packed words do not serve: in formats of 8 bits a channel,
 * with output tables, and on surfaces whose own colours are not linear on the screen or are multiplied by light above
 * 1. Numbers of 15 bits take the place of tables.
 */
#include "../math/division.h"
#include "../pixel/format.h"
#include "../raster/depth.h"
#include "../raster/small.h"
#include "lamps.h"
#include "suns.h"

static inline void add_reflected(int32_t colour[3], int32_t amount, const int32_t weight[3]) {
    colour[0] += amount * weight[0];
    colour[1] += amount * weight[1];
    colour[2] += amount * weight[2];
}

/*
 * Returns cos^p, Q15, given `scaled_sine` = sin^2 N'.N', 1 = 2^32, and `over` = 2^15 over the length of N', at most
 * 2^16.5.
 */
static inline uint32_t power_of_scaled(const glint_power_table *table, uint32_t scaled_sine, uint32_t over) {
    if (scaled_sine >= GLINT_SINE_WRAPPED)
        scaled_sine = 0;
    if (scaled_sine >> 2 >= table->window)
        return 0;
    const uint32_t cut = scaled_sine >> (table->index_shift - 6); /* below 2^15 */
    const uint32_t position = (cut * over >> 16) * over;          /* sin^2; the table's window is 2^29 */
    if (position >> 29)
        return 0;
    const uint16_t *node = &table->value[position >> 22];
    const int32_t fraction = (int32_t)(position >> 7 & 0x7fff);
    return (uint32_t)(node[0] - glint_shift_right((node[0] - node[1]) * fraction, 15));
}

/* Returns the highlight of a fragment, Q15, at column x and row y of the triangle's quadratics, given 2^15 over the
 * length of N'. */
static inline uint32_t find_power(const glint_row_walk *walk, const glint_lit_sun *lit, const glint_lit_fragment *f,
                                  uint32_t x, uint32_t y, uint32_t over) {
    const glint_quadratic *q = &lit->half;
    const int32_t h =
        glint_shift_right((int32_t)(q->value + y * (q->y + y * q->yy) + x * (q->x + y * q->xy + x * q->xx)), 12);
    if (h <= 0)
        return 0;
    return power_of_scaled(&walk->workspace->lamps->shading->power, f->square - (uint32_t)h * (uint32_t)h, over);
}

/* Finishes a fragment's colour by glint_mix_own_colour, which does not use 1/w of parallel rays. */
static GLINT_HOT GLINT_NOINLINE void finish_fragment(const glint_row_walk *walk, glint_lit_fragment *f,
                                                     const int32_t gloss[3]) {
    const uint32_t zeros = glint_leading_zeros((uint32_t)f->inverse_w);
    glint_mix_own_colour(walk, f, glint_reciprocal16((uint32_t)f->inverse_w << zeros >> 16), zeros, gloss);
}

/* Kinds of lighting: one light whose sum with ambient light is the colour, or any. */
enum { SUN_ONLY, SUN_ANY };

/* Finds the colours of fragments from f to before the end. */
static GLINT_INLINE void light_sun_fragments(const glint_row_walk *walk, glint_lit_fragment *f,
                                             const glint_lit_fragment *end, int kind) {
    const glint_sun_triangle *t = walk->suns;
    const glint_lamps *lamps = walk->workspace->lamps;
    const glint_lit_sun *const last = t->lit + (kind == SUN_ANY ? t->count : 1);
    for (; f != end; f++) {
        const uint32_t y = (uint32_t)(glint_fragment_row(f) - walk->slopes.row),
                       x = (uint32_t)(glint_fragment_column(f) - walk->slopes.column), square = f->square;
        const uint32_t is_short = !(square >> 30), over = glint_over_length(square << 2 * is_short) << is_short;
        int32_t gloss[3], colour[3];
        int32_t none = 0;
        GLINT_OPAQUE(none); /* else compilers store two zeros from a register of the FPU */
        for (int c = 0; c < 3; c++) {
            colour[c] = lamps->first[c];
            gloss[c] = none;
        }
        for (const glint_lit_sun *lit = t->lit; lit != last; lit++) {
            const int32_t light = (int32_t)(lit->light.value + x * lit->light.x + y * lit->light.y);
            const glint_drawn_lamp *lamp = lit->lamp;
            if (light <= lamps->gate)
                continue;
            if (light > 0)
                add_reflected(colour, (int32_t)(((uint32_t)light >> 14) * over >> 15), lamp->diffuse);
            const uint32_t power = lit->gloss ? find_power(walk, lit, f, x, y, over) : 0;
            if (power && kind == SUN_ANY && lamps->has_colours)
                add_reflected(gloss, (int32_t)power, lamp->specular);
            else if (power)
                add_reflected(colour, (int32_t)power, lamp->specular);
        }
        f->out.colour[0] = colour[0], f->out.colour[1] = colour[1], f->out.colour[2] = colour[2];
        if (kind == SUN_ANY && lamps->is_mixed)
            finish_fragment(walk, f, gloss);
    }
}

/* Lights the fragments of a list. */
static GLINT_HOT void light_sun_list(const glint_row_walk *walk, glint_lit_fragment *f, const glint_lit_fragment *end) {
    const glint_lamps *lamps = walk->workspace->lamps;
    if (GLINT_SMALL || walk->suns->count != 1 || lamps->is_mixed)
        light_sun_fragments(walk, f, end, SUN_ANY);
    else
        light_sun_fragments(walk, f, end, SUN_ONLY);
}

/* Draws a span: lists the fragments that pass the depth test, and lights the list when it is full. */
static GLINT_HOT void list_span(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    const glint_quadratic *normal = &walk->suns->normal;
    glint_lamp_list *const list = walk->list;
    glint_lit_fragment *f = &list->pixels.fragment[list->count];
    const uint32_t x = (uint32_t)(left - walk->slopes.column), y = (uint32_t)(row - walk->slopes.row);
    const uint32_t bend = 2 * normal->xx;
    glint_stepped_quadratic square = glint_begin_quadratic(normal, x, y);
    uint32_t z = glint_z_at(walk, row, left), position = ((uint32_t)row << 16) + (uint32_t)left,
             pixel = ((uint32_t)row << walk->shift) + (uint32_t)left;
    uint16_t *depth = walk->depth + pixel, *const end = depth + (right - left);
    for (; depth != end; depth++) {
        if (z >> 15 > *depth) {
            *depth = (uint16_t)(z >> 15);
            f->out.pixel = pixel;
            f->position = position;
            f->square = square.value;
            f->inverse_w = (int32_t)(z - GLINT_DEPTH_BIAS) | 1;
            if (++f == &list->pixels.fragment[GLINT_LIST_MAX]) {
                list->count = GLINT_LIST_MAX;
                glint_light_listed(walk);
                f = list->pixels.fragment;
            }
        }
        position++;
        pixel++;
        z += (uint32_t)walk->z.dx;
        glint_step_quadratic(&square, bend);
    }
    list->count = (uint32_t)(f - list->pixels.fragment);
}

glint_draw_span *glint_begin_fine_suns(glint_row_walk *walk) {
    glint_sun_triangle *t = walk->suns;
    if (walk->draw->extra && glint_find_room(walk->triangle.corners) > 3)
        return 0;
    glint_begin_lamp_list(walk);
    walk->list->light = light_sun_list;
    for (glint_lit_sun *lit = t->lit, *end = lit + t->count; lit != end; lit++)
        lit->lamp = &walk->workspace->lamps->lamps[lit->sun - t->suns->suns];
    return list_span;
}
