/* SPDX-License-Identifier: MIT */
/*
 * Sets attributes of a triangle up as planes. A plane is one integer polynomial per triangle, anchored at its first
 * corner and evaluated modulo 2^32, so that a pixel gets the same value whatever tile it is drawn in.
 */
#include "../math/division.h"
#include "triangle.h"

/* Sides of a narrow triangle have at most so many bits, and pass the area by at most this many. */
#define NARROW_SIZE 10
#define NARROW_SLIVER 4

/* Returns twice the area of corners that run counter-clockwise. */
static inline int32_t find_area(const glint_gradients *g) {
    return g->y1 * g->x2 - g->y2 * g->x1;
}

/* Multiplies a side of at most `size` bits, up to 16, by 1/area. */
static GLINT_NOINLINE int32_t to_30_bits(int32_t side, int32_t reciprocal, int32_t size) {
    return (int32_t)glint_shift_right64((int64_t)glint_shift_left(side, 16 - (unsigned)size) * reciprocal, 17);
}

/*
 * Multiplies sides by 1/area; those of slender triangles stay whole. A plane's value at a pixel of a wide triangle is
 * then off by at most 2^-18 of the corners' difference, 2^-17 where the triangle is small, and a step for each pixel
 * from the anchor.
 */
static GLINT_NOINLINE void widen(glint_gradients *g, uint32_t area, uint32_t zeros) {
    /* 1 / area is this times 2^(zeros - 62). */
    const int32_t reciprocal = (int32_t)(glint_reciprocal(area << zeros) >> 1);
    int32_t size = (32 - (int32_t)zeros) / 2; /* of the longest side: at least half as many bits as the area */
    while ((g->reach + 1) >> size)
        size++;
    g->x1 = to_30_bits(g->x1, reciprocal, size);
    g->y1 = to_30_bits(g->y1, reciprocal, size);
    g->x2 = to_30_bits(g->x2, reciprocal, size);
    g->y2 = to_30_bits(g->y2, reciprocal, size);
    g->shift = 42 - (int32_t)zeros - size; /* above 0: sides have at most 8 bits more than the area, halved */
}

/*
 * Begins gradients. Narrow triangles, none of them steep, keep whole sides and a 1/area of 16 bits: slopes are sums of
 * products without rounding, times 1/area. A plane's value at a pixel of the triangle is then off by at most 2^-15 of
 * the corners' difference, or of 2^17 if they differ by less; 2^-12 where the area is below a pixel, 2^-10 below 1/32;
 * and a step for each pixel from the anchor.
 */
static inline void set_gradients(glint_gradients *g, uint32_t area, int steep) {
    const uint32_t reach = glint_magnitude_bits(g->x2) | glint_magnitude_bits(g->y2) | glint_magnitude_bits(g->x1) |
                           glint_magnitude_bits(g->y1);
    g->reach = reach;
    const uint32_t zeros = glint_leading_zeros(area);
    if (reach >> NARROW_SIZE || reach >> NARROW_SLIVER > area || steep) {
        g->reciprocal = 0;
        g->shift = 0;
        if (glint_slenderness(g, (int32_t)area) <= GLINT_SLENDER)
            widen(g, area, zeros);
        return;
    }
    g->reciprocal = glint_reciprocal16(((area << zeros >> 15) + 1) >> 1);
    g->shift = 31 - (int32_t)zeros;
}

static inline int32_t high_sum(int32_t d1, int32_t g1, int32_t d2, int32_t g2) {
    return (int32_t)glint_shift_right64((int64_t)d1 * g1 + (int64_t)d2 * g2, 31);
}

/* Sets a plane from slopes that are 2^-n of its own. */
static inline void finish_plane(glint_plane *p, const glint_gradients *g, int32_t start, int32_t dx, int32_t dy,
                                int32_t n) {
    const int32_t to_center = glint_shift_right(dx, 5) * g->to_center_x + glint_shift_right(dy, 5) * g->to_center_y;
    if (n < 0) {
        p->dx = glint_shift_right(dx, (unsigned)-n);
        p->dy = glint_shift_right(dy, (unsigned)-n);
        p->start = glint_add_wrap(start, glint_shift_right(to_center, (unsigned)~n));
    } else { /* slivers' may wrap */
        p->dx = glint_shift_left(dx, (unsigned)n);
        p->dy = glint_shift_left(dy, (unsigned)n);
        p->start = glint_add_wrap(start, glint_shift_left(to_center, (unsigned)n + 1));
    }
}

/* Brings differences to 18 bits and a sign: they were 2^up times as large. */
static inline void begin_narrow(glint_plane *p, const glint_gradients *g, int32_t start, int32_t d1, int32_t d2) {
    int32_t up = 14 - (int32_t)glint_leading_zeros(glint_magnitude_bits(d1) | glint_magnitude_bits(d2));
    up = up > 0 ? up : 0;
    d1 = glint_shift_right(d1, (unsigned)up);
    d2 = glint_shift_right(d2, (unsigned)up);
    finish_plane(p, g, start, glint_slope_of(d1 * g->x1 + d2 * g->x2, g->reciprocal, 15),
                 glint_slope_of(d1 * g->y1 + d2 * g->y2, g->reciprocal, 15), up + 3 - g->shift);
}

/* Keeps all bits of small triangles' differences that there is room for. */
static inline void begin_wide(glint_plane *p, const glint_gradients *g, int32_t start, int32_t d1, int32_t d2) {
    const int32_t down = 16 - g->shift;
    const int32_t room = (int32_t)glint_leading_zeros(glint_magnitude_bits(d1) | glint_magnitude_bits(d2)) - 2;
    const int32_t up = glint_most(glint_least(room, down + 5), 0);
    d1 = glint_shift_left(d1, (unsigned)up);
    d2 = glint_shift_left(d2, (unsigned)up);
    finish_plane(p, g, start, high_sum(d1, g->x1, d2, g->x2), high_sum(d1, g->y1, d2, g->y2), down - up);
}

/* Across a slender triangle a plane may change by more than 2^32 from one pixel to the next, along it by next to
 * nothing. Whole slopes, of which 32 bits are kept, are off by less than a step for each pixel from the anchor. */
static GLINT_NOINLINE void begin_slender(glint_plane *p, const glint_gradients *g, int32_t start, int32_t d1,
                                         int32_t d2) {
    const int64_t area = find_area(g);
    const int64_t x = (int64_t)d1 * g->x1 + (int64_t)d2 * g->x2, y = (int64_t)d1 * g->y1 + (int64_t)d2 * g->y2;
    p->dx = (int32_t)(16 * x / area);
    p->dy = (int32_t)(16 * y / area);
    p->start = glint_add_wrap(start, (int32_t)((x * g->to_center_x + y * g->to_center_y) / area));
}

void glint_plane_begin(glint_plane *p, const glint_gradients *g, int32_t a0, int32_t a1, int32_t a2) {
    if (g->reciprocal)
        begin_narrow(p, g, a0, a1 - a0, a2 - a0);
    else if (!g->shift)
        begin_slender(p, g, a0, a1 - a0, a2 - a0);
    else
        begin_wide(p, g, a0, a1 - a0, a2 - a0);
}

/* The first is the largest depth, the second the room that a plane's rounding may need. */
#define TOP GLINT_DEPTH_TOP
#define ROOM (1 << 21)

/* Begins the depth of parallel rays, which lies above the top. */
static void begin_parallel(glint_part *part, const glint_triangle *t) {
    int32_t depth[3];
    for (int i = 0; i < 3; i++)
        depth[i] = (t->corners[i]->inverse_w - TOP) * (1 << 15);
    glint_plane_begin(&part->depth, &part->gradients, depth[0], depth[1], depth[2]);
}

/* Lowers a depth plane that rounding takes above the top at a corner. Its pixels would have 32 bits there. */
static GLINT_NOINLINE void keep_below_top(glint_part *part, const glint_triangle *t) {
    const glint_gradients *g = &part->gradients;
    glint_plane *depth = &part->depth;
    if (t->corners[0]->inverse_w > TOP)
        begin_parallel(part, t);
    for (int i = 1; i < 3; i++) {
        const int32_t x = t->corners[i]->x - t->corners[0]->x - g->to_center_x;
        const int32_t y = t->corners[i]->y - t->corners[0]->y - g->to_center_y;
        const int32_t there = glint_add_wrap(glint_multiply_wrap(glint_shift_right(depth->dx, 4), x),
                                             glint_multiply_wrap(glint_shift_right(depth->dy, 4), y));
        const uint32_t above = (uint32_t)depth->start + (uint32_t)there - TOP;
        if (above < ROOM)
            depth->start = glint_add_wrap(depth->start, -(int32_t)above);
    }
}

/* May the plane of two such depths, ORed, pass the top? */
static inline int comes_near(int32_t either) {
    return glint_add_wrap(either, ROOM) < 0;
}

/* Sets the first corner's place, the sides and the area. */
static inline void begin_sides(glint_part *part, glint_triangle *t) {
    const glint_vertex *a = t->corners[0], *b = t->corners[1], *c = t->corners[2];
    const int32_t x = a->x, y = a->y;
    glint_gradients *g = &part->gradients;
    g->to_center_x = 8 - (x & 15);
    g->to_center_y = 8 - (y & 15);
    part->x = glint_shift_right(part->window.left, 4) - glint_shift_right(x, 4);
    part->y = glint_shift_right(part->window.top, 4) - glint_shift_right(y, 4);
    g->x2 = b->y - y;
    g->y2 = x - b->x;
    g->x1 = y - c->y;
    g->y1 = c->x - x;
    t->area = find_area(g);
}

/* Is the depth ratio of a triangle above 8 to 16, by the bits of 1/w? The errors of narrow planes are then too large a
 * part of 1/w. */
static inline int is_steep(int32_t w, int32_t w1, int32_t w2) {
    const int32_t least = glint_shift_right(w | w1 | w2, 4);
    return w < least || w1 < least || w2 < least;
}

void glint_setup(glint_part *part, glint_triangle *t) {
    const int32_t w = t->corners[0]->inverse_w, w1 = t->corners[1]->inverse_w, w2 = t->corners[2]->inverse_w;
    begin_sides(part, t);
    set_gradients(&part->gradients, (uint32_t)t->area, is_steep(w, w1, w2));
    glint_plane_begin(&part->depth, &part->gradients, w, w1, w2);
    if (comes_near(w1 | w2))
        keep_below_top(part, t);
}
