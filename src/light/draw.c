/* SPDX-License-Identifier: MIT */
/*
 * Draws triangles of one colour, and triangles whose colours are interpolated between corners.
 *
 * Colours over w are linear on the screen. Where the colours themselves are close to linear, a loop of the pixel format
 * steps them in two words; elsewhere they are divided by 1/w at each pixel.
 */
#include "../math/division.h"
#include "../pixel/pixel.h"
#include "../raster/small.h"
#include "evaluation.h"
#include "wear.h"

/* ---- One colour ---- */

void glint_draw_facet(glint_row_walk *walk) {
    const glint_format *format = walk->frame->config.format;
    walk->lanes[0] = glint_lanes_of(walk->draw->facets[walk->triangle.index]);
    walk->packed = glint_pack_lanes(walk->lanes[0], format->channel[0], glint_green_bits(format));
    format->flat(walk);
}

/* ---- Colours at corners, over w ---- */

/*
 * Colours count as linear on the screen if they deviate from the plane through their corners by at most this: half a
 * level. The plane that is drawn lies between both, which leaves about half of the deviation.
 */
#define MOST_DEVIATION (1u << 14)

/* Returns a channel, 1 = GLINT_COLOUR_ONE, clamped to 0 and 1, off by at most 4 steps, given the channel over w; w is
 * 2^-31 reciprocal 2^zeros. */
static inline int16_t divide_channel(int32_t over_w, uint32_t zeros, int32_t reciprocal) {
    const int32_t cut = glint_least(glint_most(over_w, 0), glint_shift_right(INT32_MAX, zeros));
    const int32_t colour = glint_shift_right(glint_shift_right(glint_shift_left(cut, zeros), 16) * reciprocal, 15);
    return (int16_t)glint_least(colour, GLINT_COLOUR_ONE);
}

/* Divides the three channels of a colour over w by 1/w, the fourth number, which is clamped to one step or more. */
static GLINT_NOINLINE void divide_colour(const int32_t over_w[4], int16_t colour[3]) {
    const uint32_t w = (uint32_t)glint_most(over_w[3], 1), zeros = glint_leading_zeros(w);
    const int32_t reciprocal = glint_reciprocal16(w << zeros >> 16);
    for (int c = 0; c < 3; c++)
        colour[c] = divide_channel(over_w[c], zeros, reciprocal);
}

void glint_divide_at(const glint_row_walk *walk, int32_t row, int32_t column, int16_t colour[3]) {
    const int32_t x = walk->part->x + column, y = walk->part->y + row;
    const int32_t over_w[4] = {glint_plane_at(&walk->channel[0], x, y), glint_plane_at(&walk->channel[1], x, y),
                               glint_plane_at(&walk->channel[2], x, y), glint_plane_at(&walk->w, x, y)};
    divide_colour(over_w, colour);
}

/* Draws a span whose colours are divided at each pixel. */
static GLINT_HOT GLINT_NOINLINE void draw_divided_pixels(glint_row_walk *walk, int32_t row, int32_t left,
                                                         int32_t right) {
    const glint_config *config = &walk->frame->config;
    const glint_plane *const c = walk->channel;
    const int32_t x = walk->part->x + left, y = walk->part->y + row;
    int32_t over_w[4] = {glint_plane_at(&c[0], x, y), glint_plane_at(&c[1], x, y), glint_plane_at(&c[2], x, y),
                         glint_plane_at(&walk->w, x, y)};
    uint32_t z = glint_z_at(walk, row, left), pixel = ((uint32_t)row << walk->shift) + (uint32_t)left;
    for (const uint32_t end = pixel + (uint32_t)(right - left); pixel < end; pixel++, z += (uint32_t)walk->z.dx) {
        if (glint_is_nearest((uint8_t *)&walk->depth[pixel], (uint32_t)glint_most((int32_t)z, GLINT_DEPTH_BIAS))) {
            int16_t colour[3];
            divide_colour(over_w, colour);
            if (config->gamma)
                glint_finish_lane_levels(config, colour, colour);
            config->format->put(walk, pixel, glint_lanes_of(colour));
        }
        for (int i = 0; i < 3; i++)
            over_w[i] = glint_add_wrap(over_w[i], c[i].dx);
        over_w[3] = glint_add_wrap(over_w[3], walk->w.dx);
    }
}

/* Return what draws spans of colours that are linear on the screen, and of those that are divided. */
static inline glint_draw_span *smooth_of(const glint_row_walk *walk) {
    const glint_texture *texture = walk->draw->texture;
    return texture ? texture->type->stage->smooth : walk->frame->config.format->smooth;
}
static inline glint_draw_span *divided_of(const glint_row_walk *walk) {
    const glint_texture *texture = walk->draw->texture;
    return texture ? texture->type->stage->divided : draw_divided_pixels;
}

/* Returns the larger of a number and the magnitude of another. */
static inline int32_t most_apart(int32_t most, int32_t difference) {
    const int32_t magnitude = difference < 0 ? -difference : difference;
    return magnitude > most ? magnitude : most;
}

/* Returns the largest difference of two colours from the first one, in any channel. */
static inline uint32_t find_apart(const int16_t *a, const int16_t *b, const int16_t *c) {
    const int32_t red = most_apart(most_apart(0, b[0] - a[0]), c[0] - a[0]),
                  green = most_apart(most_apart(red, b[1] - a[1]), c[1] - a[1]);
    return (uint32_t)most_apart(most_apart(green, b[2] - a[2]), c[2] - a[2]);
}

/*
 * Binary logarithms of a chunk's length in pixels: colours are divided at the two nodes at its ends, and interpolated
 * between. Short chunks are aligned to tiles, whose width is a multiple of theirs. Long ones are aligned to the screen,
 * and tried if a triangle is large.
 */
#define CHUNK_SHIFT 3
#define LONG_CHUNK_SHIFT 5
#define LONG_CHUNK_REACH 1024 /* sixteenths of a pixel */

/* A pixel whose colour has been divided, with its 1/w. */
typedef struct colour_node {
    int16_t colour[3];
    int32_t w;
} colour_node;

static void find_node(const glint_row_walk *walk, int32_t row, int32_t column, colour_node *to) {
    const int32_t x = walk->part->x + column, y = walk->part->y + row;
    const int32_t over_w[4] = {glint_plane_at(&walk->channel[0], x, y), glint_plane_at(&walk->channel[1], x, y),
                               glint_plane_at(&walk->channel[2], x, y), glint_plane_at(&walk->w, x, y)};
    to->w = over_w[3];
    divide_colour(over_w, to->colour);
}

/* Returns whether colours may be interpolated between two nodes: they then deviate by at most a quarter of a level, or
 * an eighth in formats of many levels. They may not if a channel is clamped at 0 or 1. */
static int is_close(const glint_row_walk *walk, const colour_node *a, const colour_node *b) {
    const unsigned bits = glint_green_bits(walk->frame->config.format);
    const uint32_t least = (uint32_t)glint_least(a->w, b->w) >> 15, most = (uint32_t)glint_most(a->w, b->w) >> 15;
    const uint32_t apart = find_apart(a->colour, b->colour, b->colour);
    if (a->w <= 0 || b->w <= 0)
        return 0;
    for (int c = 0; c < 3; c++)
        if ((uint32_t)(a->colour[c] - 1) >= GLINT_COLOUR_ONE - 1 ||
            (uint32_t)(b->colour[c] - 1) >= GLINT_COLOUR_ONE - 1)
            return 0;
    return apart * (most - least + 1) <= (MOST_DEVIATION >> (bits > 6 ? bits : 5)) * least;
}

/* Draws pixels of a chunk with colours interpolated between its nodes. */
static void draw_between(glint_row_walk *walk, const colour_node *a, const colour_node *b, int32_t column,
                         unsigned shift, int32_t row, int32_t left, int32_t right) {
    const uint32_t x = (uint32_t)column;
    int32_t step[3];
    for (int c = 0; c < 3; c++) /* 2^-16 */
        step[c] = glint_shift_right(2 * (b->colour[c] - a->colour[c]) + (1 << shift >> 1), shift);
    glint_lanes *const to = walk->lanes;
    to[0] = glint_lanes_of(a->colour);
    to[1].red_blue = ((uint32_t)step[2] << 16) + (uint32_t)step[0];
    to[1].green = (uint32_t)(b->colour[1] - a->colour[1]) << (17 - shift);
    to[2] = (glint_lanes){0, 0};
    to[0].red_blue -= to[1].red_blue * x;
    to[0].green -= to[1].green * x;
    smooth_of(walk)(walk, row, left, right);
}

/* In chunks of this many visible columns, two nodes cost less than dividing each pixel. */
#define CHUNK_LEAST 4

/* Draws a span in short chunks. */
static GLINT_HOT void draw_chunks(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    int32_t column = glint_shift_right(left, CHUNK_SHIFT) * (1 << CHUNK_SHIFT), known = -1;
    colour_node a, b = {{0, 0, 0}, 0};
    for (; left < right; column += 1 << CHUNK_SHIFT) {
        const int32_t next = column + (1 << CHUNK_SHIFT), end = glint_least(next, right);
        int is_linear = end - left >= CHUNK_LEAST;
        if (is_linear) {
            if (column == known)
                a = b;
            else
                find_node(walk, row, column, &a);
            find_node(walk, row, known = next, &b);
            is_linear = is_close(walk, &a, &b);
        }
        if (is_linear)
            draw_between(walk, &a, &b, column, CHUNK_SHIFT, row, left, end);
        else
            divided_of(walk)(walk, row, left, end);
        left = end;
    }
}

/* Draws a span in long chunks, or in short ones where colours deviate too much. */
static void draw_long_chunks(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    const int32_t size = 1 << LONG_CHUNK_SHIFT, x = glint_shift_right(walk->part->window.left, 4);
    colour_node a, b;
    while (left < right) {
        const int32_t column = ((x + left) & -size) - x, end = glint_least(column + size, right);
        find_node(walk, row, column, &a);
        find_node(walk, row, column + size, &b);
        if (is_close(walk, &a, &b))
            draw_between(walk, &a, &b, column, LONG_CHUNK_SHIFT, row, left, end);
        else
            draw_chunks(walk, row, left, end);
        left = end;
    }
}

/* Returns the colour of a triangle's corner, on the side that is seen. */
static inline const int16_t *colour_at(const glint_row_walk *walk, uint32_t corner) {
    const glint_triangle *t = &walk->triangle;
    return t->back ? t->extra[corner] : t->corners[corner]->attribute;
}

/* Sets the planes of 1/w, scaled so that the largest is from 2^30 to 2^31, and of channels times this times 2^-16; and
 * chooses what draws spans. 1/w is limited to the largest depth, which lowers it by at most 2^-15: so rounding keeps
 * the plane below 2^31. That of parallel rays, which is above, becomes the same at all corners. */
static GLINT_NOINLINE void begin_divided(glint_row_walk *walk) {
    const glint_config *config = &walk->frame->config;
    const glint_vertex *const *v = walk->triangle.corners;
    const int16_t *const colour[3] = {colour_at(walk, 0), colour_at(walk, 1), colour_at(walk, 2)};
    const glint_gradients *g = &walk->part->gradients;
    const unsigned up = glint_find_room(v);
    int32_t w[3];
    if (walk->has_slopes)
        glint_setup(walk->part, &walk->triangle);
    for (int i = 0; i < 3; i++)
        w[i] = glint_least(glint_shift_left(v[i]->inverse_w, up), GLINT_DEPTH_TOP);
    glint_plane_begin(&walk->w, g, w[0], w[1], w[2]);
    uint32_t steps = glint_magnitude_bits(walk->w.dx);
    for (int c = 0; c < 3; c++) {
        glint_plane_begin(&walk->channel[c], g, glint_product_high(colour[0][c] * (1 << 16), w[0]),
                          glint_product_high(colour[1][c] * (1 << 16), w[1]),
                          glint_product_high(colour[2][c] * (1 << 16), w[2]));
        steps |= glint_magnitude_bits(walk->channel[c].dx);
    }
    /* chunks do not serve if planes are so steep that they may wrap within one */
    if (config->gamma || config->format->is_dithered || walk->is_deep || steps >> (31 - CHUNK_SHIFT))
        walk->draw_span = divided_of(walk);
    else
        walk->draw_span =
            g->reach < LONG_CHUNK_REACH || steps >> (31 - LONG_CHUNK_SHIFT) ? draw_chunks : draw_long_chunks;
}

/* ---- Colours at corners, linear on the screen ---- */

/* A channel's change per pixel in x and y, and its value at a pixel: Q29. */
typedef struct lane {
    int32_t dx, dy, start;
} lane;

/* Returns the lane of a channel that is a, b, c at the corners of any triangle, with the value at its anchor. */
static lane lane_of_gradients(const glint_gradients *g, int32_t a, int32_t b, int32_t c) {
    glint_plane p;
    glint_plane_begin(&p, g, a * (1 << 14), b * (1 << 14), c * (1 << 14));
    return (lane){p.dx, p.dy, p.start};
}

/* Returns the lane of a small triangle, given the channel at its first corner, and the differences at the others. The
 * value is that at the first pixel of the slopes, modulo 2^32, as a sliver's may wrap there. */
static inline lane lane_of_slopes(const glint_slopes *s, int32_t a, int32_t d1, int32_t d2) {
    return (lane){(int32_t)glint_weigh(d1, s->x1, d2, s->x2), (int32_t)glint_weigh(d1, s->y1, d2, s->y2),
                  glint_add_wrap(a * (1 << 14), (int32_t)glint_weigh(d1, s->start1, d2, s->start2))};
}

/* Rounds a channel from Q29 to Q16. */
static inline uint32_t round_to_q16(int32_t channel) {
    return (uint32_t)glint_shift_right(glint_add_wrap(channel, 1 << 12), 13);
}

/* Sets the word of red and blue from the tile's first pixel on, given lanes at its pixel (x, y). */
static inline void set_red_blue(glint_lanes *to, const lane *red, const lane *blue, uint32_t x, uint32_t y) {
    const uint32_t dx = (round_to_q16(blue->dx) << 16) + round_to_q16(red->dx),
                   dy = (round_to_q16(blue->dy) << 16) + round_to_q16(red->dy);
    to[0].red_blue = (round_to_q16(blue->start) << 16) + round_to_q16(red->start) - dx * x - dy * y;
    to[1].red_blue = dx;
    to[2].red_blue = dy;
}

/* Sets the word of green likewise. */
static inline void set_green(glint_lanes *to, const lane *green, uint32_t x, uint32_t y) {
    const uint32_t dx = (uint32_t)green->dx << 3, dy = (uint32_t)green->dy << 3;
    to[0].green = ((uint32_t)green->start << 3) - dx * x - dy * y;
    to[1].green = dx;
    to[2].green = dy;
}

/* Sets the lanes of a large triangle. */
static GLINT_NOINLINE void begin_gradients(glint_row_walk *walk) {
    const int16_t *a = colour_at(walk, 0), *b = colour_at(walk, 1), *c = colour_at(walk, 2);
    const glint_gradients *g = &walk->part->gradients;
    const uint32_t x = 0u - (uint32_t)walk->part->x, y = 0u - (uint32_t)walk->part->y;
    const lane red = lane_of_gradients(g, a[0], b[0], c[0]), green = lane_of_gradients(g, a[1], b[1], c[1]),
               blue = lane_of_gradients(g, a[2], b[2], c[2]);
    set_red_blue(walk->lanes, &red, &blue, x, y);
    set_green(walk->lanes, &green, x, y);
}

/*
 * Moves the planes of colours by their mean deviation. A value that is linear over w deviates from the plane through
 * its corners, on the average over the triangle, by d1 (2 w1 - w2) / 12 w0 + d2 (2 w2 - w1) / 12 w0, where d1 and d2
 * are the differences of the value from the first corner, w1 and w2 those of 1/w, and w0 is 1/w there. As the slopes'
 * weights of d1 and d2 at the start are Q14, planes are off by up to 2^-13 of a difference.
 */
static inline void add_curvature(glint_slopes *s, int32_t wa, int32_t to_b, int32_t to_c) {
    const unsigned zeros = glint_leading_zeros((uint32_t)wa | 1);
    const int32_t reciprocal = glint_reciprocal16((uint32_t)wa << zeros >> 16); /* 2^31 over w0 of 16 bits */
    const int32_t twelfth = glint_shift_right(reciprocal * 5461, 16);
    /* both have up to 30 bits, as w1 and w2 are below 16 w0 */
    const int32_t w1 = glint_shift_left(glint_shift_right(to_b, 5), zeros - 1),
                  w2 = glint_shift_left(glint_shift_right(to_c, 5), zeros - 1);
    s->start1 = glint_add_wrap(s->start1, glint_shift_right(glint_shift_right(2 * w1 - w2, 14) * twelfth, 13));
    s->start2 = glint_add_wrap(s->start2, glint_shift_right(glint_shift_right(2 * w2 - w1, 14) * twelfth, 13));
}

/*
 * Returns whether rounding keeps within half of the margin that glint_finish_corner has added to levels. Slopes of red
 * and blue are rounded by up to half of 2^-16 a pixel, in x and in y; weights by up to half of 2^-14 of the corners'
 * difference.
 */
static int has_room(const glint_format *format, const glint_vertex *const v[3], uint32_t most_apart) {
    const int32_t x = glint_most_of(v[0]->x, v[1]->x, v[2]->x) - glint_least_of(v[0]->x, v[1]->x, v[2]->x);
    const int32_t y = glint_most_of(v[0]->y, v[1]->y, v[2]->y) - glint_least_of(v[0]->y, v[1]->y, v[2]->y);
    const int32_t span = glint_shift_right(x + y, 4) + 1, level = 1 << (16 - glint_green_bits(format));
    const int32_t room =
        format->is_dithered ? level / (2 * glint_dither_margin(glint_green_bits(format))) : level / 4; /* 2^-16 */
    const int32_t apart = (int32_t)glint_least((int32_t)most_apart, INT16_MAX);
    return glint_shift_right(apart * span, 14) + (format->channel[0] ? span / 2 : 0) <= room;
}

/* ---- Colours at corners ---- */

/* The change of 1/w over a triangle, and the largest product of this and a difference of colours for which colours
 * count as linear on the screen. */
typedef struct colour_bend {
    uint32_t change, level;
} colour_bend;

/* Finds the bend, given 1/w at a corner, and its differences at the others. */
static inline colour_bend find_bend(const glint_row_walk *walk, int32_t w, int32_t to_b, int32_t to_c) {
    const int32_t least = glint_least_of(0, to_b, to_c), most = glint_most_of(0, to_b, to_c);
    return (colour_bend){((uint32_t)(most - least) >> 15) + 1,
                         (4 * MOST_DEVIATION >> walk->colour_bits) * ((uint32_t)(w + least) >> 15)};
}

/* Returns an upper bound of find_apart, less than twice as large. */
static inline uint32_t bound_apart(const int16_t *a, const int16_t *b, const int16_t *c) {
    return glint_magnitude_bits(b[0] - a[0]) | glint_magnitude_bits(b[1] - a[1]) | glint_magnitude_bits(b[2] - a[2]) |
           glint_magnitude_bits(c[0] - a[0]) | glint_magnitude_bits(c[1] - a[1]) | glint_magnitude_bits(c[2] - a[2]);
}

/* Returns whether the colours of a triangle count as linear on the screen, given their largest difference. `off` is 1
 * if planes are moved by add_curvature, and 2 if they go through the corners, which deviates by twice as much. */
static GLINT_NOINLINE int are_linear(const glint_row_walk *walk, uint32_t off, uint32_t apart) {
    const glint_vertex *const *v = walk->triangle.corners;
    const int32_t w = v[0]->inverse_w;
    const colour_bend bend = find_bend(walk, w, v[1]->inverse_w - w, v[2]->inverse_w - w);
    return walk->colour_bits && !walk->is_deep && apart * bend.change <= bend.level / off;
}

/* Returns whether the colours of a triangle may be linear on the screen, and stepped in two words. */
static GLINT_NOINLINE int are_linear_lanes(const glint_row_walk *walk, uint32_t off) {
    const uint32_t apart = find_apart(colour_at(walk, 0), colour_at(walk, 1), colour_at(walk, 2));
    return are_linear(walk, off, apart) && has_room(walk->frame->config.format, walk->triangle.corners, apart);
}

/* Sets the colours of a large triangle. */
static void begin_large_colours(glint_row_walk *walk) {
    if (!are_linear_lanes(walk, 2)) {
        begin_divided(walk);
        return;
    }
    begin_gradients(walk);
    walk->draw_span = smooth_of(walk);
}

/* Returns whether the colours of a small triangle may be linear on the screen, given 1/w at a corner and its
 * differences at the others. */
static inline int are_close(const glint_row_walk *walk, int32_t w, int32_t to_b, int32_t to_c, const int16_t *a,
                            const int16_t *b, const int16_t *c) {
    if (walk->is_exacting)
        return are_linear_lanes(walk, 1);
    const colour_bend bend = find_bend(walk, w, to_b, to_c);
    return bound_apart(a, b, c) * bend.change <= bend.level || find_apart(a, b, c) * bend.change <= bend.level;
}

int glint_bend_slopes(const glint_row_walk *walk, glint_slopes *slopes, const int16_t *a, const int16_t *b,
                      const int16_t *c) {
    const glint_vertex *const *v = walk->from_top;
    const int32_t wa = v[0]->inverse_w;
    if (!are_linear(walk, 1, find_apart(a, b, c)))
        return 0;
    add_curvature(slopes, wa, v[1]->inverse_w - wa, v[2]->inverse_w - wa);
    return 1;
}

/* Sets the colours of a small triangle that has slopes. @return 0 if they are divided at pixels */
static GLINT_NOINLINE int begin_small_colours(glint_row_walk *walk) {
    const glint_vertex *const *v = walk->from_top;
    const int16_t *a = v[0]->attribute, *b = v[1]->attribute, *c = v[2]->attribute;
    const int32_t wa = v[0]->inverse_w, w1 = v[1]->inverse_w - wa, w2 = v[2]->inverse_w - wa;
    const uint32_t bend = glint_magnitude_bits(w1) | glint_magnitude_bits(w2);
    if (walk->triangle.back) {
        const uint8_t *order = glint_corner_order(walk->corners.top);
        a = walk->triangle.extra[order[0]], b = walk->triangle.extra[order[1]], c = walk->triangle.extra[order[2]];
    }
    const int is_bent = bend > (uint32_t)wa >> 6 || walk->is_exacting;
    if (is_bent && !are_close(walk, wa, w1, w2, a, b, c)) {
        begin_divided(walk);
        return 0;
    }
    glint_slopes s;
    glint_find_slopes(&walk->corners, &s);
    const uint32_t x = (uint32_t)s.column, y = (uint32_t)s.row;
    if (is_bent)
        add_curvature(&s, wa, w1, w2);
    const lane red = lane_of_slopes(&s, a[0], b[0] - a[0], c[0] - a[0]),
               blue = lane_of_slopes(&s, a[2], b[2] - a[2], c[2] - a[2]);
    set_red_blue(walk->lanes, &red, &blue, x, y);
    const lane green = lane_of_slopes(&s, a[1], b[1] - a[1], c[1] - a[1]);
    set_green(walk->lanes, &green, x, y);
    return 1;
}

void glint_begin_interpolated(glint_row_walk *walk) {
    if (!walk->has_slopes)
        begin_large_colours(walk);
    else if (begin_small_colours(walk))
        walk->draw_span = smooth_of(walk);
}

/* Sets depth and colours of a triangle, and draws its first span. */
static void begin_lit(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    glint_begin_depth(walk);
    begin_large_colours(walk);
    walk->draw_span(walk, row, left, right);
}

void glint_draw_lit(glint_row_walk *walk) {
    const glint_begun begun = glint_begin_triangle(walk);
    walk->draw_span = begin_lit;
    if (begun == GLINT_IS_SMALL && walk->has_slopes)
        walk->frame->config.format->smooth_rows(walk, begin_small_colours);
    else
        glint_walk_begun(walk, begun);
}
