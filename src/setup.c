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

/* A side of at most `size` bits, up to 16, times 1/area. */
static int32_t to_30_bits(int32_t side, int32_t reciprocal, int32_t size) {
    return (int32_t)glint_shift_right64((int64_t)glint_shift_left(side, 16 - (unsigned)size) * reciprocal, 17);
}

/* Bits of the largest difference in 1/w from the first corner. */
static uint32_t depth_bits(const glint_triangle *t) {
    const int32_t first = t->corners[0]->inverse_w;
    return glint_magnitude_bits(t->corners[1]->inverse_w - first) |
           glint_magnitude_bits(t->corners[2]->inverse_w - first);
}

/*
 * Narrow, where that keeps depth to about a step: 1/area of 16 bits, gradients rounded to 15 bits. A plane's value
 * at a pixel of the triangle is then off by at most 2^-12 of the corners' difference, 2^-8 where the triangle is
 * slender, and a step for each pixel from the anchor. Wide, it is off by at most 2^-7 of the difference, or of 2^26
 * where that is less: a needle 2000 pixels long.
 */
static void gradients_begin(glint_gradients *g, const glint_place places[3], const glint_triangle *t) {
    int32_t x1 = places[0].y - places[2].y, y1 = places[2].x - places[0].x;
    int32_t x2 = places[1].y - places[0].y, y2 = places[0].x - places[1].x;
    const uint32_t area = (uint32_t)t->area;
    const uint32_t bits =
        glint_magnitude_bits(x1) | glint_magnitude_bits(y1) | glint_magnitude_bits(x2) | glint_magnitude_bits(y2);
    const int32_t zeros = (int32_t)glint_leading_zeros(area), area_bits = 31 - zeros;
    int32_t size = (area_bits + 1) / 2; /* of the longest side: at least half as many bits as the area */
    while ((bits + 1) >> size)
        size++;
    g->to_center_x = 8 - ((places[0].x + 8) & 15);
    g->to_center_y = 8 - ((places[0].y + 8) & 15);
    g->size = size;
    g->shift = 42 - zeros - size;
    const int32_t slender = 2 * size - area_bits;
    g->wide = size > NARROW_SIZE || slender > NARROW_SLENDER || depth_bits(t) >> (29 - slender);
    if (g->wide) {
        /* 1 / area is this times 2^(zeros - 62) */
        const int32_t reciprocal = (int32_t)(glint_reciprocal(area << zeros) >> 1);
        x1 = to_30_bits(x1, reciprocal, size);
        y1 = to_30_bits(y1, reciprocal, size);
        x2 = to_30_bits(x2, reciprocal, size);
        y2 = to_30_bits(y2, reciprocal, size);
    } else {
        /* 1 / area is this times 2^(zeros - 47) */
        const int32_t reciprocal = glint_reciprocal16(area << zeros >> 16), half = 1 << size;
        x1 = glint_shift_right(x1 * reciprocal + half, (unsigned)size + 1);
        y1 = glint_shift_right(y1 * reciprocal + half, (unsigned)size + 1);
        x2 = glint_shift_right(x2 * reciprocal + half, (unsigned)size + 1);
        y2 = glint_shift_right(y2 * reciprocal + half, (unsigned)size + 1);
    }
    g->x1 = t->clockwise ? -x1 : x1;
    g->y1 = t->clockwise ? -y1 : y1;
    g->x2 = t->clockwise ? -x2 : x2;
    g->y2 = t->clockwise ? -y2 : y2;
}

/* x 2^n, |n| < 32; up, it may wrap */
static inline int32_t scale(int32_t x, int32_t n) {
    return n < 0 ? glint_shift_right(x, (unsigned)-n) : glint_shift_left(x, (unsigned)n);
}

static inline int32_t high_sum(int32_t d1, int32_t g1, int32_t d2, int32_t g2) {
    return (int32_t)glint_shift_right64((int64_t)d1 * g1 + (int64_t)d2 * g2, 31);
}

void glint_plane_begin(glint_plane *p, const glint_gradients *g, int32_t a0, int32_t a1, int32_t a2) {
    int32_t d1 = a1 - a0, d2 = a2 - a0, dx, dy, up = 16;
    if (g->wide) {
        dx = high_sum(d1, g->x1, d2, g->x2);
        dy = high_sum(d1, g->y1, d2, g->y2);
    } else { /* differences in 15 bits and a sign */
        up = 17 - (int32_t)glint_leading_zeros(glint_magnitude_bits(d1) | glint_magnitude_bits(d2));
        up = up > 0 ? up : 0;
        d1 = glint_shift_right(d1, (unsigned)up);
        d2 = glint_shift_right(d2, (unsigned)up);
        dx = d1 * g->x1 + d2 * g->x2;
        dy = d1 * g->y1 + d2 * g->y2;
    }
    up -= g->shift;
    p->dx = scale(dx, up);
    p->dy = scale(dy, up);
    const int32_t to_center = glint_shift_right(dx, 5) * g->to_center_x + glint_shift_right(dy, 5) * g->to_center_y;
    p->start = glint_add_wrap(a0, scale(to_center, up + 1));
}

void glint_setup(glint_part *part, const glint_triangle *t) {
    const glint_vertex *const *v = t->corners;
    gradients_begin(&part->gradients, part->places, t);
    glint_plane_begin(&part->depth, &part->gradients, v[0]->inverse_w, v[1]->inverse_w, v[2]->inverse_w);
}
