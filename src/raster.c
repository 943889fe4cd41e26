/* SPDX-License-Identifier: MIT */
/*
 * Raster: the part of a triangle that lies in one tile, as spans of pixels for a kernel to draw.
 *
 * Coverage is exact. An edge gives each row the first column whose centre is not left of it, for left and right edges
 * alike: a shared edge gives each pixel to one side. Of a triangle whose corners run clockwise, the edges that run down
 * are the right ones.
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

static uint8_t clamp(int32_t column, int32_t width) {
    return (uint8_t)(column < 0 ? 0 : column > width ? width : column);
}

/* Any edge, by quotient and remainder; `down` is from its top to the first row's centres. */
static void walk_exactly(uint8_t *column, const uint8_t *end, int32_t x, int32_t dx, int32_t dy, int32_t down,
                         int32_t width) {
    /* Numerators stay below 2^31: |dx|, dy < 2^15, |x| < 2^15. */
    const int32_t divisor = 16 * dy;
    int32_t rest, step_rest;
    int32_t at = divide_floor(x * dy + down * dx + divisor - 1, divisor, &rest);
    const int32_t step = divide_floor(dx, dy, &step_rest);
    for (; column != end; column += 2) {
        *column = clamp(at, width);
        at += step;
        rest += 16 * step_rest;
        if (rest >= divisor) {
            rest -= divisor;
            at++;
        }
    }
}

/* A short edge, from x in Q20; see division.h. */
static void walk(uint8_t *column, const uint8_t *end, int32_t x, int32_t slope, int32_t width) {
    const int32_t last = x + slope * ((int32_t)(end - column) / 2 - 1), limit = (width + 1) << 20;
    if ((uint32_t)x < (uint32_t)limit && (uint32_t)last < (uint32_t)limit) {
        do {
            *column = (uint8_t)(x >> 20);
            column += 2;
            x += slope;
        } while (column != end);
        return;
    }
    for (; column != end; column += 2, x += slope)
        *column = clamp(glint_shift_right(x, 20), width);
}

/* Finds one side of the spans that lie between two corners. */
static void find_side(glint_span *spans, const glint_range *tile, const glint_place *a, const glint_place *b) {
    int32_t top = a->row, bottom = b->row, above = 0;
    uint8_t *side = &spans->right;
    if (top > bottom) {
        const glint_place *place = a;
        a = b, b = place;
        bottom = top, top = a->row;
        side = &spans->left;
    }
    if (top < 0) /* rows of the edge lie above the tile */
        above = -top, top = 0;
    bottom = bottom > tile->bottom ? tile->bottom : bottom;
    if (top >= bottom)
        return;
    const int32_t dx = b->x - a->x, dy = b->y - a->y;
    if (dy >= GLINT_EDGE_DY || dx >= GLINT_EDGE_DX || dx <= -GLINT_EDGE_DX) {
        walk_exactly(side + 2 * top, side + 2 * bottom, a->x, dx, dy, 16 * above + (-a->y & 15), tile->right);
        return;
    }
    const int32_t slope = glint_slope(dx, dy);
    const int32_t x = a->x * (1 << 16) + GLINT_EDGE_CEILING + glint_edge_start(slope, a->y) + slope * above;
    walk(side + 2 * top, side + 2 * bottom, x, slope, tile->right);
}

/* The triangle's spans in the tile. @return 0 when it has no rows there */
static int find_spans(glint_part *part, const glint_range *tile) {
    const glint_place *places = part->places;
    int32_t top = places[0].row, bottom = places[1].row;
    if (top > bottom)
        top = places[1].row, bottom = places[0].row;
    top = top < places[2].row ? top : places[2].row;
    top = top < 0 ? 0 : top;
    bottom = bottom > places[2].row ? bottom : places[2].row;
    bottom = bottom < tile->bottom ? bottom : tile->bottom;
    if (top >= bottom)
        return 0;
    part->top = (uint32_t)top;
    part->bottom = (uint32_t)bottom;
    find_side(part->spans, tile, &places[0], &places[1]);
    find_side(part->spans, tile, &places[1], &places[2]);
    find_side(part->spans, tile, &places[2], &places[0]);
    return 1;
}

static void find_place(glint_place *place, const glint_range *tile, const glint_vertex *v) {
    place->x = v->x - tile->left;
    place->y = v->y - tile->top;
    place->row = glint_shift_right(place->y + 15, 4);
}

/* Corners and area; orders the corners clockwise. */
static void find_places(glint_part *part, glint_triangle *t, const glint_range *tile, int mirrored) {
    glint_place *places = part->places;
    find_place(&places[0], tile, t->corners[0]);
    find_place(&places[1], tile, t->corners[1]);
    find_place(&places[2], tile, t->corners[2]);
    t->area = (places[1].x - places[0].x) * (places[2].y - places[0].y) -
              (places[2].x - places[0].x) * (places[1].y - places[0].y);
    t->back = (t->area > 0) != mirrored;
    if (t->area < 0) {
        const glint_vertex *corner = t->corners[1];
        const int16_t *extra = t->extra[1];
        const glint_place place = places[1];
        t->corners[1] = t->corners[2];
        t->corners[2] = corner;
        t->extra[1] = t->extra[2];
        t->extra[2] = extra;
        places[1] = places[2];
        places[2] = place;
        t->area = -t->area;
    }
    part->x = -glint_shift_right(places[0].x + 8, 4);
    part->y = -glint_shift_right(places[0].y + 8, 4);
}

void glint_raster(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                  glint_triangle *triangle) {
    const glint_fragments *fragments = workspace->fragments;
    const glint_range tile = {16 * fragments->tile_x + 8, 16 * fragments->tile_y + 8, fragments->tile_width,
                              fragments->tile_height};
    glint_part part;
    find_places(&part, triangle, &tile, draw->mirrored);
    if (!find_spans(&part, &tile))
        return;
    glint_setup(&part, triangle);
    glint_choose_kernel(frame, draw, triangle)(frame, workspace, draw, triangle, &part);
}
