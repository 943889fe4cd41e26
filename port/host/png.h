/* SPDX-License-Identifier: MIT */
/**
 * @file png.h
 * PNG pictures (ISO/IEC 15948): those of 8 bits a channel and their animations (APNG, PNG third edition) are written,
 * all but interlaced ones are read.
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

/** Unpacks a zlib stream of any bytes. @return false unless it is whole and gives `size` bytes, no fewer and no more */
bool zlib_decode(const uint8_t *data, size_t count, uint8_t *out, size_t size);

/** The sum that ends a zlib stream: Adler-32. */
uint32_t zlib_sum(const uint8_t *data, size_t count);

/** Longest side of a picture that is read: a file of some KB can ask for gigabytes. */
#define PICTURE_SIDE_MAX 4096u

/** A picture in memory, 8 bits a channel. */
typedef struct host_picture {
    uint8_t (*pixels)[4]; /**< Red, green, blue, alpha: rows from top to bottom. The owner frees them. */
    uint32_t width, height;
} host_picture;

/**
 * Reads a PNG file of any bytes. CRCs are not compared: the sum of the zlib stream tells of damaged pixels.
 * @return false with a problem of line 0; nothing is then to be freed
 */
bool png_decode(const uint8_t *data, size_t count, host_picture *picture, host_problem *problem);

#endif
