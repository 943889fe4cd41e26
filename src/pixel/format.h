/* SPDX-License-Identifier: MIT */
/** @file format.h Describes channels of colours, and formats of pixels. */
#ifndef GLINT_FORMAT_H
#define GLINT_FORMAT_H

#include "../geometry/draw.h"
#include "../raster/triangle.h"

/** A channel on its way into a pixel has so many fractional bits: sums below 16 fit. */
#define GLINT_CHANNEL_BITS 27
#define GLINT_CHANNEL_ONE (1 << GLINT_CHANNEL_BITS)

/** Converts a channel from 15 bits, 1 = GLINT_COLOUR_ONE. */
static inline int32_t glint_channel_of(int16_t colour) {
    return (colour << (GLINT_CHANNEL_BITS - 15)) + (colour >> (30 - GLINT_CHANNEL_BITS));
}

/** Converts a colour, Q23, to channels that are not in levels. Channels beyond 15 become 15. */
static GLINT_INLINE void glint_channels_of(const uint32_t colour[3], int32_t channel[3]) {
    const uint32_t most = 15u << 23;
    for (int c = 0; c < 3; c++) /* Q23 to Q27 */
        channel[c] = (int32_t)((colour[c] < most ? colour[c] : most) << (GLINT_CHANNEL_BITS - 23));
}

/** Converts a channel to levels of so many bits and adds half a level, so that cutting it off rounds. With 0 bits the
 * channel stays as it is. */
static inline int32_t glint_to_levels(int32_t channel, unsigned bits) {
    return bits ? channel - glint_shift_right(channel, bits) + (1 << (GLINT_CHANNEL_BITS - 1 - bits)) : channel;
}

/* ---- Spread words ---- */

/*
 * A spread word is a colour as one word: blue is in bits 0 to 8, red in 10 to 19 and green in 21 to 30. The lowest 4, 5
 * and 4 bits of these are fractions of a level of 5, 5 and 6 bits. The bit above each channel is clear, so that two
 * words can be added.
 */
#define GLINT_SPREAD_GUARD 0x80100200u

/** A pixel of a tile has an offset and a colour. Where it is lit, it has N'.N', 1 = 2^32, and 2^14 over the root of
 * this: suns.h. */
typedef struct glint_spread {
    uint32_t offset, colour, square, over;
} glint_spread;

/** Packs a word into 16 bits: 5 red, 6 green, 5 blue. The caller cuts off what is above them. */
static inline uint32_t glint_spread_pack(uint32_t word) {
#if defined(__ARM_FEATURE_SAT) && defined(__GNUC__)
    union {
        uint32_t word;
        struct {
            uint32_t blue : 5, green : 6, red : 21;
        } part;
    } packed; /* green is inserted by one instruction */
    packed.word = word >> 4;
    packed.part.green = word >> 25 & 63;
    return packed.word;
#else
    const uint32_t levels = word >> 4 & 0x07e0f81fu; /* red and blue in place, green 16 bits above its own */
    return levels | levels >> 16;
#endif
}

/** Clamps each channel of a sum of two words: a guard bit that is set sets the nine below. */
static inline uint32_t glint_spread_clamp(uint32_t word) {
    uint32_t over = word & GLINT_SPREAD_GUARD;
    return word | (over - (over >> 9));
}

/** Packs a sum of two words with a threshold in 1/128 level into 16 bits. Blue and green of words have 1/16 of this. */
static inline uint32_t glint_spread_565(uint32_t word, uint32_t threshold) {
    return glint_spread_pack(glint_spread_clamp(word + (threshold >> 3) * 0x00200801u));
}

/* ---- Formats ---- */

struct glint_sun_spans;

extern const struct glint_sun_spans glint_sun_spans_rgb565, glint_sun_spans_rgb565_be;

/** Each format of 16 bits has functions of its own for spans of one directional light. They are named beside the
 * format, where only these lights look. */
typedef enum glint_spans_of { GLINT_SPANS_OF_ANY, GLINT_SPANS_OF_RGB565, GLINT_SPANS_OF_RGB565_BE } glint_spans_of;
extern const struct glint_sun_spans *const glint_spans_of_rgb565 GLINT_IF_LINKED, *const glint_spans_of_rgb565_be
                                                                                      GLINT_IF_LINKED;

/** A pixel of a tile is listed by its number, with its colour. */
typedef struct glint_list_pixel {
    uint32_t pixel;
    int32_t colour[3];
} glint_list_pixel;

/** Begins the colours of a visible triangle. @return 0 where walk->draw_span is to draw it */
typedef int glint_begin_colours(glint_row_walk *walk);

struct glint_format {
    uint8_t bits;       /* per pixel */
    uint8_t channel[3]; /* bits of each channel's levels; 0 where it goes into luma */
    uint8_t edge[2];    /* bits that are 0 in the x and the y of pixels that begin a byte */
    uint8_t is_dithered;
    uint8_t is_high_first; /* pixels of 16 bits have their high byte first */
    /** Stores `count` pixels of a tile, so many bytes apart. Their colours are in levels. */
    void (*store_list)(void *pixels, unsigned tile_shift_x, const glint_list_pixel *pixel, size_t stride,
                       uint32_t count);
    /** Gives all of a tile one colour. */
    void (*fill)(void *pixels, unsigned tile_shift_x, uint32_t height, const int32_t colour[3]);
    /** Draws a triangle of one colour, walk->packed. */
    void (*flat)(glint_row_walk *walk);
    /** Draws a small triangle of interpolated colours, whose rows have been begun. */
    void (*smooth_rows)(glint_row_walk *walk, glint_begin_colours *begin);
    /** Draws a span of one colour, and one of interpolated colours. */
    glint_draw_span *flat_span, *smooth;
    /** Stores a pixel of the tile; a dithered format adds its threshold. */
    void (*put)(const glint_row_walk *walk, uint32_t pixel, glint_lanes lanes);
    /** Stores pixels of a tile whose colours are spread words; may be null. Where spans of one directional light have
     * functions of their own, these have added half a level. */
    void (*store_spread)(void *pixels, unsigned tile_shift_x, const glint_spread *words, const glint_spread *end);
    uint8_t sun_spans; /* glint_spans_of */
};

/** Draws by spans a triangle of one colour that has been begun. */
void glint_walk_flat(glint_row_walk *walk, glint_begun begun);

/** Begins a triangle of one colour, and draws it by spans. */
void glint_draw_flat(glint_row_walk *walk);

/** Draws a small triangle of interpolated colours by spans. */
void glint_draw_smooth_rows(glint_row_walk *walk, glint_begin_colours *begin);

/** Returns the bits of a format's green, or of its luma. */
static inline unsigned glint_green_bits(const glint_format *format) {
    return format->channel[1] ? format->channel[1] : format->bits;
}

/** Do slopes serve fragments of triangles that are not small? They are off by up to half a level of 6 bits then, which
 * samples allow. */
static inline int glint_has_long_slopes(const glint_config *config) {
    return config->samples && !config->gamma && glint_green_bits(config->format) <= 6;
}

/** Sets what a walk knows of its frame's format. */
static inline void glint_walk_begin_format(glint_row_walk *walk, const glint_config *config) {
    const unsigned bits = glint_green_bits(config->format);
    walk->colour_bits = (uint8_t)(config->gamma ? 0 : bits > 4 ? bits : 6);
    walk->is_exacting = config->gamma || config->format->is_dithered || bits > 6;
}

/**
 * Dithered formats add this part of a level to interpolated colours. It is less than the least threshold, so that black
 * stays black and white stays white. The levels of 1 bit are far apart: there it is no more than rounding needs.
 */
static inline int32_t glint_dither_margin(unsigned bits) {
    return bits > 1 ? 256 : 2048;
}

/*
 * Levels of a format are Q15 of as many as its channels have, with half a level added where the format is not dithered.
 * Luma comes three times. Rounding may take interpolated levels beyond their corners. It must not take them below 0 or
 * carry into the next channel, so that it has to be less than half of what has been added.
 */

/** Brings a colour, 1 = GLINT_COLOUR_ONE, to levels by way of the configuration's output tables, where there are any.
 */
void glint_finish_lane_levels(const glint_config *config, const int16_t colour[3], int16_t level[3]);

/** Brings the colour of a facet, Q23, to levels, the same way. */
void glint_finish_facet(const glint_config *config, const uint32_t colour[3], int16_t level[3]);

/** Brings the colour of a corner, Q23, to levels that are interpolated; with output tables, to 1 = GLINT_COLOUR_ONE. */
void glint_finish_corner(const glint_config *config, const uint32_t colour[3], int16_t level[3]);

/** Returns the lanes of levels, which are 0 or above. */
static inline glint_lanes glint_lanes_of(const int16_t level[3]) {
    return (glint_lanes){(uint32_t)level[2] << 17 | (uint32_t)level[0] << 1, (uint32_t)level[1] << 17};
}

/** Returns the lanes of one colour, Q27 and 0 or above, by way of the output tables, where there are any. */
glint_lanes glint_flat_lanes(const glint_config *config, const int32_t channel[3]);

/** Returns the pixel of a colour that has half a level: for a format that is not dithered. */
uint32_t glint_pack(const glint_format *format, glint_lanes lanes);

/** Puts colours through the output tables, if there are any, and brings them to the format's levels. */
void glint_finish_colours(const glint_config *config, int32_t (*colour)[3], uint32_t count);

#endif
