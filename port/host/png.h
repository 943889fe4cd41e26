/* SPDX-License-Identifier: MIT */
/**
 * @file png.h
 * PNG pictures (ISO/IEC 15948), 8 bits a channel, and their animations (APNG, PNG third edition).
 */
#ifndef GLINT_HOST_PNG_H
#define GLINT_HOST_PNG_H

#include "output.h"

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

/** The checksum of a chunk's type and data: CRC-32. */
uint32_t png_checksum(const uint8_t *data, size_t count);

/** Appends pictures as an animated PNG file: a frame holds the rectangle that differs from the one before. */
void png_encode_movie(host_bytes *out, const png_movie *movie, uint32_t width, uint32_t height, uint32_t channels);

/** Most pixels of a side that is read: no picture of glint has more. */
#define PNG_SIDE_MAX 1024u

/** Most bytes of a file that is read. */
#define PNG_FILE_MAX 16000000u

/** A picture that was read; free `pixels`. */
typedef struct png_picture {
    uint32_t width, height;
    uint8_t *pixels; /**< Red, green, blue and alpha, rows from top to bottom. */
    bool opaque;     /**< Whether all alpha is 255. */
} png_picture;

/**
 * Reads a PNG file: grey, colour or palette, 1 to 8 bits a channel, alpha or none. Of an animation it is the picture
 * that other programs show. Refused by name: 16 bits a channel, interlacing, one transparent colour of a picture
 * without palette, and sides beyond PNG_SIDE_MAX. Gamma and colour profiles are not followed.
 * @param[out] picture set up by this, the caller frees its pixels; untouched when the result is false
 * @return false with a problem of line 0 when it is no such file
 */
bool png_decode(png_picture *picture, const uint8_t *data, size_t count, host_problem *problem);

#endif
