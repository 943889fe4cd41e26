/* SPDX-License-Identifier: MIT */
/* Draws spans under one sun in 16 bits a pixel: depth test, light and store are one loop. suns.h */
#include "../pixel/pixel.h"
#include "suns.h"

enum { SPAN_MATT, SPAN_HALF, SPAN_MIRROR };

/* Returns the word of a fragment that faces the light, given N'.L, N'.N' and what glint_lit_sun has of highlights. */
static GLINT_INLINE uint32_t light_fragment(const glint_sun_triangle *t, uint32_t light, uint32_t square, uint32_t half,
                                            uint32_t light_view, int kind) {
    const uint32_t over = glint_over_normal(square);
    uint32_t word = t->ramp[(light >> 14) * over >> 20];
    if (kind == SPAN_MATT)
        return word;
    const int32_t h = glint_shift_right((int32_t)half, 12);
    const uint32_t sine_square = kind == SPAN_MIRROR ? (square >> 16) * (light_view >> 12) - (light >> 13) * (uint32_t)h
                                                     : square - (uint32_t)h * (uint32_t)h;
    const uint32_t index = ((sine_square >> 16) * over >> 14) * over >> t->shift;
    if (index < GLINT_GLOSS_ENTRIES)
        word += t->gloss[index];
    else if (sine_square >= GLINT_SINE_WRAPPED)
        word += t->gloss[0];
    else
        return word;
    const uint32_t overflow = word & GLINT_SPREAD_GUARD;
    if (overflow) {
        word |= overflow - (overflow >> 9);
        GLINT_BARRIER(); /* makes this a branch, as it is seldom taken */
    }
    return word;
}

/* Draws a span. Numbers that are the same for all pixels are read from the triangle at each: registers are all in use,
 * and copies on the stack would cost time. */
static GLINT_INLINE void draw_span(const glint_row_walk *walk, int32_t row, int32_t left, int32_t right, int kind,
                                   int swaps) {
    const glint_sun_triangle *t = walk->suns;
    const uint32_t x = (uint32_t)(left - walk->slopes.column), y = (uint32_t)(row - walk->slopes.row);
    uint32_t z = glint_z_at(walk, row, left), light = t->lit->light.value + x * t->lit->light.x + y * t->lit->light.y;
    glint_stepped_quadratic square = glint_begin_quadratic(&t->normal, x, y), half = {0, 0}, light_view = {0, 0};
    if (kind != SPAN_MATT)
        half = glint_begin_quadratic(&t->lit->half, x, y);
    if (kind == SPAN_MIRROR)
        light_view = glint_begin_quadratic(&t->lit->light_view, x, y);
    uint16_t *depth = walk->depth + ((uint32_t)row << walk->shift) + left, *const end = depth + (right - left);
    do {
        GLINT_OPAQUE(t);
        uint32_t here = z >> 15;
        GLINT_OPAQUE(here); /* else compilers compute it twice */
        if (here > *depth) {
            uint32_t word = t->dark;
            *depth = (uint16_t)here;
            if ((int32_t)light > 0)
                word = light_fragment(t, light, square.value, half.value, light_view.value, kind);
            word = glint_spread_pack(word);
            *(uint16_t *)((uintptr_t)depth + t->from_depth) =
                (uint16_t)(swaps ? glint_to_high_first(word & 0xffff) : word);
        }
        z += t->z_dx;
        light += t->light_dx;
        glint_step_quadratic(&square, t->square_bend);
        if (kind != SPAN_MATT)
            glint_step_quadratic(&half, t->half_bend);
        if (kind == SPAN_MIRROR)
            glint_step_quadratic(&light_view, t->light_view_bend);
    } while (++depth != end);
}

#if GLINT_SMALL
/* In a library built for size, one function draws spans of all kinds, and small triangles have none of their own. */
#define DEFINE_SPANS(suffix, swaps)                                                                            \
    static GLINT_HOT void span_##suffix(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {      \
        const glint_sun_triangle *t = walk->suns;                                                              \
        draw_span(walk, row, left, right, !t->lit->gloss ? SPAN_MATT : SPAN_HALF + t->suns->is_mirror, swaps); \
    }                                                                                                          \
    const glint_sun_spans glint_sun_spans_##suffix = {span_##suffix, span_##suffix, span_##suffix,             \
                                                      glint_draw_small_suns}
#else
#define DEFINE_SPANS(suffix, swaps)                                                                         \
    static GLINT_HOT void matt_##suffix(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {   \
        draw_span(walk, row, left, right, SPAN_MATT, swaps);                                                \
    }                                                                                                       \
    static GLINT_HOT void half_##suffix(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {   \
        draw_span(walk, row, left, right, SPAN_HALF, swaps);                                                \
    }                                                                                                       \
    static GLINT_HOT void mirror_##suffix(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) { \
        draw_span(walk, row, left, right, SPAN_MIRROR, swaps);                                              \
    }                                                                                                       \
    const glint_sun_spans glint_sun_spans_##suffix = {matt_##suffix, half_##suffix, mirror_##suffix,        \
                                                      glint_draw_small_##suffix}
#endif

DEFINE_SPANS(rgb565, 0);
DEFINE_SPANS(rgb565_be, 1);
