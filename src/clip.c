/* SPDX-License-Identifier: MIT */
/*
 * Clip: triangles that cross the near plane or leave the guard band (Sutherland and Hodgman, 1974). An edge is cut
 * from its inner towards its outer end, so that the triangles on both its sides get the same corner.
 */
#include "frame.h"

typedef struct corner {
    glint_position position;
    int32_t normal[3]; /* unit Q15, shortened where interpolated */
} corner;

#define PLANES 5

/* How far inside a plane a position lies: 0 the near plane, 1 to 4 the sides. */
static int64_t distance(const glint_position *p, int plane, int32_t near_plane) {
    switch (plane) {
    case 0:
        return (int64_t)p->w - near_plane;
    case 1:
        return (int64_t)p->w + p->x;
    case 2:
        return (int64_t)p->w - p->x;
    case 3:
        return (int64_t)p->w + p->y;
    default:
        return (int64_t)p->w - p->y;
    }
}

/* a + (b - a) t, t Q31. */
static int32_t mix(int32_t a, int32_t b, int64_t t) {
    return a + (int32_t)glint_round_shift64(((int64_t)b - a) * t, 31);
}

/* inside and outside: distances, inside >= 0 > outside; both below 2^32. */
static void cut(const corner *from, const corner *to, int64_t inside, int64_t outside, corner *out) {
    uint64_t whole = (uint64_t)(inside - outside);
    unsigned bits = glint_bits64(whole), down = bits > 32 ? bits - 32 : 0;
    int64_t t = (int64_t)((((uint64_t)inside >> down) << 31) / (whole >> down));
    out->position.x = mix(from->position.x, to->position.x, t);
    out->position.y = mix(from->position.y, to->position.y, t);
    out->position.w = mix(from->position.w, to->position.w, t);
    for (int i = 0; i < 3; i++)
        out->normal[i] = mix(from->normal[i], to->normal[i], t);
}

static int clip_at(int plane, int32_t near_plane, const corner *in, int count, corner *out) {
    int kept = 0;
    for (int i = 0; i < count; i++) {
        const corner *here = &in[i], *next = &in[i + 1 < count ? i + 1 : 0];
        int64_t d0 = distance(&here->position, plane, near_plane);
        int64_t d1 = distance(&next->position, plane, near_plane);
        if (kept > GLINT_CLIP_CORNERS - 2) /* a plane adds one corner; rounding may tell of more: those are points */
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

/* A cut corner may lie a step outside: bring it onto the guard band, where projection is safe. */
static void keep_inside(glint_position *p, int32_t near_plane) {
    p->w = p->w < near_plane ? near_plane : p->w;
    p->x = p->x > p->w ? p->w : p->x < -p->w ? -p->w : p->x;
    p->y = p->y > p->w ? p->w : p->y < -p->w ? -p->w : p->y;
}

int glint_clip(const glint_transform *transform, const glint_vertex *const corners[3],
               const glint_position *const positions[3], glint_vertex out[GLINT_CLIP_CORNERS]) {
    corner polygons[2][GLINT_CLIP_CORNERS];
    int count = 3;
    for (int i = 0; i < 3; i++) {
        polygons[0][i].position = *positions[i];
        for (int j = 0; j < 3; j++)
            polygons[0][i].normal[j] = corners[i]->normal[j];
    }
    for (int plane = 0; plane < PLANES && count; plane++)
        count = clip_at(plane, transform->near_plane, polygons[plane & 1], count, polygons[~plane & 1]);
    for (int i = 0; i < count; i++) {
        corner *c = &polygons[PLANES & 1][i];
        keep_inside(&c->position, transform->near_plane);
        glint_project(transform, &c->position, &out[i]);
        for (int j = 0; j < 3; j++)
            out[i].normal[j] = (int16_t)c->normal[j];
        out[i].flags = 0;
    }
    return count;
}
