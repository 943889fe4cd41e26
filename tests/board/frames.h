/* SPDX-License-Identifier: MIT */
/** @file frames.h Frames of the examples, or sums of their pixels: the same code on the host and on the boards. */
#ifndef GLINT_TESTS_FRAMES_H
#define GLINT_TESTS_FRAMES_H

#include "turntable/turntable.h"

/** Bytes of a pixel in the widest format. */
#define FRAMES_PIXEL_MAX 3

/** How to draw a frame. */
typedef struct frame_options {
    const glint_format *format;
    uint16_t tile_width, tile_height; /**< 0 for the board's own. */
    int smallest;                     /**< In the smallest arena, not in the best. */
    const glint_layer_stage *layers;
    const glint_sampling *samples;
} frame_options;

/** A picture in memory. */
typedef struct frame_image {
    uint8_t pixels[TURNTABLE_WIDTH * TURNTABLE_HEIGHT * FRAMES_PIXEL_MAX];
    size_t row_bytes;
} frame_image;

/**
 * Draws a scene at the turntable's size; in as many passes as it takes when the arena here does not hold all.
 * @return the library's error
 */
glint_status frame_draw_scene(frame_image *image, const glint_scene *scene, const frame_options *options);

/** Draws a frame of the turntable. @return the library's error */
glint_status frame_draw(frame_image *image, turntable_model model, uint32_t frame, const frame_options *options);

/**
 * Draws a scene and keeps the sum of its pixels alone: of a hash of each byte and of where it is, so that the order of
 * tiles does not count, and the same whichever byte of a number the core stores first.
 * @return the library's error
 */
glint_status frame_sum_scene(uint32_t *sum, const glint_scene *scene, const frame_options *options);

/** The same of a frame of the turntable. @return the library's error */
glint_status frame_sum(uint32_t *sum, turntable_model model, uint32_t frame, const frame_options *options);

#endif
