/* SPDX-License-Identifier: MIT */
/* Defines what all pixel formats share beyond their loops, and every format except those of 16 bits. */
#include "pixel.h"

/* ---- What formats share ---- */

/* Draws a span of one colour where rounding may take the plane of 1/w below the least depth, which then counts. */
static void draw_deep(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    uint32_t z = glint_z_at(walk, row, left), pixel = ((uint32_t)row << walk->shift) + (uint32_t)left;
    for (const uint32_t end = pixel + (uint32_t)(right - left); pixel < end; pixel++, z += (uint32_t)walk->z.dx)
        if (glint_is_nearest((uint8_t *)&walk->depth[pixel], (uint32_t)glint_most((int32_t)z, GLINT_DEPTH_BIAS)))
            walk->frame->config.format->put(walk, pixel, walk->lanes[0]);
}

static void begin_spans(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    glint_begin_depth(walk);
    walk->draw_span = walk->is_deep ? draw_deep : walk->frame->config.format->flat_span;
    walk->draw_span(walk, row, left, right);
}

void glint_walk_flat(glint_row_walk *walk, glint_begun begun) {
    walk->draw_span = begin_spans;
    glint_walk_begun(walk, begun);
}

void glint_draw_flat(glint_row_walk *walk) {
    glint_walk_flat(walk, glint_begin_triangle(walk));
}

void glint_draw_smooth_rows(glint_row_walk *walk, glint_begin_colours *begin) {
    if (!glint_find_visible_row(walk))
        return;
    if (begin(walk))
        walk->draw_span = walk->frame->config.format->smooth;
    glint_walk_small(walk);
}

/* ---- RGB888: a byte each of red, green and blue ---- */

static inline uint32_t pack_rgb888(const int32_t colour[3], uint32_t threshold) {
    return glint_level(colour[0], 8, threshold) << 16 | glint_level(colour[1], 8, threshold) << 8 |
           glint_level(colour[2], 8, threshold);
}

static inline void put_rgb888(const glint_target *target, uint32_t offset, uint32_t packed) {
    uint8_t *out = (uint8_t *)target->pixels + 3 * offset;
    out[0] = (uint8_t)(packed >> 16);
    out[1] = (uint8_t)(packed >> 8);
    out[2] = (uint8_t)packed;
}

GLINT_DEFINE_FORMAT(rgb888, 24, GLINT_ROW_EDGE, 8, 8, 8, pack_rgb888, put_rgb888, glint_fill_tile, GLINT_KEEPS_ANY,
                    GLINT_SPREAD_NONE, GLINT_SPREAD_NONE);

/* ---- RGB444: 4 bits each of red, green and blue, high bits first, two pixels in three bytes ---- */

static inline uint32_t pack_rgb444(const int32_t colour[3], uint32_t threshold) {
    return glint_level(colour[0], 4, threshold) << 8 | glint_level(colour[1], 4, threshold) << 4 |
           glint_level(colour[2], 4, threshold);
}

/* Returns one of 15 levels of a spread word's channel, whose 1 is `most`. The threshold is in 2^-20 of a level. */
static inline uint32_t level_of(uint32_t channel, uint32_t most, uint32_t threshold) {
    return glint_saturate((int32_t)(channel * (15 * (1u << 20) / most) + threshold), 4, 20);
}

static inline uint32_t pack_spread_rgb444(uint32_t word, uint32_t threshold) {
    const uint32_t clamped = glint_spread_clamp(word), at = threshold << 13;
    return level_of(clamped >> 10 & 0x3ff, 31 << 5, at) << 8 | level_of(clamped >> 21 & 0x3ff, 63 << 4, at) << 4 |
           level_of(clamped & 0x1ff, 31 << 4, at);
}

static inline void put_rgb444(const glint_target *target, uint32_t offset, uint32_t packed) {
    uint8_t *pair = (uint8_t *)target->pixels + 3 * (offset >> 1);
    if (offset & 1) {
        pair[1] = (uint8_t)((pair[1] & 0xf0u) | packed >> 8);
        pair[2] = (uint8_t)packed;
    } else {
        pair[0] = (uint8_t)(packed >> 4);
        pair[1] = (uint8_t)((pair[1] & 0x0fu) | packed << 4);
    }
}

GLINT_DEFINE_SPREAD(rgb444, pack_spread_rgb444, put_rgb444, 0)
GLINT_DEFINE_SPREAD(rgb444_dithered, pack_spread_rgb444, put_rgb444, 1)
GLINT_DEFINE_FORMAT(rgb444, 12, GLINT_ROW_EDGE, 4, 4, 4, pack_rgb444, put_rgb444, glint_fill_tile, GLINT_KEEPS_ANY,
                    GLINT_SPREAD_ANY, GLINT_SPREAD_ANY);

/* ---- Grey of 8 bits ---- */

static inline uint32_t pack_grey8(const int32_t colour[3], uint32_t threshold) {
    return glint_luma_level(colour, 255, threshold);
}

static inline void put_grey8(const glint_target *target, uint32_t offset, uint32_t packed) {
    ((uint8_t *)target->pixels)[offset] = (uint8_t)packed;
}

GLINT_DEFINE_FORMAT(grey8, 8, GLINT_ROW_EDGE, 0, 0, 0, pack_grey8, put_grey8, glint_fill_tile, GLINT_KEEPS_ANY,
                    GLINT_SPREAD_NONE, GLINT_SPREAD_NONE);

/* ---- Grey of 4 bits: the left pixel of two is in the high half of their byte ---- */

static inline uint32_t pack_grey4(const int32_t colour[3], uint32_t threshold) {
    return glint_luma_level(colour, 15, threshold);
}

static inline uint32_t pack_spread_grey4(uint32_t word, uint32_t threshold) {
    return glint_spread_luma(word, 4, threshold);
}

static inline void put_grey4(const glint_target *target, uint32_t offset, uint32_t packed) {
    uint8_t *pair = (uint8_t *)target->pixels + (offset >> 1);
    *pair = (uint8_t)(offset & 1 ? (*pair & 0xf0u) | packed : (*pair & 0x0fu) | packed << 4);
}

GLINT_DEFINE_SPREAD(grey4, pack_spread_grey4, put_grey4, 0)
GLINT_DEFINE_SPREAD(grey4_dithered, pack_spread_grey4, put_grey4, 1)
GLINT_DEFINE_FORMAT(grey4, 4, GLINT_ROW_EDGE, 0, 0, 0, pack_grey4, put_grey4, glint_fill_tile, GLINT_KEEPS_ANY,
                    GLINT_SPREAD_ANY, GLINT_SPREAD_ANY);

/* ---- One bit: the left pixel of eight is in the lowest bit of their byte ---- */

static inline uint32_t pack_mono(const int32_t colour[3], uint32_t threshold) {
    return glint_luma_level(colour, 1, threshold);
}

static inline uint32_t pack_spread_mono(uint32_t word, uint32_t threshold) {
    return glint_spread_luma(word, 1, threshold);
}

static inline void put_bit(uint8_t *eight, uint32_t bit, uint32_t packed) {
    *eight = (uint8_t)((*eight & ~(1u << bit)) | packed << bit);
}

static inline void put_mono(const glint_target *target, uint32_t offset, uint32_t packed) {
    put_bit((uint8_t *)target->pixels + (offset >> 3), offset & 7, packed);
}

GLINT_DEFINE_SPREAD(mono, pack_spread_mono, put_mono, 0)
GLINT_DEFINE_SPREAD(mono_dithered, pack_spread_mono, put_mono, 1)
GLINT_DEFINE_FORMAT(mono, 1, GLINT_ROW_EDGE, 0, 0, 0, pack_mono, put_mono, glint_fill_tile, GLINT_KEEPS_ANY,
                    GLINT_SPREAD_ANY, GLINT_SPREAD_ANY);

/* ---- One bit in pages of 8 rows: a byte for each column of a page, whose top row is in the lowest bit ---- */

static inline void put_mono_pages(const glint_target *target, uint32_t offset, uint32_t packed) {
    const uint32_t x = offset & ((1u << target->shift) - 1), y = offset >> target->shift;
    put_bit((uint8_t *)target->pixels + ((y >> 3 << target->shift) + x), y & 7, packed);
}

/* Fills 8 columns of a page and copies them to all others. */
static inline void fill_pages(const glint_target *t, uint32_t height, const int32_t colour[3], uint32_t bits,
                              glint_pack_colour pack_one, glint_put put_one) {
    (void)bits;
    for (uint32_t i = 0; i < 64; i++) {
        const uint32_t offset = (i >> 3 << t->shift) + (i & 7);
        put_one(t, offset, pack_one(colour, glint_threshold(t, offset)));
    }
    glint_repeat(t->pixels, 8, height << t->shift >> 3);
}

GLINT_DEFINE_SPREAD(mono_pages, pack_spread_mono, put_mono_pages, 0)
GLINT_DEFINE_SPREAD(mono_pages_dithered, pack_spread_mono, put_mono_pages, 1)
GLINT_DEFINE_FORMAT(mono_pages, 1, GLINT_PAGE_EDGE, 0, 0, 0, pack_mono, put_mono_pages, fill_pages, GLINT_KEEPS_ANY,
                    GLINT_SPREAD_ANY, GLINT_SPREAD_ANY);
