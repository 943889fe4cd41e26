/* SPDX-License-Identifier: MIT */
/*
 * Setup: attributes of a triangle as planes. A plane is one integer polynomial per triangle, anchored at its first
 * corner and evaluated modulo 2^32, so that a pixel gets the same value whatever tile it is drawn in.
 */
#include "setup.h"

#include "division.h"

/* Narrow triangles: bits of the longest side, and bits by which its square may pass the area. */
#define NARROW_SIZE 10
#define NARROW_SLENDER 6

/* Sides across from the second and the third corner, turned by a right angle, in sixteenths; and the area. */
typedef struct sides {
    int32_t x1, y1, x2, y2;
    uint32_t area;
    int32_t area_bits;  /* 2^area_bits is at most the area */
    int32_t reciprocal; /* 1/area = reciprocal 2^-(16 + area_bits), 16 bits; of narrow triangles only */
} sides;

/* A side of at most `size` bits, up to 16, times 1/area. */
static GLINT_NOINLINE int32_t to_30_bits(int32_t side, int32_t reciprocal, int32_t size) {
    return (int32_t)glint_shift_right64((int64_t)glint_shift_left(side, 16 - (unsigned)size) * reciprocal, 17);
}

/* A side of at most `size` bits, up to 10, times 1/area: 15 bits. */
static inline int32_t to_15_bits(int32_t side, int32_t reciprocal, int32_t size) {
    return glint_shift_right(side * reciprocal + (1 << size), (unsigned)size + 1);
}

/*
 * Narrow triangles have a 1/area of 16 bits, and gradients rounded to 15 bits. A plane's value at a pixel of the
 * triangle is then off by at most 2^-12 of the corners' difference, 2^-8 where the triangle is slender, and a step for
 * each pixel from the anchor; depth is refined to 2^-13. Wide, it is off by at most 2^-7 of the difference, or of 2^26
 * where that is less: a needle 2000 pixels long.
 */
static void gradients_begin(glint_gradients *g, sides *s) {
    const uint32_t bits = glint_magnitude_bits(s->x1) | glint_magnitude_bits(s->y1) | glint_magnitude_bits(s->x2) |
                          glint_magnitude_bits(s->y2);
    const uint32_t zeros = glint_leading_zeros(s->area);
    const int32_t area_bits = 31 - (int32_t)zeros;
    int32_t size = (area_bits + 1) / 2; /* of the longest side: at least half as many bits as the area */
    while ((bits + 1) >> size)
        size++;
    s->area_bits = area_bits;
    g->size = size;
    g->shift = 11 + area_bits - size;
    g->wide = size > NARROW_SIZE || 2 * size - area_bits > NARROW_SLENDER;
    if (g->wide) {
        /* 1 / area is this times 2^(zeros - 62) */
        const int32_t reciprocal = (int32_t)(glint_reciprocal(s->area << zeros) >> 1);
        g->x1 = to_30_bits(s->x1, reciprocal, size);
        g->y1 = to_30_bits(s->y1, reciprocal, size);
        g->x2 = to_30_bits(s->x2, reciprocal, size);
        g->y2 = to_30_bits(s->y2, reciprocal, size);
    } else {
        s->reciprocal = glint_reciprocal16(s->area << zeros >> 16);
        g->x1 = to_15_bits(s->x1, s->reciprocal, size);
        g->y1 = to_15_bits(s->y1, s->reciprocal, size);
        g->x2 = to_15_bits(s->x2, s->reciprocal, size);
        g->y2 = to_15_bits(s->y2, s->reciprocal, size);
    }
}

/* x 2^n, |n| < 32; up, it may wrap */
static inline int32_t scale(int32_t x, int32_t n) {
    return n < 0 ? glint_shift_right(x, (unsigned)-n) : glint_shift_left(x, (unsigned)n);
}

static inline int32_t high_sum(int32_t d1, int32_t g1, int32_t d2, int32_t g2) {
    return (int32_t)glint_shift_right64((int64_t)d1 * g1 + (int64_t)d2 * g2, 31);
}

/* A plane from slopes that are 2^-n of its own. */
static inline void finish_plane(glint_plane *p, const glint_gradients *g, int32_t start, int32_t dx, int32_t dy,
                                int32_t n) {
    const int32_t to_center = glint_shift_right(dx, 5) * g->to_center_x + glint_shift_right(dy, 5) * g->to_center_y;
    p->dx = scale(dx, n);
    p->dy = scale(dy, n);
    p->start = glint_add_wrap(start, scale(to_center, n + 1));
}

/* Brings two differences to 15 bits and a sign. @return n: they were 2^n as much */
static inline int32_t to_differences(int32_t *d1, int32_t *d2) {
    int32_t up = 17 - (int32_t)glint_leading_zeros(glint_magnitude_bits(*d1) | glint_magnitude_bits(*d2));
    up = up > 0 ? up : 0;
    *d1 = glint_shift_right(*d1, (unsigned)up);
    *d2 = glint_shift_right(*d2, (unsigned)up);
    return up;
}

void glint_plane_begin(glint_plane *p, const glint_gradients *g, int32_t a0, int32_t a1, int32_t a2) {
    int32_t d1 = a1 - a0, d2 = a2 - a0;
    if (g->wide) {
        finish_plane(p, g, a0, high_sum(d1, g->x1, d2, g->x2), high_sum(d1, g->y1, d2, g->y2), 16 - g->shift);
    } else {
        const int32_t up = to_differences(&d1, &d2);
        finish_plane(p, g, a0, d1 * g->x1 + d2 * g->x2, d1 * g->y1 + d2 * g->y2, up - g->shift);
    }
}

/*
 * The slope d1 g1 + d2 g2 of a narrow triangle made precise: by what it differs from the exact quotient, less than 2^17
 * steps, times 1/area. @return the slope 2^-k, off by at most 9 steps of the whole one, or one of its own
 */
static inline int32_t refine(const sides *s, int32_t slope, int32_t exact, int32_t shift, unsigned k) {
    const int32_t part = glint_shift_right(slope, k);
    const uint32_t rest = ((uint32_t)exact << (shift + 4 - (int32_t)k)) - (uint32_t)part * s->area;
    const int32_t high = glint_shift_right((int32_t)rest, (unsigned)s->area_bits + 3 - k);
    return part + glint_shift_right(high * s->reciprocal, 13 + k);
}

/* Depth of a narrow triangle: the differences' rounding, 2^-15 of them, is all its error but for steps. */
static void narrow_depth(glint_plane *p, const glint_gradients *g, const sides *s, int32_t a0, int32_t d1, int32_t d2) {
    const int32_t up = to_differences(&d1, &d2);
    const unsigned k = s->area_bits > 12 ? (unsigned)s->area_bits - 12 : 0;
    const int32_t dx = refine(s, d1 * g->x1 + d2 * g->x2, d1 * s->x1 + d2 * s->x2, g->shift, k);
    const int32_t dy = refine(s, d1 * g->y1 + d2 * g->y2, d1 * s->y1 + d2 * s->y2, g->shift, k);
    finish_plane(p, g, a0, dx, dy, up - g->shift + (int32_t)k);
}

void glint_setup(glint_part *part, const glint_triangle *t) {
    const glint_place *a = &part->places[0], *b = &part->places[1], *c = &part->places[2];
    const int32_t w = t->corners[0]->inverse_w, w1 = t->corners[1]->inverse_w, w2 = t->corners[2]->inverse_w;
    glint_gradients *g = &part->gradients;
    sides s = {.x1 = a->y - c->y, .y1 = c->x - a->x, .x2 = b->y - a->y, .y2 = a->x - b->x, .area = (uint32_t)t->area};
    g->to_center_x = 8 - ((a->x + 8) & 15);
    g->to_center_y = 8 - ((a->y + 8) & 15);
    gradients_begin(g, &s);
    if (g->wide)
        glint_plane_begin(&part->depth, g, w, w1, w2);
    else
        narrow_depth(&part->depth, g, &s, w, w1 - w, w2 - w);
}
