/* SPDX-License-Identifier: MIT */
/** @file frames.h Frames of the examples drawn into memory: the same code on the host and on the boards. */
#ifndef GLINT_TESTS_FRAMES_H
#define GLINT_TESTS_FRAMES_H

#include "turntable/turntable.h"

/** Bytes of a pixel in the widest format. */
#define FRAMES_PIXEL_MAX 3

/** How to draw a frame. */
typedef struct frame_options {
    const glint_format *format;
    uint16_t tile_width, tile_height; /**< 0 for the default. */
    int smallest;                     /**< In the smallest arena, not in the best. */
} frame_options;

typedef struct frame_image {
    uint8_t pixels[TURNTABLE_WIDTH * TURNTABLE_HEIGHT * FRAMES_PIXEL_MAX];
    size_t row_bytes;
    size_t arena_size; /**< Bytes of arena that it was drawn with. */
    glint_stats stats;
} frame_image;

/**
 * Draws a scene at the turntable's size; in as many passes as it takes when the arena here does not hold all.
 * @return the library's error
 */
glint_status frame_draw_scene(frame_image *image, const glint_scene *scene, const frame_options *options);

/** Draws a frame of the turntable. @return the library's error */
glint_status frame_draw(frame_image *image, turntable_model model, uint32_t frame, const frame_options *options);

/** FNV-1a (Fowler, Noll, Vo) of all pixels, row by row, the same whichever byte of a number the core stores first. */
uint32_t frame_checksum(const frame_image *image, const glint_format *format);

#endif
