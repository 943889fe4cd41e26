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

/** Appends bytes as a zlib stream (RFC 1950). */
void zlib_encode(host_bytes *out, const uint8_t *data, size_t count);

/** The sum that ends a zlib stream: Adler-32. */
uint32_t zlib_checksum(const uint8_t *data, size_t count);

/**
 * Unpacks a zlib stream that holds exactly `count` bytes. What follows the stream is not read.
 * @param out room for `count` bytes; what it holds after a failure means nothing
 * @return false with a problem of line 0 when the stream is broken, or holds fewer bytes or more
 */
bool zlib_decode(uint8_t *out, size_t count, const uint8_t *data, size_t size, host_problem *problem);

/* ---- How far two pictures are from each other ---- */

/** What differs between two pictures of one size, in levels of 0 to 255. */
typedef struct comparison {
    uint32_t pixels, different; /**< In all, and those of which any channel differs. */
    uint32_t channels;          /**< That were compared: red, green, blue, and alpha where the other has some. */
    uint32_t largest[4];        /**< Largest difference of each channel. */
    double squares;             /**< Mean square of all differences. */
    uint32_t first_x, first_y;  /**< The first pixel that differs, by rows from the top. */
} comparison;

/**
 * Compares a picture, as png_encode takes it, with one that was read. Grey is compared as equal red, green and blue,
 * and the alpha of what has none is 255.
 * @param pixels as large as `other` is
 * @param channels 1 for grey, 3 for red, green, blue
 */
comparison compare_pictures(const uint8_t *pixels, uint32_t channels, const png_picture *other);

/** Peak signal-to-noise ratio in dB, for a peak of 255; infinite for equal pictures. */
double compare_psnr(const comparison *found);

/** Prints it, a `name value` a line. */
void compare_print(const comparison *found);

#endif
