/* SPDX-License-Identifier: MIT */
/* Draws small triangles under suns: each pixel is lit from the values of the corners, so that triangles need no set-up.
 * suns.h */
#include "../pixel/format.h"
#include "../pixel/pixel.h"
#include "../raster/small.h"
#include "suns.h"
#include "wear.h"

/* A pixel of a small triangle: a, b and c are its barycentric coordinates, 1 = 2^14, and n is N', 1 = 2^15. */
typedef struct small_pixel {
    int32_t row, column, a, b, c, n[3];
} small_pixel;

/* Sets N' of a pixel. @return N'.N', 1 = 2^30 */
static GLINT_INLINE uint32_t find_normal(const glint_sun_triangle *t, small_pixel *pixel) {
    const int16_t *na = t->corners[0]->attribute, *nb = t->corners[1]->attribute, *nc = t->corners[2]->attribute;
    const int32_t a = glint_shift_right(pixel->a * t->weight[0], 14),
                  b = glint_shift_right(pixel->b * t->weight[1], 14),
                  c = glint_shift_right(pixel->c * t->weight[2], 14);
    const int32_t x = glint_shift_right(na[0] * a + nb[0] * b + nc[0] * c, 15),
                  y = glint_shift_right(na[1] * a + nb[1] * b + nc[1] * c, 15),
                  z = glint_shift_right(na[2] * a + nb[2] * b + nc[2] * c, 15);
    pixel->n[0] = x, pixel->n[1] = y, pixel->n[2] = z;
    return (uint32_t)(x * x + y * y + z * z);
}

/* Below this N'.N', 1 = 2^30, the N' of find_normal has too few bits; it may even be 0, as N' of corners can cancel. */
#define LEAST_SMALL_SQUARE (1u << 28)

/* Interpolates a value of 16 bits between corners, rounded. */
static inline int32_t mix_corners(const small_pixel *pixel, int32_t a, int32_t b, int32_t c) {
    return glint_shift_right(a * pixel->a + b * pixel->b + c * pixel->c + (1 << 13), 14);
}

/* H or V of a pixel. */
typedef struct small_half {
    int32_t v[3];    /* interpolated between corners, 1 = 2^14 */
    int32_t lacking; /* 1 less its square, 1 = 2^28 */
    int32_t cosine;  /* N'.H as if H were unit, 1 = 2^16 */
} small_half;

static GLINT_INLINE small_half find_half(const glint_sun_triangle *t, const small_pixel *pixel, uint32_t term) {
    const int16_t *a = t->terms[0][term].v, *b = t->terms[1][term].v, *c = t->terms[2][term].v;
    const int32_t x = mix_corners(pixel, a[0], b[0], c[0]), y = mix_corners(pixel, a[1], b[1], c[1]),
                  z = mix_corners(pixel, a[2], b[2], c[2]), lacking = (1 << 28) - x * x - y * y - z * z,
                  h = glint_shift_right(pixel->n[0] * x + pixel->n[1] * y + pixel->n[2] * z, 13);
    return (small_half){{x, y, z}, lacking, h + glint_shift_right(h * glint_shift_right(lacking, 13), 16)};
}

/* Returns the index of a pixel's entry of gloss, given the number of the light's term, and N'.L, 1 = 2^30. */
static GLINT_HOT GLINT_NOINLINE uint32_t find_small_entry(const glint_row_walk *walk, const glint_drawn_sun *sun,
                                                          const small_pixel *pixel, const glint_spread *p,
                                                          uint32_t term, int32_t light) {
    const glint_suns *suns = walk->suns->suns;
    const small_half half = find_half(walk->suns, pixel, term);
    const int32_t *n = pixel->n, over = (int32_t)p->over;
    if (half.lacking >= suns->small_bend) {
        const int32_t unit[3] = {glint_shift_right(n[0] * over, 14), glint_shift_right(n[1] * over, 14),
                                 glint_shift_right(n[2] * over, 14)};
        return glint_find_sine(walk, sun, pixel->row, pixel->column, unit) >> suns->shift;
    }
    if (!suns->is_mirror)
        return half.cosine <= 0
                   ? GLINT_GLOSS_ENTRIES
                   : glint_entry_of_sine(suns, p->square - (uint32_t)half.cosine * (uint32_t)half.cosine, p->over);
    const int32_t light_dot_view =
        glint_most(glint_shift_right(glint_dot32(sun->light, half.v), 14), 4 - (1 << 15)); /* L.V, 2^15 */
    const int32_t lacking = glint_shift_right(light_dot_view * glint_shift_right(half.lacking, 13), 16);
    const uint32_t light_view = (uint32_t)((1 << 15) + light_dot_view + lacking); /* 1 + L.V, as if V were unit */
    return glint_entry_of_sine(
        suns, (p->square >> 16) * light_view - (uint32_t)glint_shift_right(light, 14) * (uint32_t)half.cosine, p->over);
}

/* Adds all lights to a pixel: their diffuse light, their highlights, or both. */
static GLINT_SPECIAL void add_lights(const glint_row_walk *walk, const small_pixel *pixel, glint_spread *p,
                                     int is_diffuse, int is_gloss) {
    const glint_suns *suns = walk->suns->suns;
    uint32_t term = 0;
    for (const glint_drawn_sun *sun = suns->suns, *end = sun + suns->count; sun != end; sun++) {
        const int32_t light = glint_dot32(pixel->n, sun->light);
        if (light > suns->gate)
            glint_add_sun(walk, sun, p, is_diffuse ? glint_shift_right(light, 1) : 0,
                          is_gloss && sun->shines ? find_small_entry(walk, sun, pixel, p, term, light)
                                                  : GLINT_GLOSS_ENTRIES);
        term += sun->shines;
    }
}

/* Lights a pixel of a surface with its own colours, which multiply ambient and diffuse light. */
static GLINT_NOINLINE void add_lights_to_own(const glint_row_walk *walk, const small_pixel *pixel, glint_spread *p) {
    const glint_sun_triangle *t = walk->suns;
    const int16_t *a = t->own_at[0], *b = t->own_at[1], *c = t->own_at[2];
    p->colour = t->suns->dark - t->suns->half_level;
    add_lights(walk, pixel, p, 1, 0);
    if (walk->draw->texture) {
        const uint32_t begin = (uint32_t)pixel->row << walk->shift;
        walk->draw->texture->type->stage->multiply(walk, pixel->row, begin, p, p + 1);
    }
    if (walk->draw->extra)
        p->colour = glint_multiply_word(t->suns, p->colour, mix_corners(pixel, a[0], b[0], c[0]),
                                        mix_corners(pixel, a[1], b[1], c[1]), mix_corners(pixel, a[2], b[2], c[2]));
    add_lights(walk, pixel, p, 0, 1);
}

/* Lights a pixel by all lights, and stores it. */
static GLINT_HOT GLINT_NOINLINE void draw_small_pixel(const glint_row_walk *walk, int32_t row, int32_t column,
                                                      int32_t b, int32_t c) {
    const glint_sun_triangle *t = walk->suns;
    const glint_suns *suns = t->suns;
    small_pixel pixel = {row, column, (1 << 14) - b - c, b, c, {0}};
    uint32_t square = find_normal(t, &pixel);
    while (square < LEAST_SMALL_SQUARE) {
        pixel.n[0] *= 2, pixel.n[1] *= 2, pixel.n[2] = 2 * pixel.n[2] + !square;
        square = (uint32_t)glint_dot32(pixel.n, pixel.n);
    }
    square <<= 2;
    glint_spread p = {((uint32_t)row << walk->shift) + (uint32_t)column, suns->first, square,
                      glint_over_normal(square)};
    if (walk->draw->extra || walk->draw->texture)
        add_lights_to_own(walk, &pixel, &p);
    else
        add_lights(walk, &pixel, &p, 1, 1);
    if (suns->takes_most)
        glint_take_larger(suns->dark, &p, &p + 1);
    walk->frame->config.format->store_spread(walk->pixels, walk->shift, &p, &p + 1);
}

/* Lights a pixel as draw_small_pixel does, by the only light, whose ramp includes ambient light. @return its word,
 * which is never 0; or 0 if draw_small_pixel has to light the pixel */
static GLINT_INLINE uint32_t light_pixel(const glint_sun_triangle *t, int32_t b, int32_t c) {
    const glint_suns *suns = t->suns;
    small_pixel pixel = {0, 0, (1 << 14) - b - c, b, c, {0}};
    uint32_t square = find_normal(t, &pixel);
    const int32_t light = glint_dot32(pixel.n, suns->suns->light);
    if (square < LEAST_SMALL_SQUARE)
        return 0;
    if (light <= 0)
        return suns->dark;
    square <<= 2;
    const uint32_t over = glint_over_normal(square), word = suns->suns->ramp[((uint32_t)light >> 15) * over >> 20];
    const small_half half = find_half(t, &pixel, 0);
    if (half.lacking >= suns->small_bend)
        return 0;
    const uint32_t index = glint_entry_of_sine(suns, square - (uint32_t)half.cosine * (uint32_t)half.cosine, over);
    return half.cosine > 0 && index < GLINT_GLOSS_ENTRIES ? glint_spread_clamp(word + suns->suns->gloss[index]) : word;
}

/* Pixel formats for which spans have code of their own. */
enum { ANY_FORMAT, IN_RGB565, IN_RGB565_BE };

/* Draws a span of a small triangle, pixel by pixel. */
static GLINT_INLINE void draw_small_span(const glint_row_walk *walk, int32_t row, int32_t left, int32_t right,
                                         int format) {
    const glint_slopes *s = &walk->slopes;
    const uint32_t x = (uint32_t)(left - s->column), y = (uint32_t)(row - s->row), first = (uint32_t)row << walk->shift;
    uint16_t *const depth = walk->depth + first, *const pixels = (uint16_t *)walk->pixels + first;
    uint32_t z = glint_z_at(walk, row, left), b = (uint32_t)s->start1 + x * (uint32_t)s->x1 + y * (uint32_t)s->y1,
             c = (uint32_t)s->start2 + x * (uint32_t)s->x2 + y * (uint32_t)s->y2;
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

GLINT_HOT void glint_draw_small_suns(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    draw_small_span(walk, row, left, right, ANY_FORMAT);
}

#if !GLINT_SMALL
GLINT_HOT void glint_draw_small_rgb565(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    draw_small_span(walk, row, left, right, IN_RGB565);
}

GLINT_HOT void glint_draw_small_rgb565_be(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    draw_small_span(walk, row, left, right, IN_RGB565_BE);
}
#endif

/* Sets the weights of a small triangle's corners: 1/w, 15 bits. */
void glint_begin_small_suns(const glint_row_walk *walk, glint_sun_triangle *t) {
    const int32_t wa = t->corners[0]->inverse_w, wb = t->corners[1]->inverse_w, wc = t->corners[2]->inverse_w;
    const uint32_t up = glint_leading_zeros((uint32_t)glint_most_of(wa, wb, wc)) - 1;
    const int32_t side = walk->triangle.back ? -1 : 1;
    t->weight[0] = side * glint_shift_right(wa << up, 16);
    t->weight[1] = side * glint_shift_right(wb << up, 16);
    t->weight[2] = side * glint_shift_right(wc << up, 16);
}
