/* SPDX-License-Identifier: MIT */
/** @file frames.h The turntable's frames drawn into memory: the same code on the host and on the boards. */
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

/** Draws a frame. @return the library's error, or GLINT_ERROR_ARENA when the arena here does not hold what it needs. */
glint_status frame_draw(frame_image *image, turntable_model model, uint32_t frame, const frame_options *options);

/** FNV-1a (Fowler, Noll, Vo) of all pixels, row by row. */
uint32_t frame_checksum(const frame_image *image);

#endif
