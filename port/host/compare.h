/* SPDX-License-Identifier: MIT */
/** @file compare.h How far two pictures are from each other. */
#ifndef GLINT_HOST_COMPARE_H
#define GLINT_HOST_COMPARE_H

#include "png.h"

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
