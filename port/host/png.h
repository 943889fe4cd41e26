/* SPDX-License-Identifier: MIT */
/**
 * @file png.h
 * PNG pictures (ISO/IEC 15948), 8 bits a channel, and their animations (APNG, PNG third edition).
 */
#ifndef GLINT_HOST_PNG_H
#define GLINT_HOST_PNG_H

#include "basics.h"

#include <stdint.h>

/** Pictures of one size that follow each other, for ever. */
typedef struct png_movie {
    uint8_t *const *frames;                      /**< `count` of them, each as for png_encode. */
    uint32_t count;                              /**< 1 or more. */
    uint16_t delay_numerator, delay_denominator; /**< Seconds that a frame is shown. */
} png_movie;

/**
 * Appends a picture as a PNG file. The same pixels always give the same bytes.
 * @param pixels rows from top to bottom without padding, `channels` bytes a pixel
 * @param channels 1 for grey, 3 for red, green, blue
 */
void png_encode(host_bytes *out, const uint8_t *pixels, uint32_t width, uint32_t height, uint32_t channels);

/** Appends pictures as an animated PNG file: a frame holds the rectangle that differs from the one before. */
void png_encode_movie(host_bytes *out, const png_movie *movie, uint32_t width, uint32_t height, uint32_t channels);

/** Appends bytes as a zlib stream (RFC 1950). */
void zlib_encode(host_bytes *out, const uint8_t *data, size_t count);

#endif
