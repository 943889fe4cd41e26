/* SPDX-License-Identifier: MIT */
/* Small triangles under suns: each pixel is lit from the corners, without set-up. suns.h */
#include "../pixel/format.h"
#include "../raster/small.h"
#include "suns.h"

/* A pixel of a small triangle: weights of its corners, 1 = 2^14, and N', 1 = 2^15. */
typedef struct small_pixel {
    int32_t row, column, a, b, c, n[3];
} small_pixel;

/* Brings a component of a vector, of 16 bits, from corners to a pixel. */
static inline int32_t mix_corners(const small_pixel *of, int32_t a, int32_t b, int32_t c) {
    return glint_shift_right(a * of->a + b * of->b + c * of->c + (1 << 13), 14);
}

/* Sets N' of a pixel. @return N'.N', 1 = 2^30 */
static inline uint32_t find_small_normal(const glint_sun_triangle *t, small_pixel *of) {
    const int16_t *na = t->corners[0]->attribute, *nb = t->corners[1]->attribute, *nc = t->corners[2]->attribute;
    const int32_t a = glint_shift_right(of->a * t->weight[0], 14), b = glint_shift_right(of->b * t->weight[1], 14),
                  c = glint_shift_right(of->c * t->weight[2], 14);
    int32_t x = glint_shift_right(na[0] * a + nb[0] * b + nc[0] * c, 15),
            y = glint_shift_right(na[1] * a + nb[1] * b + nc[1] * c, 15),
            z = glint_shift_right(na[2] * a + nb[2] * b + nc[2] * c, 15);
    uint32_t square = (uint32_t)(x * x + y * y + z * z);
    while (square < 1u << 28) { /* N' of corners may be opposite */
        x = 2 * x, y = 2 * y, z = 2 * z + !square;
        square = (uint32_t)(x * x + y * y + z * z);
    }
    of->n[0] = x, of->n[1] = y, of->n[2] = z;
    return square;
}

/* Returns the entry of gloss of a pixel of a small triangle, given terms of its corners, and N'.L, 1 = 2^30. */
static GLINT_NOINLINE uint32_t find_small_entry(const glint_row_walk *walk, const glint_drawn_sun *sun,
                                                const small_pixel *of, const glint_spread *p, uint32_t term,
                                                int32_t light) {
    const glint_suns *suns = walk->suns->suns;
    const int16_t *a = walk->suns->terms[0][term].v, *b = walk->suns->terms[1][term].v,
                  *c = walk->suns->terms[2][term].v;
    const int32_t *n = of->n, over = (int32_t)p->over, x = mix_corners(of, a[0], b[0], c[0]),
                  y = mix_corners(of, a[1], b[1], c[1]), z = mix_corners(of, a[2], b[2], c[2]),
                  lacking = (1 << 28) - x * x - y * y - z * z;
    if (lacking < suns->small_bend) {
        const int32_t *l = sun->light, longer = glint_shift_right(lacking, 13); /* what H and V are to be, 2^16 */
        int32_t h = glint_shift_right(n[0] * x + n[1] * y + n[2] * z, 13);      /* 2^16 */
        h += glint_shift_right(h * longer, 16);
        uint32_t sine = p->square - (uint32_t)h * (uint32_t)h;
        if (suns->is_mirror) {
            const int32_t along = glint_shift_right(l[0] * x + l[1] * y + l[2] * z, 14); /* L.V, 2^15 */
            sine = (p->square >> 16) * (uint32_t)((1 << 15) + along + glint_shift_right(along * longer, 16)) -
                   (uint32_t)glint_shift_right(light, 14) * (uint32_t)h;
        } else if (h <= 0)
            return GLINT_GLOSS_ENTRIES;
        return glint_entry_of_sine(suns, sine, p->over);
    }
    const int32_t unit[3] = {glint_shift_right(n[0] * over, 14), glint_shift_right(n[1] * over, 14),
                             glint_shift_right(n[2] * over, 14)};
    return glint_find_sine(walk, sun, of->row, of->column, unit) >> suns->shift;
}

void glint_draw_small_pixel(const glint_row_walk *walk, int32_t row, int32_t column, int32_t b, int32_t c) {
    const glint_sun_triangle *t = walk->suns;
    const glint_suns *suns = t->suns;
    small_pixel of = {row, column, (1 << 14) - b - c, b, c, {0}};
    const uint32_t square = find_small_normal(t, &of) << 2;
    glint_spread p = {((uint32_t)row << walk->shift) + (uint32_t)column, suns->first, square,
                      glint_over_normal(square)};
    uint32_t term = 0;
    for (const glint_drawn_sun *sun = suns->suns, *end = sun + suns->count; sun != end; sun++) {
        const int32_t light = of.n[0] * sun->light[0] + of.n[1] * sun->light[1] + of.n[2] * sun->light[2];
        if (light > suns->gate)
            glint_add_sun(walk, sun, &p, glint_shift_right(light, 1),
                          sun->shines ? find_small_entry(walk, sun, &of, &p, term, light) : GLINT_GLOSS_ENTRIES);
        term += sun->shines;
    }
    if (suns->takes_most)
        glint_take_larger(suns->dark, &p, &p + 1);
    walk->frame->config.format->store_spread(walk->pixels, walk->shift, &p, &p + 1);
}

/* Draws a span of a small triangle, pixel by pixel. */
void glint_draw_small_suns(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    const glint_slopes *s = &walk->slopes;
    const uint32_t d = (uint32_t)(left - s->column), i = (uint32_t)(row - s->row);
    uint16_t *depth = walk->depth + ((uint32_t)row << walk->shift);
    uint32_t z = glint_z_at(walk, row, left), b = (uint32_t)s->start1 + d * (uint32_t)s->x1 + i * (uint32_t)s->y1,
             c = (uint32_t)s->start2 + d * (uint32_t)s->x2 + i * (uint32_t)s->y2;
    for (; left < right; left++) {
        if (z >> 15 > depth[left]) {
            depth[left] = (uint16_t)(z >> 15);
            glint_draw_small_pixel(walk, row, left, (int32_t)b, (int32_t)c);
        }
        z += (uint32_t)walk->z.dx;
        b += (uint32_t)s->x1;
        c += (uint32_t)s->x2;
    }
}

/* Sets 1/w of a small triangle's corners, 15 bits. */
void glint_begin_small_suns(const glint_row_walk *walk, glint_sun_triangle *t) {
    const int32_t wa = t->corners[0]->inverse_w, wb = t->corners[1]->inverse_w, wc = t->corners[2]->inverse_w;
    const uint32_t up = glint_leading_zeros((uint32_t)glint_most_of(wa, wb, wc)) - 1;
    const int32_t side = walk->triangle.back ? -1 : 1;
    t->weight[0] = side * glint_shift_right(wa << up, 16);
    t->weight[1] = side * glint_shift_right(wb << up, 16);
    t->weight[2] = side * glint_shift_right(wc << up, 16);
}
