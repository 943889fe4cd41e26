/* SPDX-License-Identifier: MIT */
/* Clips triangles that cross the near plane or leave the guard band (Sutherland and Hodgman, 1974). An edge is cut
 * from its inner towards its outer end, so that the triangles on both its sides get the same corner. */
#include "geometry.h"

#define PLANES 5

/* Returns the w at which x reaches the guard band: a position's own, or that of parallel rays. */
static inline int32_t side_of(const glint_transform *transform, int32_t w) {
    return transform->clips & GLINT_PARALLEL ? transform->nearest : w;
}

/* Returns how far inside a plane a position lies. Plane 0 is the near plane, 1 to 4 are the sides. */
static int64_t distance(const glint_transform *transform, const glint_position *p, int plane) {
    const int64_t side = side_of(transform, p->w);
    switch (plane) {
    case 0:
        return (int64_t)p->w - transform->near_plane;
    case 1:
        return side + p->x;
    case 2:
        return side - p->x;
    case 3:
        return side + p->y;
    default:
        return side - p->y;
    }
}

/* Computes a + (b - a) t, t Q31. */
static int32_t mix_ends(int32_t a, int32_t b, int64_t t) {
    return (int32_t)(a + glint_round_shift64(((int64_t)b - a) * t, 31));
}

/* Cuts an edge at a plane, given distances inside >= 0 > outside, at most 2^31 from 0. */
static void cut(const glint_corner *from, const glint_corner *to, int64_t inside, int64_t outside, glint_corner *out) {
    const int64_t t = inside * ((int64_t)1 << 31) / (inside - outside); /* Q31, from 0 to 1 */
    out->position.x = mix_ends(from->position.x, to->position.x, t);
    out->position.y = mix_ends(from->position.y, to->position.y, t);
    out->position.w = mix_ends(from->position.w, to->position.w, t);
    for (int i = 0; i < 6; i++)
        out->attribute[i] = (int16_t)mix_ends(from->attribute[i], to->attribute[i], t);
}

static int clip_at(const glint_transform *transform, int plane, const glint_corner *in, int count, glint_corner *out) {
    int kept = 0;
    int64_t d1 = distance(transform, &in[0].position, plane);
    for (int i = 0; i < count; i++) {
        const glint_corner *here = &in[i], *next = &in[i + 1 < count ? i + 1 : 0];
        const int64_t d0 = d1;
        d1 = distance(transform, &next->position, plane);
        const int more = (d0 >= 0) + ((d0 >= 0) != (d1 >= 0));
        if (kept + more > GLINT_CLIP_CORNERS) /* a plane adds one corner; rounding may add more, which are points */
            break;
        if (d0 >= 0)
            out[kept++] = *here;
        if (d0 >= 0 && d1 < 0)
            cut(here, next, d0, d1, &out[kept++]);
        else if (d0 < 0 && d1 >= 0)
            cut(next, here, d1, d0, &out[kept++]);
    }
    return kept;
}

/* Brings a cut corner, which may lie a step outside, onto the guard band, where projection is safe. */
static void keep_inside(const glint_transform *transform, glint_position *p) {
    p->w = glint_most(p->w, transform->near_plane);
    const int32_t side = side_of(transform, p->w);
    p->x = p->x > side ? side : p->x < -side ? -side : p->x;
    p->y = p->y > side ? side : p->y < -side ? -side : p->y;
}

int glint_clip(const glint_transform *transform, glint_corner corners[GLINT_CLIP_CORNERS]) {
    glint_corner other[GLINT_CLIP_CORNERS], *in = corners, *out = other;
    int count = 3;
    for (int plane = 0; plane < PLANES && count; plane++) {
        count = clip_at(transform, plane, in, count, out);
        glint_corner *last = in;
        in = out;
        out = last;
    }
    for (int i = 0; i < count; i++) {
        corners[i] = in[i];
        keep_inside(transform, &corners[i].position);
    }
    return count;
}
