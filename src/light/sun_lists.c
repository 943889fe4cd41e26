/* SPDX-License-Identifier: MIT */
/* Lists of pixels that directional lights light, in packed words: each light goes over the list of a span. suns.h */
#include "../pixel/format.h"
#include "../raster/small.h"
#include "suns.h"

/* Pixels that are lit together: fewer take less stack, and change no bit. */
#if GLINT_SMALL
#define LIST_MAX 8
#else
#define LIST_MAX 16
#endif

/* Lists the pixels of a span that pass the depth test, with the word that sums begin with. @return where the next would
 * go */
static glint_spread *list_visible(const glint_row_walk *walk, int32_t row, int32_t left, int32_t right, uint32_t first,
                                  glint_spread *to) {
    const glint_sun_triangle *t = walk->suns;
    const glint_quadratic *q = &t->normal;
    const uint32_t ud = (uint32_t)(left - walk->slopes.column), ui = (uint32_t)(row - walk->slopes.row);
    uint32_t offset = ((uint32_t)row << walk->shift) + (uint32_t)left, z = glint_z_at(walk, row, left);
    const uint32_t slope = q->x + ui * q->xy, curve = ud * q->xx, bend = 2 * q->xx;
    uint32_t square = q->value + ui * (q->y + ui * q->yy) + ud * (slope + curve), step = slope + 2 * curve + q->xx;
    uint16_t *depth = walk->depth + offset, *const end = depth + (right - left);
    const uint32_t dx = (uint32_t)walk->z.dx;
    for (; depth != end; depth++) {
        if (z >> 15 > *depth) {
            *depth = (uint16_t)(z >> 15);
            *to++ = (glint_spread){offset, first, square, glint_over_normal(square)};
        }
        offset++;
        z += dx;
        square += step;
        step += bend;
    }
    return to;
}

/* What of a light a pixel has: N'.L, N'.H or N'.V, and (1 + L.V) / 2. */
typedef struct sun_scalars {
    int32_t light;
    uint32_t half, along;
} sun_scalars;

/* Returns which entry of gloss a pixel has; it need not be lit from the front. */
static inline uint32_t find_entry(const glint_suns *suns, const glint_spread *p, sun_scalars of) {
    const int32_t h = glint_shift_right((int32_t)of.half, 12);
    if (suns->is_mirror)
        return glint_entry_of_sine(
            suns, (p->square >> 16) * (of.along >> 12) - (uint32_t)glint_shift_right(of.light, 13) * (uint32_t)h,
            p->over);
    return glint_entry_of_sine(suns, p->square - (uint32_t)h * (uint32_t)h, p->over);
}

/* Adds a light to a pixel's colour, given N'.L and its entry of gloss. */
void glint_add_sun(const glint_row_walk *walk, const glint_drawn_sun *sun, glint_spread *p, int32_t light,
                   uint32_t entry) {
    const glint_shading *shading = walk->draw->shading;
    uint32_t colour = p->colour;
    if (light > 0) {
        const uint32_t at = ((uint32_t)light >> 14) * p->over >> 20;
        colour = (colour & shading->suns->keeps) + (sun->ramp ? sun->ramp[at] : glint_ramp_word(shading, sun, at));
    }
    if (entry < GLINT_GLOSS_ENTRIES)
        colour = glint_clamp_word(colour) + (sun->gloss ? sun->gloss[entry] : glint_gloss_word(shading, sun, entry));
    p->colour = glint_clamp_word(colour);
}

/* Sets a quadratic of a row. */
static inline void set_row(const glint_quadratic *q, uint32_t i, uint32_t *at, uint32_t *x, uint32_t *xx) {
    *at = q->value + i * (q->y + i * q->yy);
    *x = q->x + i * q->xy;
    *xx = q->xx;
}

/* What of a light is added. */
enum { DIFFUSE = 1, GLOSS = 2, BOTH = 3 };

/*
 * Adds a light, or a part of it, to the pixels of a row from p to before the end; the row's first column is that of
 * pixel `begin`. It is plain: it is gated or all corners face it, it adds to what is there, and its tables are there.
 */
static GLINT_INLINE void light_list(const glint_row_walk *walk, const glint_lit_sun *lit, int32_t row, uint32_t begin,
                                    glint_spread *p, const glint_spread *end, int part, int is_mirror) {
    const int shines = part & GLOSS;
    const uint32_t i = (uint32_t)(row - walk->slopes.row), light_x = lit->light.x,
                   light0 = lit->light.value + i * lit->light.y,
                   shift = walk->suns->suns->shift, *const ramp = lit->sun->ramp, *const gloss = lit->sun->gloss;
    uint32_t half = 0, half_x = 0, half_xx = 0, along = 0, along_x = 0, along_xx = 0;
    if (shines)
        set_row(&lit->half, i, &half, &half_x, &half_xx);
    if (is_mirror)
        set_row(&lit->along, i, &along, &along_x, &along_xx);
    for (; p != end; p++) {
        const uint32_t d = p->offset - begin, light = light0 + d * light_x, over = p->over;
        if ((int32_t)light <= 0)
            continue;
        uint32_t colour = p->colour;
        if (part & DIFFUSE)
            colour += ramp[(light >> 14) * over >> 20];
        if (shines) {
            const int32_t h = glint_shift_right((int32_t)(half + d * (half_x + d * half_xx)), 12);
            const uint32_t square = p->square,
                           sine = is_mirror ? (square >> 16) * ((along + d * (along_x + d * along_xx)) >> 12) -
                                                  (light >> 13) * (uint32_t)h
                                            : square - (uint32_t)h * (uint32_t)h;
            uint32_t at = ((sine >> 16) * over >> 14) * over >> shift;
            if (sine >= GLINT_SINE_WRAPPED)
                at = 0;
            if (at < GLINT_GLOSS_ENTRIES)
                colour = (part & DIFFUSE ? glint_clamp_word(colour) : colour) + gloss[at];
        }
        p->colour = glint_clamp_word(colour);
    }
}

#define DEFINE_LIGHT_LIST(name, part, is_mirror)                                                                       \
    static GLINT_NOINLINE void name(const glint_row_walk *walk, const glint_lit_sun *lit, int32_t row, uint32_t begin, \
                                    glint_spread *p, const glint_spread *end) {                                        \
        light_list(walk, lit, row, begin, p, end, part, is_mirror);                                                    \
    }

DEFINE_LIGHT_LIST(light_list_matt, DIFFUSE, 0)
DEFINE_LIGHT_LIST(light_list_half, BOTH, 0)
DEFINE_LIGHT_LIST(light_list_mirror, BOTH, 1)
DEFINE_LIGHT_LIST(add_gloss_half, GLOSS, 0)

/* The same of any light. */
static GLINT_NOINLINE void light_list_any(const glint_row_walk *walk, const glint_lit_sun *lit, int32_t row,
                                          uint32_t begin, glint_spread *p, const glint_spread *end, int part) {
    const uint32_t i = (uint32_t)(row - walk->slopes.row);
    uint32_t half = 0, half_x = 0, half_xx = 0, along = 0, along_x = 0, along_xx = 0;
    if (lit->gloss)
        set_row(&lit->half, i, &half, &half_x, &half_xx);
    if (lit->gloss && walk->suns->suns->is_mirror)
        set_row(&lit->along, i, &along, &along_x, &along_xx);
    for (; p != end; p++) {
        const uint32_t d = p->offset - begin;
        const sun_scalars of = {(int32_t)(lit->light.value + i * lit->light.y + d * lit->light.x),
                                half + d * (half_x + d * half_xx), along + d * (along_x + d * along_xx)};
        if (of.light > walk->suns->suns->gate)
            glint_add_sun(walk, lit->sun, p, part & DIFFUSE ? of.light : 0,
                          lit->gloss && part & GLOSS ? find_entry(walk->suns->suns, p, of) : GLINT_GLOSS_ENTRIES);
    }
}

/* Takes the larger of each channel and ambient light. */
GLINT_NOINLINE void glint_take_larger(uint32_t dark, glint_spread *p, const glint_spread *end) {
    for (; p != end; p++) {
        const uint32_t is_more = ((p->colour | GLINT_SPREAD_GUARD) - dark) & GLINT_SPREAD_GUARD,
                       mask = (is_more - (is_more >> 9)) | is_more >> 10;
        p->colour = (p->colour & mask) | (dark & ~mask);
    }
}

/* Draws a span: lists its pixels, each light goes over the list, and all are stored. */
void glint_draw_sun_list(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    const glint_sun_triangle *t = walk->suns;
    glint_spread list[LIST_MAX];
    for (int32_t to; left < right; left = to) {
        to = glint_least(right, left + LIST_MAX);
        const uint32_t begin = ((uint32_t)row << walk->shift) + (uint32_t)walk->slopes.column;
        glint_spread *const end = list_visible(walk, row, left, to, t->suns->first, list);
        if (end == list)
            continue;
        for (const glint_lit_sun *lit = t->lit, *last = lit + t->count; lit != last; lit++) {
            if (GLINT_SMALL || !lit->is_plain)
                light_list_any(walk, lit, row, begin, list, end, BOTH);
            else if (!lit->gloss)
                light_list_matt(walk, lit, row, begin, list, end);
            else if (t->suns->is_mirror)
                light_list_mirror(walk, lit, row, begin, list, end);
            else
                light_list_half(walk, lit, row, begin, list, end);
        }
        if (t->suns->takes_most)
            glint_take_larger(t->suns->dark, list, end);
        walk->frame->config.format->store_spread(walk->pixels, walk->shift, list, end);
    }
}

/* ---- Surfaces with colours of their own ---- */

void glint_begin_own(glint_sun_triangle *t, const glint_slopes *s) {
    const int16_t *a = t->own_at[0], *b = t->own_at[1], *c = t->own_at[2];
    for (int k = 0; k < 3; k++) {
        const int32_t d1 = b[k] - a[k], d2 = c[k] - a[k];
        t->own[k] = (glint_sun_plane){((uint32_t)a[k] << 14) + glint_weigh(d1, s->start1, d2, s->start2),
                                      glint_weigh(d1, s->x1, d2, s->x2), glint_weigh(d1, s->y1, d2, s->y2)};
    }
}

/* A channel of a word times that of a colour, 1 = 2^15; rounding may have taken the latter below 0. */
static inline uint32_t multiply_channel(uint32_t channel, int32_t own) {
    return channel * (uint32_t)glint_most(own, 0) + (1u << 14);
}

static inline uint32_t multiply_word(uint32_t word, int32_t red, int32_t green, int32_t blue) {
    return (multiply_channel(word >> 10 & 0x3ff, red) >> 15 << 10) + (multiply_channel(word >> 21, green) >> 15 << 21) +
           (multiply_channel(word & 0x1ff, blue) >> 15);
}

uint32_t glint_multiply_word(const glint_suns *suns, uint32_t word, int32_t red, int32_t green, int32_t blue) {
    return multiply_word(word, red, green, blue) + suns->half;
}

/* Multiplies the pixels of a row by the surface's own colours. */
static GLINT_NOINLINE void multiply_list(const glint_row_walk *walk, int32_t row, uint32_t begin, glint_spread *p,
                                         const glint_spread *end) {
    const glint_sun_plane *own = walk->suns->own;
    const uint32_t i = (uint32_t)(row - walk->slopes.row), red = own[0].value + i * own[0].y,
                   green = own[1].value + i * own[1].y, blue = own[2].value + i * own[2].y, red_x = own[0].x,
                   green_x = own[1].x, blue_x = own[2].x, half = walk->suns->suns->half;
    for (; p != end; p++) {
        const uint32_t d = p->offset - begin;
        p->colour = multiply_word(p->colour, glint_shift_right((int32_t)(red + d * red_x), 14),
                                  glint_shift_right((int32_t)(green + d * green_x), 14),
                                  glint_shift_right((int32_t)(blue + d * blue_x), 14)) +
                    half;
    }
}

void glint_draw_own_list(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    const glint_sun_triangle *t = walk->suns;
    const glint_lit_sun *const last = t->lit + t->count;
    glint_spread list[LIST_MAX];
    for (int32_t to; left < right; left = to) {
        to = glint_least(right, left + LIST_MAX);
        const uint32_t begin = ((uint32_t)row << walk->shift) + (uint32_t)walk->slopes.column;
        glint_spread *const end = list_visible(walk, row, left, to, t->suns->dark - t->suns->half, list);
        if (end == list)
            continue;
        for (const glint_lit_sun *lit = t->lit; lit != last; lit++) {
            if (GLINT_SMALL || !lit->is_plain)
                light_list_any(walk, lit, row, begin, list, end, DIFFUSE);
            else
                light_list_matt(walk, lit, row, begin, list, end);
        }
        multiply_list(walk, row, begin, list, end);
        for (const glint_lit_sun *lit = t->lit; lit != last; lit++) {
            if (lit->gloss && (GLINT_SMALL || !lit->is_plain || t->suns->is_mirror))
                light_list_any(walk, lit, row, begin, list, end, GLOSS);
            else if (lit->gloss)
                add_gloss_half(walk, lit, row, begin, list, end);
        }
        walk->frame->config.format->store_spread(walk->pixels, walk->shift, list, end);
    }
}
