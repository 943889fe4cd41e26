/* SPDX-License-Identifier: MIT */
/**
 * @file pixel_sums.h
 * Checksums of what the library draws, over a thousand scenes of all kinds: a change that is to keep every pixel is
 * held against them. Whether pixels are right is judged elsewhere.
 */
#ifndef GLINT_PIXEL_SUMS_H
#define GLINT_PIXEL_SUMS_H

#include <stdint.h>

extern const unsigned pixel_sums_count;

const char *pixel_sums_name(unsigned index);

/** Draws all scenes of a kind. @param sum of all bytes of the pictures. @return 0 when the library refuses one */
int pixel_sums_draw(unsigned index, uint32_t *sum);

#endif
