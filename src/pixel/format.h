/* SPDX-License-Identifier: MIT */
/** @file format.h Channels of colours, and formats of pixels. */
#ifndef GLINT_FORMAT_H
#define GLINT_FORMAT_H

#include "../geometry/draw.h"

/** Fractional bits of a channel on its way into a pixel: sums below 16 fit. */
#define GLINT_CHANNEL_BITS 27
#define GLINT_CHANNEL_ONE (1 << GLINT_CHANNEL_BITS)

/** A channel from one of 15 bits, 1 = GLINT_COLOUR_ONE. */
static inline int32_t glint_channel_of(int16_t colour) {
    return (colour << (GLINT_CHANNEL_BITS - 15)) + (colour >> (30 - GLINT_CHANNEL_BITS));
}

/** A colour, Q23, as channels that are not in levels; those beyond 15 become 15. */
static GLINT_INLINE void glint_channels_of(const uint32_t colour[3], int32_t channel[3]) {
    const uint32_t most = 15u << 23;
    for (int c = 0; c < 3; c++) /* Q23 to Q27 */
        channel[c] = (int32_t)((colour[c] < most ? colour[c] : most) << (GLINT_CHANNEL_BITS - 23));
}

/** A channel as levels of so many bits, half a level included: cut off, it is rounded. 0 bits: as it is. */
static inline int32_t glint_to_levels(int32_t channel, unsigned bits) {
    return bits ? channel - glint_shift_right(channel, bits) + (1 << (GLINT_CHANNEL_BITS - 1 - bits)) : channel;
}

struct glint_spans;
struct glint_spread;
struct glint_quadratic;
struct glint_run;

/** Colours that are mixed of two numbers: base + light n0 + gloss n1, but no less than `least` if there is one, in
 * levels. */
typedef struct glint_mix {
    int32_t base[3], light[3], gloss[3], least[3];
    int has_least;
} glint_mix;

/** Fast lighting: what a format that has it links. fast.h. */
typedef struct glint_fast {
    int (*serves)(const glint_frame *frame, const glint_object *object);
    glint_status (*prepare)(glint_frame *frame); /* behind all shadings */
    /** Adds the bytes that a material takes at least, and its tables, which want as much room left behind them. */
    void (*need)(const glint_frame *frame, const struct glint_shading *shading, size_t *least, size_t *tables);
    const glint_evaluation *evaluation; /* of what it serves */
    int stores_spread;                  /* the format makes pixels of these */
} glint_fast;

extern const glint_fast glint_fast_rgb565, glint_fast_rgb565_be, glint_fast_spread;

struct glint_format {
    uint8_t bits;       /* per pixel */
    uint8_t channel[3]; /* bits of each channel's levels; 0 where it goes into luma */
    uint8_t edge[2];    /* bits that are 0 in the x and the y of pixels with which bytes begin */
    /** Stores runs of a tile, whose colours follow each other, in levels. */
    void (*store)(void *pixels, unsigned tile_shift_x, const struct glint_run *runs, const struct glint_run *end,
                  const int32_t (*colour)[3]);
    /** Gives all of a tile one colour. */
    void (*fill)(void *pixels, unsigned tile_shift_x, uint32_t height, const int32_t colour[3]);
    /* What the others do as well, in one loop; null in a library built for size. */
    /** Draws spans of one colour. */
    void (*draw_even)(const struct glint_spans *spans, const int32_t colour[3]);
    /** Draws spans of three polynomials; those that are not curved have no second degree. */
    void (*draw_channels)(const struct glint_spans *spans, const struct glint_quadratic *channels, int is_curved);
    /** Draws spans of colours that are mixed of a polynomial's high half. */
    void (*draw_mixed)(const struct glint_spans *spans, const struct glint_quadratic *light, const glint_mix *mix);
    /** Stores runs of a tile whose colours are mixed; without gloss, of the first number alone. */
    void (*store_mixed)(void *pixels, unsigned tile_shift_x, const struct glint_run *runs, const struct glint_run *end,
                        const glint_mix *mix, int has_gloss, const int32_t (*numbers)[3]);
    /** Stores pixels of a tile whose colours are words without half a level. spread.h */
    void (*store_spread)(void *pixels, unsigned tile_shift_x, const struct glint_spread *words,
                         const struct glint_spread *end);
    const struct glint_fast *fast; /* or null */
};

/** One channel of what is mixed. */
static GLINT_INLINE int32_t glint_mix_channel(const glint_mix *mix, int c, const int32_t number[3], int has_gloss,
                                              int has_least) {
    int32_t channel = mix->base[c] + number[0] * mix->light[c];
    if (has_gloss)
        channel += number[1] * mix->gloss[c];
    return has_least ? glint_most(channel, mix->least[c]) : channel;
}

/** Puts colours through the output tables, if there are any, and brings them to the format's levels. */
void glint_finish_colours(const glint_config *config, int32_t (*colour)[3], uint32_t count);

#endif
