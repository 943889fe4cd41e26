/* SPDX-License-Identifier: MIT */
/*
 * Raster: the part of a triangle that lies in one tile, as spans of pixels for a kernel to draw.
 *
 * Coverage is exact. An edge gives each row the first column whose centre is not left of it, for left and right edges
 * alike: a shared edge gives each pixel to one side.
 */
#include "raster.h"

#include "../math/division.h"

/* Leaves out rows without pixels above the first that has some. @return 0 when none has */
static inline int has_pixels(glint_part *part) {
    for (const glint_span *s = part->spans + part->top; s->left >= s->right; s++)
        if (++part->top == part->bottom)
            return 0;
    return 1;
}

/* ---- Any triangle ---- */

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

/* Any edge, exactly, given `divisor` times the column of its first row. */
static void begin_exactly(edge *e, int32_t first, int32_t dx, int32_t dy) {
    e->divisor = 16 * dy;
    e->column = divide_floor(first, e->divisor, &e->rest);
    e->step = divide_floor(dx, dy, &e->step_rest);
    e->step_rest *= 16;
}

static inline void step_down(edge *e) {
    e->column += e->step;
    e->rest += e->step_rest;
    if (e->rest >= e->divisor) {
        e->rest -= e->divisor;
        e->column++;
    }
}

/* Walks an edge that keeps to the tile's columns. */
static void walk_inside(edge *e, uint8_t *side, int32_t rows) {
    for (; rows; rows--, side += sizeof(glint_span)) {
        *side = (uint8_t)e->column;
        step_down(e);
    }
}

static void walk(edge *e, uint8_t *side, int32_t rows, int32_t width) {
    for (; rows; rows--, side += sizeof(glint_span)) {
        *side = (uint8_t)(e->column < 0 ? 0 : e->column > width ? width : e->column);
        step_down(e);
    }
}

/* One beyond them. */
static void fill_side(uint8_t *side, int32_t rows, int32_t column) {
    for (; rows; rows--, side += sizeof(glint_span))
        *side = (uint8_t)column;
}

/* Any edge down some rows of a tile; `down` is from its top to the first row's centres. Numerators: |dx|, dy < 2^15,
 * |x| < 2^15. */
static void find_columns(uint8_t *side, int32_t rows, int32_t width, int32_t x, int32_t dx, int32_t dy, int32_t down) {
    const int32_t divisor = 16 * dy, first = x * dy + down * dx + divisor - 1, last = first + 16 * dx * (rows - 1);
    const int32_t low = glint_least(first, last), high = glint_most(first, last);
    edge e;
    if (!GLINT_SMALL && (high < divisor || low >= width * divisor)) {
        fill_side(side, rows, high < divisor ? 0 : width);
        return;
    }
    begin_exactly(&e, first, dx, dy);
    if (!GLINT_SMALL && low >= 0 && high < (width + 1) * divisor)
        walk_inside(&e, side, rows);
    else
        walk(&e, side, rows, width);
}

/* The first row of centres below a corner or at it, from the tile's first. */
static int32_t row_of(const glint_window *window, const glint_vertex *v) {
    return glint_shift_right(v->y - window->top + 15, 4);
}

/* Finds one side of the spans in the tile, between two corners that follow each other counter-clockwise. */
static void find_side(glint_part *part, const glint_vertex *a, const glint_vertex *b) {
    const glint_window *window = &part->window;
    uint8_t *column = &part->spans[0].left;
    if (a->y > b->y) { /* edges that run up are right ones */
        const glint_vertex *upper = b;
        b = a, a = upper;
        column = &part->spans[0].right;
    }
    const int32_t top = glint_most(row_of(window, a), 0), bottom = glint_least(row_of(window, b), window->height);
    if (top >= bottom)
        return;
    part->top = (uint32_t)glint_least((int32_t)part->top, top);
    part->bottom = (uint32_t)glint_most((int32_t)part->bottom, bottom);
    find_columns(column + sizeof(glint_span) * (uint32_t)top, bottom - top, window->width, a->x - window->left,
                 b->x - a->x, b->y - a->y, 16 * top + window->top - a->y);
}

static GLINT_NOINLINE int find_any(glint_part *part, const glint_vertex *const v[3]) {
    part->top = GLINT_TILE_MAX;
    part->bottom = 0;
    find_side(part, v[0], v[1]);
    find_side(part, v[1], v[2]);
    find_side(part, v[2], v[0]);
    return part->top < part->bottom && has_pixels(part);
}

/* ---- Short triangles ---- */
/*
 * Both sides of a short triangle are walked at once, by their slopes, from its top wherever the tile begins: rows above
 * the tile have spans of their own, and columns are kept modulo 256 until what is beyond is cut off.
 */

/* Is the library built for size, and for a core that divides? Then all go the way of any triangle. */
#define ANY_WAY_ONLY (GLINT_SMALL && GLINT_DIVIDES)

/*
 * A corner as one word, 2^16 y + 2^15 + x in sixteenths of a pixel, 15 more than from the centre of the tile's first
 * pixel: the whole part of y is then the first row of centres below the corner or at it, and that of x the first
 * column. The 2^15 keeps an x left of the tile from borrowing from y.
 */
typedef int32_t corner_word;

#define TO_CENTER 15
#define X_BIAS 0x8000

static inline corner_word place_of(const glint_window *window, const glint_vertex *v) {
    const uint32_t word = (uint32_t)(uint16_t)v->x | (uint32_t)(uint16_t)v->y << 16;
    return (int32_t)((word ^ X_BIAS) - window->origin);
}

static inline int32_t first_row(corner_word p) {
    return glint_shift_right(p, 20);
}

void glint_window_begin(glint_window *window, int x, int y, int width, int height) {
    window->left = 16 * x + 8;
    window->top = 16 * y + 8;
    window->width = width;
    window->height = height;
    if (ANY_WAY_ONLY)
        return;
    const uint32_t rows = 0x80000000u >> glint_leading_zeros((uint32_t)height); /* no more, a power of two */
    const uint32_t columns = 0x80000000u >> glint_leading_zeros((uint32_t)width);
    window->origin = ((uint32_t)(window->top - TO_CENTER) << 16) + (uint32_t)(window->left - TO_CENTER);
    window->beyond = ~((16 * rows - 1) << 16 | X_BIAS | (16 * columns - 1));
}

/* A triangle's corners, counter-clockwise. */
typedef struct corners {
    corner_word a, b, c;
} corners;

/* Where a triangle leaves its tile; where it keeps to the tile's columns, any bits but the last three. */
#define CUT 1
#define CUT_LEFT 2
#define CUT_RIGHT 4

/* By how many columns a short triangle may lie left of a tile, and right of the largest: x takes 11 bits from there. */
#define AROUND 32
#define FAR 0x7800

/* Finds what cuts a triangle that leaves its tile's columns. @return 0 where it goes too far */
static inline uint32_t find_cut(const corners *p, const glint_window *window) {
    const int32_t around = 16 * AROUND, right = X_BIAS + 16 * window->width + TO_CENTER;
    uint32_t cut = CUT;
    if (((p->a + around) | (p->b + around) | (p->c + around)) & FAR)
        return 0;
    if (!(p->a & p->b & p->c & X_BIAS))
        cut |= CUT_LEFT;
    if (((right - p->a) | (right - p->b) | (right - p->c)) & X_BIAS)
        cut |= CUT_RIGHT;
    return cut;
}

/* Names the top corner `a`. */
static inline void turn_to_top(corners *p) {
    const corner_word a = p->a;
    if (p->b < a && p->b < p->c)
        p->a = p->b, p->b = p->c, p->c = a;
    else if (p->c < a)
        p->a = p->c, p->c = p->b, p->b = a;
}

/* A side on its way down: where it crosses a row, Q20, and how that changes. */
typedef struct falling_side {
    int32_t x, slope;
} falling_side;

#if GLINT_DIVIDES
#define slope_of glint_slope
#else
static GLINT_NOINLINE int32_t slope_of(int32_t dx, int32_t dy) {
    return glint_slope(dx, dy);
}
#endif

/* Q20: added to a place's x, this makes its whole part the column at or right of it. */
#define ORIGIN (INT32_MIN + GLINT_EDGE_CEILING - (TO_CENTER << 16))

static inline falling_side begin_side(corner_word upper, corner_word lower) {
    const int32_t y = glint_shift_right(upper, 16), slope = slope_of(lower - upper, glint_shift_right(lower, 16) - y);
    const int32_t x = glint_add_wrap(glint_shift_left(upper, 16), glint_edge_start(slope, ~y & 15));
    return (falling_side){glint_add_wrap(x, ORIGIN), slope};
}

/* Walks both sides down some rows. @return the span of the row below */
static inline uint8_t *walk_sides(uint8_t *span, int32_t rows, falling_side *left, falling_side *right) {
    uint8_t *const end = span + (int32_t)sizeof(glint_span) * rows;
    while (span != end) {
        span[offsetof(glint_span, right)] = (uint8_t)(right->x >> 20);
        span[offsetof(glint_span, left)] = (uint8_t)(left->x >> 20);
        span += sizeof(glint_span);
        GLINT_OPAQUE(span);
        left->x = glint_add_wrap(left->x, left->slope);
        right->x = glint_add_wrap(right->x, right->slope);
    }
    return span;
}

/* Finds a triangle's spans, down its left and its right side to these rows; `a` is its top corner. */
static inline void find_spans(glint_part *part, const corners *p, int32_t left_end, int32_t right_end) {
    const int32_t top = first_row(p->a), left_rows = left_end - top, right_rows = right_end - top;
    uint8_t *span = (uint8_t *)part + offsetof(glint_part, spans) + (int32_t)sizeof(glint_span) * top;
    falling_side left = {0, 0}, right = {0, 0};
    if (left_rows)
        left = begin_side(p->a, p->b);
    if (right_rows)
        right = begin_side(p->a, p->c);
    if (left_rows < right_rows) {
        span = walk_sides(span, left_rows, &left, &right);
        left = begin_side(p->b, p->c);
        walk_sides(span, right_rows - left_rows, &left, &right);
    } else {
        span = walk_sides(span, right_rows, &left, &right);
        if (left_rows == right_rows)
            return;
        right = begin_side(p->c, p->b);
        walk_sides(span, left_rows - right_rows, &left, &right);
    }
}

/* Cuts off what of the spans lies beyond the tile's columns. @return 0 when no pixels are left */
static GLINT_NOINLINE int cut_columns(glint_part *part, uint32_t cut) {
    const uint8_t width = (uint8_t)part->window.width;
    glint_span *const first = part->spans + part->top, *const end = part->spans + part->bottom;
    if (cut & CUT_LEFT) {
        glint_span *s = first;
        do {
            if (s->left >= 128) { /* left of the tile */
                s->left = 0;
                if (s->right >= 128)
                    s->right = 0;
            }
            s++;
            GLINT_OPAQUE(s);
        } while (s != end);
    }
    if (cut & CUT_RIGHT) {
        glint_span *s = first;
        do {
            if (s->right > width) {
                s->right = width;
                if (s->left > width)
                    s->left = width;
            }
            s++;
            GLINT_OPAQUE(s);
        } while (s != end);
    }
    return has_pixels(part);
}

int glint_raster(glint_part *part, const glint_vertex *const v[3]) {
    const glint_window *window = &part->window;
    corners p = {place_of(window, v[0]), place_of(window, v[1]), place_of(window, v[2])};
    if (ANY_WAY_ONLY)
        return find_any(part, v);
    uint32_t cut = (uint32_t)(p.a | p.b | p.c) & window->beyond;
    if (cut << 16) {
        cut = find_cut(&p, window);
        if (!cut)
            return find_any(part, v);
    }
    turn_to_top(&p);
    int32_t top = first_row(p.a), left_end = first_row(p.b), right_end = first_row(p.c);
    int32_t bottom = glint_most(left_end, right_end);
    if ((uint32_t)(bottom - top - 1) >= GLINT_SHORT_ROWS)
        return find_any(part, v);
    if (cut) {
        top = glint_most(top, 0);
        left_end = glint_least(left_end, window->height);
        right_end = glint_least(right_end, window->height);
        bottom = glint_least(bottom, window->height);
        if (top >= bottom)
            return 0;
    }
    part->top = (uint32_t)top;
    part->bottom = (uint32_t)bottom;
    find_spans(part, &p, left_end, right_end);
    return cut & (CUT_LEFT | CUT_RIGHT) ? cut_columns(part, cut) : has_pixels(part);
}
