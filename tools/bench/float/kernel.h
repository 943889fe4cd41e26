/* SPDX-License-Identifier: MIT */
/**
 * @file kernel.h
 * Scanlines: a triangle's spans, row by row, and their pixels. What is linear on the screen is stepped; the depth test
 * comes before light. Everything is inline, so that each kernel has the loops of its own kind.
 */
#ifndef FLOAT_KERNEL_H
#define FLOAT_KERNEL_H

#include "draw.h"
#include "number.h"
#include "shade.h"

/** What pixels are made of. */
typedef enum float_paint { FLOAT_FLAT, FLOAT_INTERPOLATED, FLOAT_ONE_DIRECTIONAL, FLOAT_LIGHTS } float_paint;

/** Which lights FLOAT_LIGHTS has. */
typedef enum float_lights { FLOAT_ONE_POINT, FLOAT_ONE_SPOT, FLOAT_MANY } float_lights;

/** A kernel: all of it constants. */
typedef struct float_loop {
    float_paint paint;
    float_lights lights;
    float_kind kind;
} float_loop;

/** A number that is linear on the screen: at the first column of a row, and its slopes. */
typedef struct float_plane {
    float value, right, down;
} float_plane;

typedef struct float_planes {
    float_plane x, y, z;
} float_planes;

/** A pixel's numbers. */
typedef struct float_fragment {
    float inverse_w;
    float_triple attribute, colour;
    float vx;
} float_fragment;

/** Of a row: what its pixels share of the way to the eye, (vx, vy, 1). */
typedef struct float_row {
    float vy;
    float square; /**< Of the way, without vx. */
    float light;  /**< The light's direction times the way, without vx. */
} float_row;

/* ---- Planes */

/** Sides of a triangle from its first corner, over twice its area, and where the first corner lies. */
typedef struct float_sides {
    float right_b, right_c, down_b, down_c; /**< Weights of the second and the third corner's differences. */
    float x, y;                             /**< From the first corner to the first column of its row. */
} float_sides;

FLOAT_INLINE float_plane plane_through(const float_sides *sides, float a, float b, float c) {
    const float ab = b - a, ac = c - a;
    float_plane plane;

    plane.right = ab * sides->right_b - ac * sides->right_c;
    plane.down = ac * sides->down_c - ab * sides->down_b;
    plane.value = a + plane.right * sides->x + plane.down * sides->y;
    return plane;
}

FLOAT_INLINE float_planes planes_through(const float_sides *sides, const float_triple *a, const float_triple *b,
                                         const float_triple *c) {
    return (float_planes){plane_through(sides, a->x, b->x, c->x), plane_through(sides, a->y, b->y, c->y),
                          plane_through(sides, a->z, b->z, c->z)};
}

FLOAT_INLINE float_triple planes_at(const float_planes *planes, float column) {
    return triple(planes->x.value + planes->x.right * column, planes->y.value + planes->y.right * column,
                  planes->z.value + planes->z.right * column);
}

FLOAT_INLINE void planes_down(float_planes *planes) {
    planes->x.value += planes->x.down;
    planes->y.value += planes->y.down;
    planes->z.value += planes->z.down;
}

FLOAT_INLINE float_triple step_right(float_triple value, const float_planes *planes) {
    return triple(value.x + planes->x.right, value.y + planes->y.right, value.z + planes->z.right);
}

/* ---- Pixels */

/** One directional light: vectors stay as long as they are, only products are divided. */
FLOAT_INLINE uint16_t shade_directional(const float_surface *surface, float_kind kind, const float_fragment *at,
                                        const float_row *row) {
    const float_lamp *lamp = surface->lamps;
    const float_triple n = at->attribute;
    const float toward = dot(n, lamp->light.vector);
    const int gated = kind.model == FLOAT_DIFFUSE || !float_has(surface, kind, FLOAT_UNGATED);
    const int coloured = float_has(surface, kind, FLOAT_COLOURS);

    if (!coloured && gated && toward <= 0) {
        return surface->dark;
    }
    float_light_sum light = float_begin_sum(surface, kind);
    if (!gated || toward > 0) {
        const float square = dot(n, n);
        if (gated || toward > 0) {
            light.diffuse = sum_scaled(light.diffuse, lamp->diffuse, toward / float_root(square));
        }
        if (kind.model != FLOAT_DIFFUSE) {
            const float way = kind.local ? at->vx * at->vx + row->square : 1;
            const float along = kind.local ? lamp->light.vector.x * at->vx + row->light : lamp->light.vector.z;
            const float facing = kind.local ? n.x * at->vx + (n.y * row->vy + n.z) : n.z;
            if (kind.model == FLOAT_BLINN_PHONG) {
                const float length = kind.local ? float_root(way) : 1;
                const float half = toward * length + facing;
                float_add_highlight(surface, kind, half * __builtin_fabsf(half), square * (way + length * along), lamp,
                                    1, &light);
            } else {
                const float mirrored = 2 * toward * facing - along * square;
                float_add_highlight(surface, kind, mirrored * __builtin_fabsf(mirrored), square * square * way, lamp, 1,
                                    &light);
            }
        }
    }
    const float_triple colour = coloured ? scaled(at->colour, 1 / at->inverse_w) : at->colour;
    return float_pixel(float_end_sum(surface, kind, &light, colour));
}

FLOAT_INLINE uint16_t shade_lights(const float_surface *surface, float_kind kind, float_lights lights,
                                   const float_fragment *at, const float_row *row) {
    const float_triple n = at->attribute;
    const float away = 1 / float_root(at->vx * at->vx + row->square);
    float_point point = {.normal = scaled(n, 1 / float_root(dot(n, n))), .nearness = at->inverse_w * away};
    float_light_sum light = float_begin_sum(surface, kind);

    point.way = triple(at->vx * away, row->vy * away, away);
    point.view = kind.local ? point.way : triple(0, 0, 1);
    point.facing_way = dot(point.normal, point.way);
    point.facing = kind.local ? point.facing_way : point.normal.z;
    if (lights == FLOAT_MANY) {
        float_add_lamps(surface, kind, &point, &light);
    } else {
        float_add_lamp(surface, kind, surface->lamps, &point, 1, lights == FLOAT_ONE_SPOT, &light);
    }
    const float_triple colour =
        float_has(surface, kind, FLOAT_COLOURS) ? scaled(at->colour, 1 / at->inverse_w) : at->colour;
    return float_pixel(float_end_sum(surface, kind, &light, colour));
}

FLOAT_INLINE uint16_t shade(const float_surface *surface, float_loop loop, uint16_t flat, const float_fragment *at,
                            const float_row *row) {
    return loop.paint == FLOAT_FLAT              ? flat
           : loop.paint == FLOAT_INTERPOLATED    ? float_pixel(scaled(at->attribute, 1 / at->inverse_w))
           : loop.paint == FLOAT_ONE_DIRECTIONAL ? shade_directional(surface, loop.kind, at, row)
                                                 : shade_lights(surface, loop.kind, loop.lights, at, row);
}

/* ---- Spans */

/** A triangle while it is walked down. */
typedef struct float_walk {
    float_plane inverse_w;
    float_planes attribute, colour;
    float left, right;           /**< Columns. */
    float left_step, right_step; /**< From a row to the next. */
    uint16_t *pixels;
    int32_t *depth;
    int32_t row;
    uint16_t flat;
} float_walk;

FLOAT_INLINE int has_colours(float_loop loop) {
    return loop.paint >= FLOAT_ONE_DIRECTIONAL && (loop.kind.options & (FLOAT_COLOURS | FLOAT_ANY)) != 0;
}

FLOAT_INLINE int has_way(float_loop loop) {
    return loop.paint == FLOAT_LIGHTS ||
           (loop.paint == FLOAT_ONE_DIRECTIONAL && loop.kind.model != FLOAT_DIFFUSE && loop.kind.local);
}

FLOAT_INLINE float_row begin_row(const float_draw *draw, float_loop loop, int32_t row) {
    float_row result = {0, 0, 0};

    if (has_way(loop)) {
        const float_triple light = draw->surface.lamps[0].light.vector;
        result.vy = ((float)row + draw->frame->middle_y) * draw->frame->pixel;
        result.square = result.vy * result.vy + 1;
        result.light = light.y * result.vy + light.z;
    }
    return result;
}

FLOAT_INLINE void draw_span(const float_draw *draw, float_loop loop, const float_walk *walk, uint32_t first,
                            uint32_t end) {
    const float column = (float)first;
    const float_row row = begin_row(draw, loop, walk->row);
    float_fragment at = {.inverse_w = walk->inverse_w.value + walk->inverse_w.right * column};
    uint16_t *const pixels = walk->pixels;
    int32_t *const depth = walk->depth;

    at.vx = has_way(loop) ? (draw->frame->middle_x - column) * draw->frame->pixel : 0;
    at.attribute = loop.paint != FLOAT_FLAT ? planes_at(&walk->attribute, column) : triple(0, 0, 0);
    at.colour = has_colours(loop) ? planes_at(&walk->colour, column) : triple(0, 0, 0);
    for (uint32_t i = first; i < end; i++) {
        const int32_t bits = float_bits(at.inverse_w);
        if (bits > depth[i]) {
            depth[i] = bits;
            pixels[i] = shade(&draw->surface, loop, walk->flat, &at, &row);
        }
        at.inverse_w += walk->inverse_w.right;
        at.attribute = step_right(at.attribute, &walk->attribute);
        at.colour = step_right(at.colour, &walk->colour);
        at.vx -= draw->frame->pixel;
    }
}

FLOAT_INLINE void draw_rows(const float_draw *draw, float_loop loop, float_walk *walk, int32_t end_row) {
    const uint32_t width = draw->frame->screen->width;

    for (; walk->row < end_row; walk->row++) {
        const uint32_t first = float_whole(walk->left), right = float_whole(walk->right);
        const uint32_t end = right < width ? right : width;
        if (first < end) {
            draw_span(draw, loop, walk, first, end);
        }
        walk->left += walk->left_step;
        walk->right += walk->right_step;
        walk->inverse_w.value += walk->inverse_w.down;
        planes_down(&walk->attribute);
        planes_down(&walk->colour);
        walk->pixels += width;
        walk->depth += width;
    }
}

/* ---- Triangles */

/** An edge from its first row on. */
typedef struct float_edge {
    float column, step;
} float_edge;

FLOAT_INLINE float_edge edge_between(const float_vertex *from, const float_vertex *to) {
    const float step = (to->x - from->x) / (to->y - from->y);

    return (float_edge){from->x + step * from->step, step};
}

FLOAT_INLINE void order(const float_vertex **a, const float_vertex **b) {
    if ((*b)->row < (*a)->row) {
        const float_vertex *const other = *a;
        *a = *b;
        *b = other;
    }
}

/** One half of a triangle, above or below its middle corner; one of its sides is that of both halves. */
FLOAT_INLINE void draw_half(const float_draw *draw, float_loop loop, float_walk *walk, int bends_right,
                            const float_vertex *from, const float_vertex *to) {
    if (from->row < to->row) {
        const float_edge edge = edge_between(from, to);
        if (bends_right) {
            walk->right = edge.column;
            walk->right_step = edge.step;
        } else {
            walk->left = edge.column;
            walk->left_step = edge.step;
        }
        draw_rows(draw, loop, walk, to->row);
    }
}

FLOAT_INLINE void put_planes(const float_draw *draw, float_loop loop, float_walk *walk, const float_sides *sides,
                             const float_vertex *a, const float_vertex *b, const float_vertex *c) {
    const float_vertex *vertices = draw->frame->memory->vertices;
    const float_triple *colours = draw->frame->memory->colours;

    walk->inverse_w = plane_through(sides, a->inverse_w, b->inverse_w, c->inverse_w);
    if (loop.paint != FLOAT_FLAT) {
        walk->attribute = planes_through(sides, &a->attribute, &b->attribute, &c->attribute);
    }
    if (has_colours(loop)) {
        walk->colour = planes_through(sides, &colours[a - vertices], &colours[b - vertices], &colours[c - vertices]);
    }
}

FLOAT_INLINE void draw_triangle(const float_draw *draw, float_loop loop, const float_triangle *triangle,
                                uint16_t flat) {
    const float_screen *screen = draw->frame->screen;
    const float_vertex *const vertices = draw->frame->memory->vertices;
    const float_vertex *a = &vertices[triangle->corner[0]], *b = &vertices[triangle->corner[1]],
                       *c = &vertices[triangle->corner[2]];

    order(&a, &b);
    order(&b, &c);
    order(&a, &b);
    const float ab_x = b->x - a->x, ab_y = b->y - a->y, ac_x = c->x - a->x, ac_y = c->y - a->y;
    const float area = ab_x * ac_y - ac_x * ab_y, inverse = 1 / area;
    const float_sides sides = {
        ac_y * inverse, ab_y * inverse, ac_x * inverse, ab_x * inverse, FLOAT_COLUMN + 0.5f - a->x, a->step};
    const int bends_right = area > 0;
    float_walk walk = {.row = a->row, .flat = flat};
    if (a->row >= c->row) {
        return;
    }
    const float_edge edge = edge_between(a, c);
    walk.left = walk.right = edge.column;
    walk.left_step = walk.right_step = edge.step;
    walk.pixels = screen->colour + (uint32_t)a->row * screen->width;
    walk.depth = screen->depth + (uint32_t)a->row * screen->width;
    put_planes(draw, loop, &walk, &sides, a, b, c);
    for (int half = 0; half < 2; half++) { /* a loop, so that rows and pixels are there once */
        draw_half(draw, loop, &walk, bends_right, half ? b : a, half ? c : b);
    }
}

FLOAT_INLINE void draw_list(const float_draw *draw, float_loop loop) {
    const float_triangle *triangle = draw->frame->memory->triangles;
    const float_triangle *const end = triangle + draw->count;
    const uint16_t *facet = draw->facets;

    for (; triangle < end; triangle++) {
        draw_triangle(draw, loop, triangle, loop.paint == FLOAT_FLAT ? facet ? *facet++ : draw->surface.dark : 0);
    }
}

#endif
