/* SPDX-License-Identifier: MIT */
/*
 * Raster: the part of a triangle that lies in one tile, as spans of pixels for a kernel to draw.
 *
 * Coverage is exact. An edge gives each row the first column whose centre is not left of it, for left and right edges
 * alike: a shared edge gives each pixel to one side.
 */
#include "division.h"
#include "setup.h"

/* floor(a / b), b above 0 */
static int32_t divide_floor(int32_t a, int32_t b, int32_t *remainder) {
    int32_t quotient = a / b;
    int32_t rest = a - quotient * b;
    if (rest < 0) {
        quotient--;
        rest += b;
    }
    *remainder = rest;
    return quotient;
}

/* An edge on its way down: the column at or right of where it crosses a row is `column`, and rest / divisor of one. */
typedef struct edge {
    int32_t column, rest, step, step_rest, divisor;
} edge;

/* Any edge, exactly; `down` is from its top to the first row's centres. Numerators: |dx|, dy < 2^15, |x| < 2^15. */
static void begin_exactly(edge *e, int32_t x, int32_t dx, int32_t dy, int32_t down) {
    e->divisor = 16 * dy;
    e->column = divide_floor(x * dy + down * dx + e->divisor - 1, e->divisor, &e->rest);
    e->step = divide_floor(dx, dy, &e->step_rest);
    e->step_rest *= 16;
}

static void walk(edge *e, uint8_t *side, int32_t rows, int32_t width) {
    for (; rows; rows--, side += sizeof(glint_span)) {
        *side = (uint8_t)(e->column < 0 ? 0 : e->column > width ? width : e->column);
        e->column += e->step;
        e->rest += e->step_rest;
        if (e->rest >= e->divisor) {
            e->rest -= e->divisor;
            e->column++;
        }
    }
}

/* The rows of a side in the tile. */
typedef struct side {
    const glint_place *a, *b; /* its upper and its lower corner */
    uint8_t *column;          /* of the first row */
    int32_t rows;
    int32_t above; /* rows above the tile */
} side;

/* Any edge; `down` is from its top to the first row's centres. */
static void find_exactly(const glint_part *part, const side *s) {
    const int32_t dx = s->b->x - s->a->x, dy = s->b->y - s->a->y;
    edge e;
    begin_exactly(&e, s->a->x, dx, dy, 16 * s->above + (-s->a->y & 15));
    walk(&e, s->column, s->rows, part->window.width);
}

/* A short edge, from where it crosses the first row, Q20, by its slope; it leaves the tile. */
static void find_clamped(const glint_part *part, const side *s, int32_t x, int32_t slope) {
    const int32_t width = part->window.width;
    uint8_t *column = s->column;
    for (int32_t row = 0; row < s->rows; row++) {
        const int32_t whole = glint_shift_right(x, 20), inside = whole < 0 ? 0 : whole;
        *column = (uint8_t)(inside > width ? width : inside);
        column += sizeof(glint_span);
        x = glint_add_wrap(x, slope);
    }
}

/* Finds one side of the spans between two corners that follow each other counter-clockwise. */
static void find_side(glint_part *part, const glint_place *a, const glint_place *b) {
    side s = {a, b, &part->spans[0].left, 0, 0};
    if (a->row > b->row) /* edges that run up are right ones */
        s = (side){b, a, &part->spans[0].right, 0, 0};
    int32_t top = s.a->row, bottom = s.b->row < part->window.height ? s.b->row : part->window.height;
    if (top < 0) {
        s.above = -top;
        top = 0;
    }
    s.rows = bottom - top;
    if (s.rows <= 0)
        return;
    s.column += sizeof(glint_span) * (uint32_t)top;
    const int32_t dx = s.b->x - s.a->x, dy = s.b->y - s.a->y;
    if ((GLINT_SMALL && GLINT_DIVIDES) || dy >= GLINT_EDGE_DY || dx >= GLINT_EDGE_DX || dx <= -GLINT_EDGE_DX) {
        find_exactly(part, &s);
        return;
    }
    const int32_t slope = glint_slope(dx, dy);
    int32_t x = s.a->x * (1 << 16) + GLINT_EDGE_CEILING + glint_edge_start(slope, s.a->y) + slope * s.above;
    const uint32_t limit = (uint32_t)(part->window.width + 1) << 20;
    if ((uint32_t)x >= limit || (uint32_t)(x + slope * (s.rows - 1)) >= limit) {
        find_clamped(part, &s, x, slope);
        return;
    }
    uint8_t *column = s.column;
    int32_t rows = s.rows;
    do {
        *column = (uint8_t)(x >> 20);
        column += sizeof(glint_span);
        GLINT_OPAQUE(column);
        x += slope;
    } while (--rows);
}

static inline void find_place(glint_place *place, const glint_window *window, const glint_vertex *v) {
    place->x = v->x - window->left;
    place->y = v->y - window->top;
    place->row = glint_shift_right(place->y + 15, 4);
}

/* As find_side, of a short side that lies in the tile. */
static inline void find_inside(glint_part *part, const glint_place *a, const glint_place *b) {
    uint8_t *column = &part->spans[0].left;
    int32_t rows = b->row - a->row;
    if (rows < 0) {
        const glint_place *upper = b;
        b = a, a = upper;
        rows = -rows;
        column = &part->spans[0].right;
    }
    if (!rows)
        return;
    const int32_t slope = glint_slope(b->x - a->x, b->y - a->y);
    int32_t x = a->x * (1 << 16) + GLINT_EDGE_CEILING + glint_edge_start(slope, a->y);
    column += sizeof(glint_span) * (uint32_t)a->row;
    do {
        *column = (uint8_t)(x >> 20);
        column += sizeof(glint_span);
        GLINT_OPAQUE(column);
        x += slope;
    } while (--rows);
}

static inline int is_across(const glint_window *window, const glint_place *place) {
    return (uint32_t)(place->x + 8) < (uint32_t)window->width << 4;
}

/* Finds the triangle's spans in the tile. @return 0 when it has no rows there */
static int find_spans(glint_part *part) {
    const glint_place *places = part->places;
    const int32_t a = places[0].row, b = places[1].row, c = places[2].row;
    int32_t top = a < b ? a : b, bottom = a < b ? b : a;
    top = top < c ? top : c;
    bottom = bottom > c ? bottom : c;
    if (!GLINT_SMALL && top >= 0 && bottom <= part->window.height && bottom - top < GLINT_EDGE_DY / 16 &&
        is_across(&part->window, &places[0]) && is_across(&part->window, &places[1]) &&
        is_across(&part->window, &places[2])) {
        part->top = (uint32_t)top;
        part->bottom = (uint32_t)bottom;
        find_inside(part, &places[0], &places[1]);
        find_inside(part, &places[1], &places[2]);
        find_inside(part, &places[2], &places[0]);
        return top < bottom;
    }
    bottom = bottom < part->window.height ? bottom : part->window.height;
    top = top < 0 ? 0 : top;
    part->top = (uint32_t)top;
    part->bottom = (uint32_t)bottom;
    if (top >= bottom)
        return 0;
    find_side(part, &places[0], &places[1]);
    find_side(part, &places[1], &places[2]);
    find_side(part, &places[2], &places[0]);
    return 1;
}

/* Leaves out rows without pixels above the first that has some. @return 0 when none has */
static inline int has_pixels(glint_part *part) {
    uint32_t top = part->top;
    while (part->spans[top].left >= part->spans[top].right)
        if (++top == part->bottom)
            return 0;
    part->top = top;
    return 1;
}

/* Puts the corners of a triangle that runs clockwise on the screen in the other order. */
static void turn_round(glint_triangle *triangle, int has_extra) {
    const glint_vertex *corner = triangle->corners[1];
    triangle->corners[1] = triangle->corners[2];
    triangle->corners[2] = corner;
    if (has_extra) {
        const int16_t *extra = triangle->extra[1];
        triangle->extra[1] = triangle->extra[2];
        triangle->extra[2] = extra;
    }
}

void glint_raster(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                  glint_triangle *triangle, glint_part *part) {
    const glint_vertex *const *v = triangle->corners;
    glint_place *places = part->places;
    triangle->area = -glint_double_area(v[0], v[1], v[2]);
    triangle->back = (triangle->area < 0) != draw->mirrored;
    if (triangle->area < 0) {
        triangle->area = -triangle->area;
        turn_round(triangle, draw->extra != 0);
    }
    find_place(&places[0], &part->window, v[0]);
    find_place(&places[1], &part->window, v[1]);
    find_place(&places[2], &part->window, v[2]);
    if (!find_spans(part) || !has_pixels(part))
        return;
    part->x = -glint_shift_right(places[0].x + 8, 4);
    part->y = -glint_shift_right(places[0].y + 8, 4);
    glint_setup(part, triangle);
    draw->kernel(frame, workspace, draw, triangle, part);
}
