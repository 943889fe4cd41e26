/* SPDX-License-Identifier: MIT */
/* Spans of one directional light in 16 bits a pixel: depth test, light and store in one loop. suns.h */
#include "../pixel/pixel.h"
#include "suns.h"

enum { SPAN_MATT, SPAN_HALF, SPAN_MIRROR };

/* This is a quadratic's value at a pixel and its change to the next column, modulo 2^32. */
typedef struct stepped {
    uint32_t at, step;
} stepped;

/* Begins with a quadratic at column x and row y. */
static inline stepped begin_row(const glint_quadratic *q, uint32_t x, uint32_t y) {
    const uint32_t slope = q->x + y * q->xy, curve = x * q->xx;
    return (stepped){q->value + y * (q->y + y * q->yy) + x * (slope + curve), slope + 2 * curve + q->xx};
}

static inline void step(stepped *s, uint32_t bend) {
    s->at += s->step;
    s->step += bend;
}

/* Returns the word of a fragment that faces the light. */
static GLINT_INLINE uint32_t light_fragment(const glint_sun_triangle *t, uint32_t light, uint32_t square, uint32_t half,
                                            uint32_t along, int kind) {
    const uint32_t over = glint_over_normal(square);
    uint32_t word = t->ramp[(light >> 14) * over >> 20];
    if (kind == SPAN_MATT)
        return word;
    const int32_t h = glint_shift_right((int32_t)half, 12);
    const uint32_t sine = kind == SPAN_MIRROR ? (square >> 16) * (along >> 12) - (light >> 13) * (uint32_t)h
                                              : square - (uint32_t)h * (uint32_t)h;
    const uint32_t at = ((sine >> 16) * over >> 14) * over >> t->shift;
    if (at < GLINT_GLOSS_ENTRIES)
        word += t->gloss[at];
    else if (sine >= GLINT_SINE_WRAPPED)
        word += t->gloss[0];
    else
        return word;
    const uint32_t more = word & GLINT_SPREAD_GUARD;
    if (more) {
        word |= more - (more >> 9);
        GLINT_BARRIER(); /* a branch, which is seldom taken */
    }
    return word;
}

/* Packs a word whose channels are clamped. */
static GLINT_INLINE uint32_t pack_word(uint32_t word) {
#if defined(__ARM_FEATURE_SAT) && defined(__GNUC__)
    union {
        uint32_t word;
        struct {
            uint32_t blue : 5, green : 6, red : 21;
        } part;
    } packed; /* green is inserted by one instruction */
    packed.word = word >> 4;
    packed.part.green = word >> 25 & 63;
    return packed.word;
#else
    return glint_spread_pack(word);
#endif
}

/* Numbers that a row does not change stay in the triangle: no registers are left, and copies would cost time. */
static GLINT_INLINE void draw_span(const glint_row_walk *walk, int32_t row, int32_t left, int32_t right, int kind,
                                   int swaps) {
    const glint_sun_triangle *t = walk->suns;
    const uint32_t x = (uint32_t)(left - walk->slopes.column), y = (uint32_t)(row - walk->slopes.row);
    uint32_t z = glint_z_at(walk, row, left), light = t->lit->light.value + x * t->lit->light.x + y * t->lit->light.y;
    stepped square = begin_row(&t->normal, x, y), half = {0, 0}, along = {0, 0};
    if (kind != SPAN_MATT)
        half = begin_row(&t->lit->half, x, y);
    if (kind == SPAN_MIRROR)
        along = begin_row(&t->lit->along, x, y);
    uint16_t *depth = walk->depth + ((uint32_t)row << walk->shift) + left, *const end = depth + (right - left);
    do {
        GLINT_OPAQUE(t);
        uint32_t here = z >> 15;
        GLINT_OPAQUE(here); /* found once */
        if (here > *depth) {
            uint32_t word = t->dark;
            *depth = (uint16_t)here;
            if ((int32_t)light > 0)
                word = light_fragment(t, light, square.at, half.at, along.at, kind);
            word = pack_word(word);
            *(uint16_t *)((uintptr_t)depth + t->from_depth) =
                (uint16_t)(swaps ? glint_to_high_first(word & 0xffff) : word);
        }
        z += t->z_dx;
        light += t->light_dx;
        step(&square, t->square_bend);
        if (kind != SPAN_MATT)
            step(&half, t->half_bend);
        if (kind == SPAN_MIRROR)
            step(&along, t->along_bend);
    } while (++depth != end);
}

/* ---- Small triangles ---- */

/* Brings a number of 16 bits from corners to a pixel. */
static inline int32_t mix(int32_t a, int32_t b, int32_t c, int32_t of_a, int32_t of_b, int32_t of_c) {
    return glint_shift_right(a * of_a + b * of_b + c * of_c + (1 << 13), 14);
}

/* Lights a pixel as glint_draw_small_pixel does. @return its word, or 0 where that is to do it: no word is 0 */
static GLINT_INLINE uint32_t light_small_pixel(const glint_sun_triangle *t, int32_t a, int32_t b, int32_t c) {
    const glint_suns *suns = t->suns;
    const int16_t *na = t->corners[0]->attribute, *nb = t->corners[1]->attribute, *nc = t->corners[2]->attribute,
                  *ha = t->terms[0]->v, *hb = t->terms[1]->v, *hc = t->terms[2]->v;
    const int32_t wa = glint_shift_right(a * t->weight[0], 14), wb = glint_shift_right(b * t->weight[1], 14),
                  wc = glint_shift_right(c * t->weight[2], 14), *l = suns->suns->light;
    const int32_t nx = glint_shift_right(na[0] * wa + nb[0] * wb + nc[0] * wc, 15),
                  ny = glint_shift_right(na[1] * wa + nb[1] * wb + nc[1] * wc, 15),
                  nz = glint_shift_right(na[2] * wa + nb[2] * wb + nc[2] * wc, 15);
    uint32_t square = (uint32_t)(nx * nx + ny * ny + nz * nz);
    const int32_t light = nx * l[0] + ny * l[1] + nz * l[2];
    if (square < 1u << 28)
        return 0;
    if (light <= 0)
        return suns->dark;
    square <<= 2;
    const uint32_t over = glint_over_normal(square);
    uint32_t word = suns->suns->ramp[((uint32_t)light >> 15) * over >> 20];
    const int32_t x = mix(a, b, c, ha[0], hb[0], hc[0]), y = mix(a, b, c, ha[1], hb[1], hc[1]),
                  z = mix(a, b, c, ha[2], hb[2], hc[2]), lacking = (1 << 28) - x * x - y * y - z * z;
    if (lacking >= suns->small_bend)
        return 0;
    int32_t h = glint_shift_right(nx * x + ny * y + nz * z, 13);
    h += glint_shift_right(h * glint_shift_right(lacking, 13), 16);
    const uint32_t sine = square - (uint32_t)h * (uint32_t)h;
    uint32_t at = ((sine >> 16) * over >> 14) * over >> suns->shift;
    if (sine >= GLINT_SINE_WRAPPED)
        at = 0;
    if (h > 0 && at < GLINT_GLOSS_ENTRIES)
        word = glint_spread_clamp(word + suns->suns->gloss[at]);
    return word;
}

static GLINT_INLINE void draw_small_span(const glint_row_walk *walk, int32_t row, int32_t left, int32_t right,
                                         int swaps) {
    const glint_slopes *s = &walk->slopes;
    const uint32_t d = (uint32_t)(left - s->column), i = (uint32_t)(row - s->row);
    uint16_t *const depth = walk->depth + ((uint32_t)row << walk->shift), *const pixels =
                                                                              (uint16_t *)walk->pixels +
                                                                              ((uint32_t)row << walk->shift);
    uint32_t z = glint_z_at(walk, row, left), b = (uint32_t)s->start1 + d * (uint32_t)s->x1 + i * (uint32_t)s->y1,
             c = (uint32_t)s->start2 + d * (uint32_t)s->x2 + i * (uint32_t)s->y2;
    for (; left < right; left++) {
        if (z >> 15 > depth[left]) {
            depth[left] = (uint16_t)(z >> 15);
            const uint32_t word = light_small_pixel(walk->suns, (1 << 14) - (int32_t)(b + c), (int32_t)b, (int32_t)c);
            if (word)
                pixels[left] = (uint16_t)(swaps ? glint_to_high_first(pack_word(word) & 0xffff) : pack_word(word));
            else
                glint_draw_small_pixel(walk, row, left, (int32_t)b, (int32_t)c);
        }
        z += (uint32_t)walk->z.dx;
        b += (uint32_t)s->x1;
        c += (uint32_t)s->x2;
    }
}

#define DEFINE_SPANS(suffix, swaps)                                                               \
    static void matt_##suffix(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {   \
        draw_span(walk, row, left, right, SPAN_MATT, swaps);                                      \
    }                                                                                             \
    static void half_##suffix(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {   \
        draw_span(walk, row, left, right, SPAN_HALF, swaps);                                      \
    }                                                                                             \
    static void mirror_##suffix(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) { \
        draw_span(walk, row, left, right, SPAN_MIRROR, swaps);                                    \
    }                                                                                             \
    static void small_##suffix(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {  \
        draw_small_span(walk, row, left, right, swaps);                                           \
    }                                                                                             \
    const glint_sun_spans glint_sun_spans_##suffix = {matt_##suffix, half_##suffix, mirror_##suffix, small_##suffix}

DEFINE_SPANS(rgb565, 0);
DEFINE_SPANS(rgb565_be, 1);
