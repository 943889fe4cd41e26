/* SPDX-License-Identifier: MIT */
/**
 * @file picture.h
 * An image drawn by the library into memory, as the bytes it sent, and how often each pixel was sent.
 */
#ifndef GLINT_PICTURE_H
#define GLINT_PICTURE_H

#include "glint.h"

typedef struct picture {
    int width, height;
    const glint_format *format;
    size_t stride; /**< Bytes per row. */
    size_t size;   /**< Bytes in all. */
    uint8_t *bytes;
    uint8_t *sent;      /**< Per pixel, times it was sent, 255 for more. */
    int sending, calls; /**< Is a tile on its way, and how many were sent? */
} picture;

/** How to draw; zeros for the defaults and the arena of one pass. */
typedef struct picture_options {
    uint16_t tile_width, tile_height;
    size_t arena_size;
    const uint16_t (*gamma)[GLINT_GAMMA_ENTRIES];
    glint_rectangle region;
    glint_painter background, overlay;
    const glint_layer_stage *layers;
    uint8_t skips_degenerate;
    uint8_t keeps_arena; /**< Two frames are drawn. */
    uint8_t waits;       /**< A tile is on its way until the flush is waited for. */
    uint8_t skew;        /**< Bytes by which the arena is not aligned. */
    const glint_sampling *samples;
    const glint_scene *before; /**< Where not null, the same renderer draws this first. */
    uint16_t *depth;           /**< Where not null, receives the depth of each pixel sent, row by row of the picture. */
} picture_options;

/** Allocates an empty picture; ends the program when there is no memory. Free with picture_close. */
picture picture_open(int width, int height, const glint_format *format);

void picture_close(picture *image);

/** A configuration for drawing into `image`, without an arena. */
glint_config picture_config(picture *image, const picture_options *options);

/** What a scene needs, drawn into `image`; ends the program where that is an error. */
glint_need picture_need(const picture *image, const glint_scene *scene, const picture_options *options);

/** An arena between the least, 0 of 256, and that of one pass, 256 of 256. */
size_t picture_arena(const glint_need *need, uint32_t share);

/** Draws a scene with glint_render and an arena of the size asked for, which has no byte more. */
glint_status picture_render(picture *image, const glint_scene *scene, const picture_options *options,
                            glint_stats *stats);

/** Copies a finished tile into `image`: what the flush callback does. @return 1 when it lies outside. */
int picture_put(picture *image, const int rectangle[4], const void *pixels, size_t stride);

/** A painter that adds to a uint32_t, its context, the pixels where no object is. */
int picture_count_empty(void *context, const glint_tile *tile);

/** A painter of bytes that differ from place to place. Its context is the format. */
int picture_paint_pattern(void *context, const glint_tile *tile);

/** Whether every pixel was sent once. */
int picture_is_complete(const picture *image);

/**
 * Draws a scene with these options over a copy of its picture. @return whether that is GLINT_OK, nothing changes, and
 * each pixel of the region is sent once and no other
 */
int picture_draws_same(const picture *whole, const glint_scene *scene, const picture_options *options,
                       glint_stats *stats);

/** Whether two pictures hold the same bytes. */
int picture_equal(const picture *a, const picture *b);

/** The format itself, or that of which it is the dithered twin. */
const glint_format *picture_undithered(const glint_format *format);

/**
 * What is added to a value in levels before it is cut off to the stored one: 1/2, or a dithered format's threshold
 * (Bayer, 1973), an odd number of 128ths that belongs to the place on the screen.
 */
double picture_threshold(const glint_format *format, int x, int y);

/** Channels of a format, 3 or 1, and the highest level of one. */
int picture_channels(const glint_format *format);
int picture_level_max(const glint_format *format, int channel);

/** The stored level of a channel. */
int picture_level(const picture *image, int x, int y, int channel);

#endif
