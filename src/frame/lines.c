/* SPDX-License-Identifier: MIT */
/* Lines of a finished tile: one pixel in each column, or in each row, where nothing nearer is. */
#include "../pixel/format.h"
#include "frame.h"

/* 1/w of a line's end over that of the frame's nearest, Q31: what is nearer by more than 2^14 counts as that. */
#define LARGEST_DEPTH ((int64_t)1 << 45)

/* What a tile's lines are drawn with: the frame's nearest w as mantissa 2^shift, nearer by the width of two pixels. */
typedef struct line_target {
    const glint_tile *tile;
    uint32_t nearest; /* 31 bits */
    int32_t nearest_shift;
} line_target;

/* A line over its longer axis u: v is the other one. */
typedef struct line_walk {
    int32_t u0, v0, du, dv; /* 28.4; du is not below 0 */
    int64_t depth, slope;   /* Q31 at u0; change over a sixteenth, Q47 */
    int is_steep;
} line_walk;

/* Of parallel rays ends keep w in place of 1/w. */
static int64_t depth_of_parallel(const glint_frame *frame, const glint_segment *segment, int i) {
    const int up = segment->exponent[i] - 62;
    const int64_t kept = segment->inverse_w[i], w = up > 0 ? kept << up : kept >> -up;
    return frame->scene->camera.projection->depth_at(frame->view, w - 2 * frame->view->nearest / GLINT_GUARD_BAND);
}

static int64_t depth_of_end(const line_target *target, const glint_segment *segment, int i) {
    if (target->tile->frame->view->is_parallel)
        return depth_of_parallel(target->tile->frame, segment, i);
    const int down = segment->exponent[i] - 31 - target->nearest_shift;
    const uint64_t product = glint_product_unsigned(target->nearest, segment->inverse_w[i]); /* 2^61 to 2^63 */
    const int64_t depth = (int64_t)(down < 64 ? product >> glint_most(down, 16) : 0);
    return depth < LARGEST_DEPTH ? depth : LARGEST_DEPTH;
}

static void begin_line(const line_target *target, const glint_segment *segment, line_walk *walk) {
    const int32_t x = segment->x[1] - segment->x[0], y = segment->y[1] - segment->y[0];
    walk->is_steep = (y < 0 ? -y : y) > (x < 0 ? -x : x);
    const int16_t *const u = walk->is_steep ? segment->y : segment->x, *const v =
                                                                           walk->is_steep ? segment->x : segment->y;
    const int first = u[1] < u[0], last = 1 - first;
    walk->u0 = u[first];
    walk->v0 = v[first];
    walk->du = u[last] - u[first];
    walk->dv = v[last] - v[first];
    walk->depth = depth_of_end(target, segment, first);
    walk->slope = walk->du ? (depth_of_end(target, segment, last) - walk->depth) * (1 << 16) / walk->du : 0;
}

/* Draws a pixel of the tile, counted from its first one on the screen, if it is nearer than what is there. */
static void draw_pixel(const line_target *target, int32_t x, int32_t y, int64_t depth, const int32_t colour[1][3]) {
    const glint_frame *const frame = target->tile->frame;
    const glint_workspace *const workspace = target->tile->workspace;
    const uint32_t column = (uint32_t)x & (frame->config.tile_width - 1u),
                   row = (uint32_t)y & (frame->config.tile_height - 1u);
    const uint32_t offset = (row << frame->tile_shift_x) + column;
    const int64_t step = glint_shift_right64(depth, 15);
    const uint16_t here = (uint16_t)(step < 0 ? 1 : step < 0xffff ? step + 1 : 0xffff);
    if (here <= workspace->depth[offset])
        return;
    workspace->depth[offset] = here;
    const glint_list_pixel pixel = {offset, {colour[0][0], colour[0][1], colour[0][2]}};
    frame->config.format->store_list(workspace->pixels, frame->tile_shift_x, &pixel, sizeof pixel, 1);
}

/* Draws columns, or rows, from `first` to before `end`: pixels whose other number is from `least` to before `most`. */
static void walk_along(const line_target *target, const line_walk *walk, const glint_range *range,
                       const int32_t colour[1][3]) {
    const int32_t width = glint_most(walk->du, 1), whole = 16 * width;
    int32_t v = GLINT_GUARD_BAND;
    for (int32_t u = range->left; u < range->right; u++) {
        const int32_t along = glint_most(glint_least(16 * u + 8 - walk->u0, walk->du), 0);
        const int32_t there = walk->v0 * width + along * walk->dv; /* v there times width: below 2^30 */
        if (u == range->left)
            v = (there + 1024 * whole) / whole - 1024;
        else /* dv is at most du */
            v += there >= (v + 1) * whole ? 1 : there < v * whole ? -1 : 0;
        if (v >= range->top && v < range->bottom)
            draw_pixel(target, walk->is_steep ? v : u, walk->is_steep ? u : v,
                       walk->depth + glint_shift_right64(walk->slope * along, 16), colour);
    }
}

/* Of a tile from `first` on, `size` wide, what lies between two places in sixteenths. */
static void cut_range(int32_t first, int32_t size, int32_t a, int32_t b, int32_t *from, int32_t *to) {
    *from = glint_most(first, glint_shift_right(glint_least(a, b), 4));
    *to = glint_least(first + size, glint_shift_right(glint_most(a, b), 4) + 1);
}

static void draw_segment(const line_target *target, const glint_segment *segment) {
    const glint_tile *const tile = target->tile;
    const glint_colour *const c = segment->colour;
    glint_range range;
    line_walk walk;
    int32_t colour[1][3];
    cut_range(tile->x, tile->width, segment->x[0], segment->x[1], &range.left, &range.right);
    cut_range(tile->y, tile->height, segment->y[0], segment->y[1], &range.top, &range.bottom);
    if (range.left >= range.right || range.top >= range.bottom)
        return;
    begin_line(target, segment, &walk);
    if (walk.is_steep)
        range = (glint_range){range.top, range.left, range.bottom, range.right};
    const uint32_t shown[3] = {(uint32_t)c->r << 7, (uint32_t)c->g << 7, (uint32_t)c->b << 7};
    glint_channels_of(shown, colour[0]);
    glint_finish_colours(&tile->frame->config, colour, 1);
    walk_along(target, &walk, &range, (const int32_t(*)[3])colour);
}

glint_status glint_lines_draw(const glint_tile *tile, const glint_segment *segments, uint32_t count) {
    if (!tile || !tile->frame || !tile->workspace || (count && !segments))
        return GLINT_ERROR_NULL;
    const glint_view *const view = tile->frame->view;
    /* below 2^55; of parallel rays, whose w may have 54 bits, none is asked for */
    const int64_t nearest = view->is_parallel ? 1 : view->nearest + view->nearest * (1 << 14) / view->focal;
    const int32_t shift = (int32_t)glint_bits64((uint64_t)nearest) - 31;
    const uint32_t mantissa = (uint32_t)(shift > 0 ? nearest >> shift : nearest << -shift);
    const line_target target = {tile, mantissa, shift};
    for (uint32_t i = 0; i < count; i++)
        if (segments[i].colour)
            draw_segment(&target, &segments[i]);
    return GLINT_OK;
}
