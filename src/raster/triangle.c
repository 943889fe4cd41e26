/* SPDX-License-Identifier: MIT */
/* Walks the left and the right side of any triangle down the rows of a tile at once. */
#include "triangle.h"

#include "small.h"

/* ---- Tiles ---- */

void glint_window_begin(glint_window *window, int x, int y, int width, int height) {
    window->left = 16 * x + 8;
    window->top = 16 * y + 8;
    window->width = width;
    window->height = height;
    window->origin = ((uint32_t)(window->top - GLINT_TO_CENTER) << 16) + (uint32_t)(window->left - GLINT_TO_CENTER);
}

/* ---- Any triangle ---- */
/* An exact side on its way down is at the first column at or right of the side, and rest / divisor of a column
 * beyond. */
typedef struct exact_side {
    int32_t column, rest, step, step_rest, divisor;
} exact_side;

/* Computes floor(a / b), for b above 0. */
static int32_t floor_quotient(int32_t a, int32_t b, int32_t *rest) {
    int32_t quotient = a / b;
    *rest = a - quotient * b;
    if (*rest < 0) {
        quotient--;
        *rest += b;
    }
    return quotient;
}

/* Begins a side at row `row` of the tile. Corners lie less than 2^15 sixteenths apart and from the tile, so that the
 * numerator, which is dy times the column in sixteenths, has 31 bits. */
static GLINT_NOINLINE void begin_exact_side(exact_side *side, glint_corner_word upper, glint_corner_word lower,
                                            int32_t row) {
    const int32_t dx = glint_x_of(lower) - glint_x_of(upper), dy = glint_y_of(lower) - glint_y_of(upper);
    const int32_t x = glint_x_of(upper) - GLINT_X_BIAS - GLINT_TO_CENTER,
                  down = 16 * row + GLINT_TO_CENTER - glint_y_of(upper);
    side->divisor = 16 * dy;
    side->column = floor_quotient(x * dy + down * dx + side->divisor - 1, side->divisor, &side->rest);
    side->step = floor_quotient(dx, dy, &side->step_rest);
    side->step_rest *= 16;
}

static inline void step_exact_side(exact_side *side) {
    side->column += side->step;
    side->rest += side->step_rest;
    if (side->rest >= side->divisor) {
        side->rest -= side->divisor;
        side->column++;
    }
}

static GLINT_HOT GLINT_NOINLINE void walk_any(glint_row_walk *walk) {
    const glint_corners *const k = &walk->corners;
    const glint_corner_word a = k->a, b = k->b, c = k->c;
    const int32_t width = walk->part->window.width, left_end = glint_row_of(b), right_end = glint_row_of(c);
    const int32_t end = walk->rows.end;
    int32_t row = walk->rows.row;
    const int is_below_b = row >= left_end, is_below_c = row >= right_end;
    exact_side left, right;
    begin_exact_side(&left, is_below_b ? b : a, is_below_b ? c : b, row);
    begin_exact_side(&right, is_below_c ? c : a, is_below_c ? b : c, row);
    for (;;) {
        const int32_t from = glint_most(left.column, 0), to = glint_least(right.column, width);
        if (from < to)
            walk->draw_span(walk, row, from, to);
        if (++row == end)
            return;
        step_exact_side(&left);
        step_exact_side(&right);
        if (row == left_end)
            begin_exact_side(&left, b, c, row);
        if (row == right_end)
            begin_exact_side(&right, c, b, row);
    }
}

/* ---- Small triangles ---- */

static inline void draw_its_span(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    walk->draw_span(walk, row, left, right);
}

GLINT_HOT void glint_walk_small(glint_row_walk *walk) {
    glint_draw_rows(walk, glint_begin_rows(walk), draw_its_span);
}

GLINT_HOT int glint_find_visible_row(glint_row_walk *walk) {
    glint_row_state at = glint_begin_rows(walk);
    const int is_visible = glint_seek_visible(walk, &at);
    glint_keep_rows(walk, &at);
    return is_visible;
}

/* ---- Triangles ---- */

/* May slopes serve a triangle that is not small? */
static int is_long(const glint_row_walk *walk) {
    const glint_corners *const k = &walk->corners;
    const uint32_t to_b = (uint32_t)(glint_x_of(k->b) - glint_x_of(k->a) + GLINT_LONG_DX),
                   to_c = (uint32_t)(glint_x_of(k->c) - glint_x_of(k->a) + GLINT_LONG_DX);
    return walk->draw->fragments & GLINT_HAVE_LONG_SLOPES && to_b < 2 * GLINT_LONG_DX && to_c < 2 * GLINT_LONG_DX &&
           glint_most(glint_row_of(k->b), glint_row_of(k->c)) - glint_row_of(k->a) <= GLINT_LONG_ROWS;
}

/* Finds area, plane of 1/w and slopes of a triangle, where slopes serve it. */
static void begin_late_slopes(glint_row_walk *walk) {
    glint_begin_slopes(walk, walk->from_top);
    if (walk->has_slopes)
        glint_find_slopes(&walk->corners, &walk->slopes);
}

/* Begins the rows of a triangle, whose slopes are found once a row has a span. */
static glint_begun begin_rows(glint_row_walk *walk) {
    const glint_begun begun = glint_find_rows(walk, walk->from_top);
    walk->has_slopes = begun == GLINT_IS_SMALL || (begun == GLINT_IS_LARGE && is_long(walk)) ? GLINT_SLOPES_UNKNOWN : 0;
    if (begun == GLINT_IS_SMALL)
        glint_find_sides(walk);
    return begun;
}

glint_begun glint_begin_triangle(glint_row_walk *walk) {
    const glint_begun begun = GLINT_SMALL ? begin_rows(walk) : glint_begin_inline(walk, walk->from_top);
    if (GLINT_SMALL ? walk->has_slopes : begun == GLINT_IS_LARGE && is_long(walk))
        begin_late_slopes(walk);
    return begun;
}

void glint_walk_begun(glint_row_walk *walk, glint_begun begun) {
    if (begun == GLINT_IS_SMALL)
        glint_walk_small(walk);
    else if (begun == GLINT_IS_LARGE)
        walk_any(walk);
}

void glint_walk_triangle(glint_row_walk *walk) {
    glint_walk_begun(walk, begin_rows(walk));
}

/* ---- Depth ---- */

void glint_begin_depth(glint_row_walk *walk) {
    const glint_part *part = walk->part;
    if (walk->has_slopes == GLINT_SLOPES_UNKNOWN)
        begin_late_slopes(walk);
    if (walk->has_slopes)
        return;
    glint_setup(walk->part, &walk->triangle);
    walk->is_deep = (uint8_t)glint_is_deep(&walk->triangle);
    walk->z = part->depth;
    walk->z.start = glint_add_wrap(glint_plane_at(&part->depth, part->x, part->y), GLINT_DEPTH_BIAS);
}
