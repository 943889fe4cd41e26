/* SPDX-License-Identifier: MIT */
/* Lights lists of pixels by suns, in packed words: each light is added to all pixels of a span. suns.h */
#include "../pixel/format.h"
#include "../raster/small.h"
#include "lamps.h"
#include "suns.h"
#include "wear.h"

/* Returns the next pixel of a list. Compilers that see where it comes from keep two pointers, and copy one at each
 * pixel. */
static GLINT_INLINE glint_spread *next_pixel(glint_spread *p) {
    p++;
    GLINT_OPAQUE(p);
    return p;
}

/* Lists the pixels of a span that pass the depth test; `first` is the word that their sums begin with. @return the end
 * of the list */
static glint_spread *list_visible(const glint_row_walk *walk, int32_t row, int32_t left, int32_t right, uint32_t first,
                                  glint_spread *to) {
    const glint_sun_triangle *t = walk->suns;
    const uint32_t x = (uint32_t)(left - walk->slopes.column), y = (uint32_t)(row - walk->slopes.row);
    uint32_t offset = ((uint32_t)row << walk->shift) + (uint32_t)left, z = glint_z_at(walk, row, left);
    const uint32_t bend = 2 * t->normal.xx;
    glint_stepped_quadratic square = glint_begin_quadratic(&t->normal, x, y);
    uint16_t *depth = walk->depth + offset, *const end = depth + (right - left);
    const uint32_t dx = (uint32_t)walk->z.dx;
    for (; depth != end; depth++) {
        if (z >> 15 > *depth) {
            *depth = (uint16_t)(z >> 15);
            *to = (glint_spread){offset, first, square.value, glint_over_normal(square.value)};
            to = next_pixel(to);
        }
        offset++;
        z += dx;
        glint_step_quadratic(&square, bend);
    }
    return to;
}

/* The scalars of a light at a pixel: see glint_lit_sun. */
typedef struct sun_scalars {
    int32_t light;
    uint32_t half, light_view;
} sun_scalars;

/* Returns the index of a pixel's entry of gloss; the pixel may face away from the light. */
static inline uint32_t find_entry(const glint_suns *suns, const glint_spread *p, sun_scalars scalars) {
    const int32_t h = glint_shift_right((int32_t)scalars.half, 12);
    if (suns->is_mirror)
        return glint_entry_of_sine(suns,
                                   (p->square >> 16) * (scalars.light_view >> 12) -
                                       (uint32_t)glint_shift_right(scalars.light, 13) * (uint32_t)h,
                                   p->over);
    return glint_entry_of_sine(suns, p->square - (uint32_t)h * (uint32_t)h, p->over);
}

void glint_add_sun(const glint_row_walk *walk, const glint_drawn_sun *sun, glint_spread *p, int32_t light,
                   uint32_t entry) {
    const glint_shading *shading = walk->draw->shading;
    uint32_t colour = p->colour;
    if (light > 0) {
        const uint32_t index = ((uint32_t)light >> 14) * p->over >> 20;
        colour =
            (colour & shading->suns->sum_mask) + (sun->ramp ? sun->ramp[index] : glint_ramp_word(shading, sun, index));
    }
    if (entry < GLINT_GLOSS_ENTRIES)
        colour = glint_clamp_word(colour) + (sun->gloss ? sun->gloss[entry] : glint_gloss_word(shading, sun, entry));
    p->colour = glint_clamp_word(colour);
}

/* A quadratic in one row: xx column^2 + x column + value. */
typedef struct row_quadratic {
    uint32_t xx, x, value;
} row_quadratic;

static inline row_quadratic quadratic_of_row(const glint_quadratic *q, uint32_t y) {
    return (row_quadratic){q->xx, q->x + y * q->xy, q->value + y * (q->y + y * q->yy)};
}

static inline uint32_t quadratic_at(const row_quadratic *q, uint32_t x) {
    return q->value + x * (q->x + x * q->xx);
}

/* The part of a light that is added. */
enum { DIFFUSE = 1, GLOSS = 2, BOTH = 3 };

/*
 * Adds a part of a light to the pixels of a row from p to before the end, at least one. `begin` is the offset of the
 * row's pixel at column walk->slopes.column. The light is plain: see glint_lit_sun.
 */
static GLINT_INLINE void light_list(const glint_row_walk *walk, const glint_lit_sun *lit, int32_t row, uint32_t begin,
                                    glint_spread *p, const glint_spread *end, int part, int is_mirror) {
    const int shines = part & GLOSS;
    const uint32_t y = (uint32_t)(row - walk->slopes.row), light_x = lit->light.x,
                   light_of_row = lit->light.value + y * lit->light.y,
                   shift = walk->suns->suns->shift, *const ramp = lit->sun->ramp, *const gloss = lit->sun->gloss;
    row_quadratic half = {0, 0, 0}, light_view = {0, 0, 0};
    if (shines)
        half = quadratic_of_row(&lit->half, y);
    if (is_mirror)
        light_view = quadratic_of_row(&lit->light_view, y);
    do {
        const uint32_t x = p->offset - begin, light = light_of_row + x * light_x, over = p->over;
        if ((int32_t)light <= 0)
            continue;
        uint32_t colour = p->colour;
        if (part & DIFFUSE)
            colour += ramp[(light >> 14) * over >> 20];
        if (shines) {
            const int32_t h = glint_shift_right((int32_t)quadratic_at(&half, x), 12);
            const uint32_t square = p->square,
                           sine_square = is_mirror ? (square >> 16) * (quadratic_at(&light_view, x) >> 12) -
                                                         (light >> 13) * (uint32_t)h
                                                   : square - (uint32_t)h * (uint32_t)h;
            uint32_t index = ((sine_square >> 16) * over >> 14) * over >> shift;
            if (sine_square >= GLINT_SINE_WRAPPED)
                index = 0;
            if (index < GLINT_GLOSS_ENTRIES)
                colour = (part & DIFFUSE ? glint_clamp_word(colour) : colour) + gloss[index];
        }
        p->colour = glint_clamp_word(colour);
    } while ((p = next_pixel(p)) != end);
}

#define DEFINE_LIGHT_LIST(name, part, is_mirror)                                                                 \
    static GLINT_HOT GLINT_NOINLINE void name(const glint_row_walk *walk, const glint_lit_sun *lit, int32_t row, \
                                              uint32_t begin, glint_spread *p, const glint_spread *end) {        \
        light_list(walk, lit, row, begin, p, end, part, is_mirror);                                              \
    }

DEFINE_LIGHT_LIST(light_list_matt, DIFFUSE, 0)
DEFINE_LIGHT_LIST(light_list_half, BOTH, 0)
DEFINE_LIGHT_LIST(light_list_mirror, BOTH, 1)
DEFINE_LIGHT_LIST(add_gloss_half, GLOSS, 0)

/* Does what light_list does for any light. */
static GLINT_HOT GLINT_NOINLINE void light_list_any(const glint_row_walk *walk, const glint_lit_sun *lit, int32_t row,
                                                    uint32_t begin, glint_spread *p, const glint_spread *end,
                                                    int part) {
    const uint32_t y = (uint32_t)(row - walk->slopes.row);
    row_quadratic half = {0, 0, 0}, light_view = {0, 0, 0};
    if (lit->gloss)
        half = quadratic_of_row(&lit->half, y);
    if (lit->gloss && walk->suns->suns->is_mirror)
        light_view = quadratic_of_row(&lit->light_view, y);
    for (; p != end; p++) {
        const uint32_t x = p->offset - begin;
        const sun_scalars scalars = {(int32_t)(lit->light.value + y * lit->light.y + x * lit->light.x),
                                     quadratic_at(&half, x), quadratic_at(&light_view, x)};
        if (scalars.light > walk->suns->suns->gate)
            glint_add_sun(walk, lit->sun, p, part & DIFFUSE ? scalars.light : 0,
                          lit->gloss && part & GLOSS ? find_entry(walk->suns->suns, p, scalars) : GLINT_GLOSS_ENTRIES);
    }
}

GLINT_HOT GLINT_NOINLINE void glint_take_larger(uint32_t dark, glint_spread *p, const glint_spread *end) {
    for (; p != end; p++) {
        /* the guard bit of a channel survives the subtraction if the channel is the larger one */
        const uint32_t is_larger = ((p->colour | GLINT_SPREAD_GUARD) - dark) & GLINT_SPREAD_GUARD,
                       mask = (is_larger - (is_larger >> 9)) | is_larger >> 10;
        p->colour = (p->colour & mask) | (dark & ~mask);
    }
}

/* ---- Surfaces with colours of their own ---- */

void glint_begin_own(glint_sun_triangle *t, const glint_slopes *slopes) {
    const int16_t *a = t->own_at[0], *b = t->own_at[1], *c = t->own_at[2];
    for (int k = 0; k < 3; k++) {
        const int32_t d1 = b[k] - a[k], d2 = c[k] - a[k];
        t->own[k] =
            (glint_sun_plane){((uint32_t)a[k] << 14) + glint_weigh(d1, slopes->start1, d2, slopes->start2),
                              glint_weigh(d1, slopes->x1, d2, slopes->x2), glint_weigh(d1, slopes->y1, d2, slopes->y2)};
    }
}

uint32_t glint_multiply_word(const glint_suns *suns, uint32_t word, int32_t red, int32_t green, int32_t blue) {
    return glint_times_colour(word, red, green, blue) + suns->half_level;
}

/* Multiplies the pixels of a row by the surface's own colours. */
static GLINT_HOT GLINT_NOINLINE void multiply_list(const glint_row_walk *walk, int32_t row, uint32_t begin,
                                                   glint_spread *p, const glint_spread *end) {
    const glint_sun_plane *own = walk->suns->own;
    const uint32_t y = (uint32_t)(row - walk->slopes.row), red = own[0].value + y * own[0].y,
                   green = own[1].value + y * own[1].y, blue = own[2].value + y * own[2].y, red_x = own[0].x,
                   green_x = own[1].x, blue_x = own[2].x, half_level = walk->suns->suns->half_level;
    for (; p != end; p++) {
        const uint32_t x = p->offset - begin;
        p->colour = glint_times_colour(p->colour, glint_shift_right((int32_t)(red + x * red_x), 14),
                                       glint_shift_right((int32_t)(green + x * green_x), 14),
                                       glint_shift_right((int32_t)(blue + x * blue_x), 14)) +
                    half_level;
    }
}

/* ---- Spans ---- */

/* Adds a part of all lights to the pixels of a row. */
static GLINT_SPECIAL void add_lights_to_list(const glint_row_walk *walk, int32_t row, uint32_t begin, glint_spread *p,
                                             const glint_spread *end, int part) {
    const glint_sun_triangle *t = walk->suns;
    for (const glint_lit_sun *lit = t->lit, *last = lit + t->count; lit != last; lit++) {
        if (part == GLOSS && !lit->gloss)
            continue;
        if (GLINT_SMALL || !lit->is_plain || (part == GLOSS && t->suns->is_mirror))
            light_list_any(walk, lit, row, begin, p, end, part);
        else if (part == GLOSS)
            add_gloss_half(walk, lit, row, begin, p, end);
        else if (part == DIFFUSE || !lit->gloss)
            light_list_matt(walk, lit, row, begin, p, end);
        else if (t->suns->is_mirror)
            light_list_mirror(walk, lit, row, begin, p, end);
        else
            light_list_half(walk, lit, row, begin, p, end);
    }
}

/* Colours of a surface multiply ambient and diffuse light, before highlights are added. */
GLINT_HOT void glint_draw_sun_list(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    const glint_suns *suns = walk->suns->suns;
    const int has_own = walk->draw->extra || walk->draw->texture;
    const uint32_t begin = ((uint32_t)row << walk->shift) + (uint32_t)walk->slopes.column,
                   first = has_own ? suns->dark - suns->half_level : suns->first;
    glint_spread *const list = walk->list->pixels.words;
    for (int32_t to; left < right; left = to) {
        to = glint_least(right, left + GLINT_WORDS_MAX);
        glint_spread *const end = list_visible(walk, row, left, to, first, list);
        if (end == list)
            continue;
        if (has_own) {
            add_lights_to_list(walk, row, begin, list, end, DIFFUSE);
            if (walk->draw->texture)
                walk->draw->texture->type->stage->multiply(walk, row, (uint32_t)row << walk->shift, list, end);
            if (walk->draw->extra)
                multiply_list(walk, row, begin, list, end);
            add_lights_to_list(walk, row, begin, list, end, GLOSS);
        } else {
            add_lights_to_list(walk, row, begin, list, end, BOTH);
        }
        if (suns->takes_most)
            glint_take_larger(suns->dark, list, end);
        walk->frame->config.format->store_spread(walk->pixels, walk->shift, list, end);
    }
}
