/* SPDX-License-Identifier: MIT */
/* Small triangles under suns: each pixel is lit from the corners, without set-up. suns.h */
#include "../pixel/format.h"
#include "../pixel/pixel.h"
#include "../raster/small.h"
#include "suns.h"

/* A pixel of a small triangle: weights of its corners, 1 = 2^14, and N', 1 = 2^15. */
typedef struct small_pixel {
    int32_t row, column, a, b, c, n[3];
} small_pixel;

/* Sets N' of a pixel. @return N'.N', 1 = 2^30 */
static GLINT_INLINE uint32_t find_normal(const glint_sun_triangle *t, small_pixel *of) {
    const int16_t *na = t->corners[0]->attribute, *nb = t->corners[1]->attribute, *nc = t->corners[2]->attribute;
    const int32_t a = glint_shift_right(of->a * t->weight[0], 14), b = glint_shift_right(of->b * t->weight[1], 14),
                  c = glint_shift_right(of->c * t->weight[2], 14);
    const int32_t x = glint_shift_right(na[0] * a + nb[0] * b + nc[0] * c, 15),
                  y = glint_shift_right(na[1] * a + nb[1] * b + nc[1] * c, 15),
                  z = glint_shift_right(na[2] * a + nb[2] * b + nc[2] * c, 15);
    of->n[0] = x, of->n[1] = y, of->n[2] = z;
    return (uint32_t)(x * x + y * y + z * z);
}

/* The least N'.N' of which find_normal's bits serve; N' of corners may be opposite. 1 = 2^30 */
#define LEAST_SMALL_SQUARE (1u << 28)

/* Brings a component of a vector, of 16 bits, from corners to a pixel. */
static inline int32_t mix_corners(const small_pixel *of, int32_t a, int32_t b, int32_t c) {
    return glint_shift_right(a * of->a + b * of->b + c * of->c + (1 << 13), 14);
}

/* H or V of a pixel, linear between corners, 1 = 2^14; what its square lacks of 1, 2^28; and N'.H of a unit H, 2^16. */
typedef struct small_half {
    int32_t v[3], lacking, along;
} small_half;

static GLINT_INLINE small_half find_half(const glint_sun_triangle *t, const small_pixel *of, uint32_t term) {
    const int16_t *a = t->terms[0][term].v, *b = t->terms[1][term].v, *c = t->terms[2][term].v;
    const int32_t x = mix_corners(of, a[0], b[0], c[0]), y = mix_corners(of, a[1], b[1], c[1]),
                  z = mix_corners(of, a[2], b[2], c[2]), lacking = (1 << 28) - x * x - y * y - z * z,
                  h = glint_shift_right(of->n[0] * x + of->n[1] * y + of->n[2] * z, 13);
    return (small_half){{x, y, z}, lacking, h + glint_shift_right(h * glint_shift_right(lacking, 13), 16)};
}

/* Returns the entry of gloss of a pixel, given its light's first term, and N'.L, 1 = 2^30. */
static GLINT_NOINLINE uint32_t find_small_entry(const glint_row_walk *walk, const glint_drawn_sun *sun,
                                                const small_pixel *of, const glint_spread *p, uint32_t term,
                                                int32_t light) {
    const glint_suns *suns = walk->suns->suns;
    const small_half half = find_half(walk->suns, of, term);
    const int32_t *n = of->n, over = (int32_t)p->over;
    if (half.lacking >= suns->small_bend) {
        const int32_t unit[3] = {glint_shift_right(n[0] * over, 14), glint_shift_right(n[1] * over, 14),
                                 glint_shift_right(n[2] * over, 14)};
        return glint_find_sine(walk, sun, of->row, of->column, unit) >> suns->shift;
    }
    if (!suns->is_mirror)
        return half.along <= 0
                   ? GLINT_GLOSS_ENTRIES
                   : glint_entry_of_sine(suns, p->square - (uint32_t)half.along * (uint32_t)half.along, p->over);
    const int32_t along =
        glint_most(glint_shift_right(glint_dot32(sun->light, half.v), 14), 4 - (1 << 15)); /* L.V, 2^15 */
    return glint_entry_of_sine(
        suns,
        (p->square >> 16) *
                (uint32_t)((1 << 15) + along + glint_shift_right(along * glint_shift_right(half.lacking, 13), 16)) -
            (uint32_t)glint_shift_right(light, 14) * (uint32_t)half.along,
        p->over);
}

/* Adds all lights to a pixel: their diffuse part, highlights, or both. */
static GLINT_INLINE void add_lights(const glint_row_walk *walk, const small_pixel *of, glint_spread *p, int is_diffuse,
                                    int is_gloss) {
    const glint_suns *suns = walk->suns->suns;
    uint32_t term = 0;
    for (const glint_drawn_sun *sun = suns->suns, *end = sun + suns->count; sun != end; sun++) {
        const int32_t light = glint_dot32(of->n, sun->light);
        if (light > suns->gate)
            glint_add_sun(walk, sun, p, is_diffuse ? glint_shift_right(light, 1) : 0,
                          is_gloss && sun->shines ? find_small_entry(walk, sun, of, p, term, light)
                                                  : GLINT_GLOSS_ENTRIES);
        term += sun->shines;
    }
}

/* Lights a pixel of a surface with its own colours. */
static GLINT_NOINLINE void add_lights_to_own(const glint_row_walk *walk, const small_pixel *of, glint_spread *p) {
    const glint_sun_triangle *t = walk->suns;
    const int16_t *a = t->own_at[0], *b = t->own_at[1], *c = t->own_at[2];
    p->colour = t->suns->dark - t->suns->half_level;
    add_lights(walk, of, p, 1, 0);
    p->colour = glint_multiply_word(t->suns, p->colour, mix_corners(of, a[0], b[0], c[0]),
                                    mix_corners(of, a[1], b[1], c[1]), mix_corners(of, a[2], b[2], c[2]));
    add_lights(walk, of, p, 0, 1);
}

/* Lights a pixel by all lights, and stores it. */
static GLINT_NOINLINE void draw_small_pixel(const glint_row_walk *walk, int32_t row, int32_t column, int32_t b,
                                            int32_t c) {
    const glint_sun_triangle *t = walk->suns;
    const glint_suns *suns = t->suns;
    small_pixel of = {row, column, (1 << 14) - b - c, b, c, {0}};
    uint32_t square = find_normal(t, &of);
    while (square < LEAST_SMALL_SQUARE) {
        of.n[0] *= 2, of.n[1] *= 2, of.n[2] = 2 * of.n[2] + !square;
        square = (uint32_t)glint_dot32(of.n, of.n);
    }
    square <<= 2;
    glint_spread p = {((uint32_t)row << walk->shift) + (uint32_t)column, suns->first, square,
                      glint_over_normal(square)};
    if (walk->draw->extra)
        add_lights_to_own(walk, &of, &p);
    else
        add_lights(walk, &of, &p, 1, 1);
    if (suns->takes_most)
        glint_take_larger(suns->dark, &p, &p + 1);
    walk->frame->config.format->store_spread(walk->pixels, walk->shift, &p, &p + 1);
}

/* Lights a pixel as draw_small_pixel does by one light, whose ramp holds all light. @return its word, or 0 where that
 * is to do it: no word is 0 */
static GLINT_INLINE uint32_t light_pixel(const glint_sun_triangle *t, int32_t b, int32_t c) {
    const glint_suns *suns = t->suns;
    small_pixel of = {0, 0, (1 << 14) - b - c, b, c, {0}};
    uint32_t square = find_normal(t, &of);
    const int32_t light = glint_dot32(of.n, suns->suns->light);
    if (square < LEAST_SMALL_SQUARE)
        return 0;
    if (light <= 0)
        return suns->dark;
    square <<= 2;
    const uint32_t over = glint_over_normal(square), word = suns->suns->ramp[((uint32_t)light >> 15) * over >> 20];
    const small_half half = find_half(t, &of, 0);
    if (half.lacking >= suns->small_bend)
        return 0;
    const uint32_t at = glint_entry_of_sine(suns, square - (uint32_t)half.along * (uint32_t)half.along, over);
    return half.along > 0 && at < GLINT_GLOSS_ENTRIES ? glint_spread_clamp(word + suns->suns->gloss[at]) : word;
}

enum { ANY_FORMAT, IN_RGB565, IN_RGB565_BE };

/* Draws a span of a small triangle, pixel by pixel. */
static GLINT_INLINE void draw_small_span(const glint_row_walk *walk, int32_t row, int32_t left, int32_t right,
                                         int format) {
    const glint_slopes *s = &walk->slopes;
    const uint32_t d = (uint32_t)(left - s->column), i = (uint32_t)(row - s->row), first = (uint32_t)row << walk->shift;
    uint16_t *const depth = walk->depth + first, *const pixels = (uint16_t *)walk->pixels + first;
    uint32_t z = glint_z_at(walk, row, left), b = (uint32_t)s->start1 + d * (uint32_t)s->x1 + i * (uint32_t)s->y1,
             c = (uint32_t)s->start2 + d * (uint32_t)s->x2 + i * (uint32_t)s->y2;
    for (; left < right; left++) {
        if (z >> 15 > depth[left]) {
            depth[left] = (uint16_t)(z >> 15);
            const uint32_t word = format == ANY_FORMAT ? 0 : light_pixel(walk->suns, (int32_t)b, (int32_t)c),
                           packed = glint_spread_pack(word);
            if (word)
                pixels[left] = (uint16_t)(format == IN_RGB565_BE ? glint_to_high_first(packed & 0xffff) : packed);
            else
                draw_small_pixel(walk, row, left, (int32_t)b, (int32_t)c);
        }
        z += (uint32_t)walk->z.dx;
        b += (uint32_t)s->x1;
        c += (uint32_t)s->x2;
    }
}

void glint_draw_small_suns(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    draw_small_span(walk, row, left, right, ANY_FORMAT);
}

#if !GLINT_SMALL
void glint_draw_small_rgb565(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    draw_small_span(walk, row, left, right, IN_RGB565);
}

void glint_draw_small_rgb565_be(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    draw_small_span(walk, row, left, right, IN_RGB565_BE);
}
#endif

/* Sets 1/w of a small triangle's corners, 15 bits. */
void glint_begin_small_suns(const glint_row_walk *walk, glint_sun_triangle *t) {
    const int32_t wa = t->corners[0]->inverse_w, wb = t->corners[1]->inverse_w, wc = t->corners[2]->inverse_w;
    const uint32_t up = glint_leading_zeros((uint32_t)glint_most_of(wa, wb, wc)) - 1;
    const int32_t side = walk->triangle.back ? -1 : 1;
    t->weight[0] = side * glint_shift_right(wa << up, 16);
    t->weight[1] = side * glint_shift_right(wb << up, 16);
    t->weight[2] = side * glint_shift_right(wc << up, 16);
}
