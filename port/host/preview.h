/* SPDX-License-Identifier: MIT */
/** @file preview.h A picture in a terminal. */
#ifndef GLINT_HOST_PREVIEW_H
#define GLINT_HOST_PREVIEW_H

#include <stdint.h>

/**
 * Prints a picture on standard output: two pixels a character, as an upper half block in 24-bit colours. One that is
 * wider than so many characters is made smaller by a whole number: each pixel is the mean of a square.
 * @param pixels rows from top to bottom without padding, `channels` bytes a pixel, 1 or 3
 */
void preview_print(const uint8_t *pixels, uint32_t width, uint32_t height, uint32_t channels, uint32_t columns);

#endif
