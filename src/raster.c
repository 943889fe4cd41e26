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

/* Finds one side of the spans between two corners that follow each other counter-clockwise. */
static void find_side(glint_part *part, const glint_place *a, const glint_place *b) {
    uint8_t *side = &part->spans[0].left;
    if (a->row > b->row) { /* edges that run up are right ones */
        const glint_place *place = a;
        a = b;
        b = place;
        side = &part->spans[0].right;
    }
    const int32_t height = part->window.height, width = part->window.width;
    int32_t top = a->row, rows = b->row < height ? b->row : height;
    if (top >= rows || rows <= 0)
        return;
    const int32_t above = top < 0 ? -top : 0; /* rows of the edge above the tile */
    top += above;
    rows -= top;
    side += sizeof(glint_span) * (uint32_t)top;
    const int32_t dx = b->x - a->x, dy = b->y - a->y;
    edge e;
    if (part->gradients.size >= GLINT_EDGE_SIZE &&
        (dy >= GLINT_EDGE_DY || dx >= GLINT_EDGE_DX || dx <= -GLINT_EDGE_DX)) {
        begin_exactly(&e, a->x, dx, dy, 16 * above + (-a->y & 15));
    } else {
        const int32_t slope = glint_slope(dx, dy);
        int32_t x = a->x * (1 << 16) + GLINT_EDGE_CEILING + glint_edge_start(slope, a->y) + slope * above;
        const uint32_t limit = (uint32_t)(width + 1) << 20;
        if ((uint32_t)x < limit && (uint32_t)(x + slope * (rows - 1)) < limit) {
            do {
                *side = (uint8_t)(x >> 20);
                side += sizeof(glint_span);
                x += slope;
            } while (--rows);
            return;
        }
        const int32_t mask = (1 << 20) - 1;
        e = (edge){glint_shift_right(x, 20), x & mask, glint_shift_right(slope, 20), slope & mask, mask + 1};
    }
    walk(&e, side, rows, width);
}

static void find_place(glint_place *place, const glint_window *window, const glint_vertex *v) {
    place->x = v->x - window->left;
    place->y = v->y - window->top;
    place->row = glint_shift_right(place->y + 15, 4);
}

/* The triangle's rows in the tile. @return 0 when there are none */
static int find_rows(glint_part *part) {
    const int32_t a = part->places[0].row, b = part->places[1].row, c = part->places[2].row;
    int32_t top = a < b ? a : b, bottom = a < b ? b : a;
    top = top < c ? top : c;
    bottom = bottom > c ? bottom : c;
    bottom = bottom < part->window.height ? bottom : part->window.height;
    top = top < 0 ? 0 : top;
    part->top = (uint32_t)top;
    part->bottom = (uint32_t)bottom;
    return top < bottom;
}

void glint_raster(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                  glint_triangle *triangle, glint_part *part) {
    glint_place *places = part->places;
    const glint_vertex *const *v = triangle->corners;
    const int32_t area = glint_double_area(v[0], v[1], v[2]);
    triangle->clockwise = area > 0;
    triangle->area = area < 0 ? -area : area;
    triangle->back = triangle->clockwise != draw->mirrored;
    find_place(&places[0], &part->window, v[0]);
    find_place(&places[1], &part->window, v[1]);
    find_place(&places[2], &part->window, v[2]);
    if (!find_rows(part))
        return;
    part->x = -glint_shift_right(places[0].x + 8, 4);
    part->y = -glint_shift_right(places[0].y + 8, 4);
    glint_setup(part, triangle);
    const glint_place *second = &places[1 + triangle->clockwise], *third = &places[2 - triangle->clockwise];
    find_side(part, places, second);
    find_side(part, second, third);
    find_side(part, third, places);
    draw->kernel(frame, workspace, draw, triangle, part);
}
