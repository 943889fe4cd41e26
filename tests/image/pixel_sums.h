/* SPDX-License-Identifier: MIT */
/**
 * @file pixel_sums.h
 * Checksums of what the library draws, over a thousand scenes of all kinds: a change that is to keep every pixel is
 * held against them. Whether pixels are right is judged elsewhere.
 */
#ifndef GLINT_PIXEL_SUMS_H
#define GLINT_PIXEL_SUMS_H

#include <stdint.h>

/** Scenes of one kind. */
typedef struct pixel_sums {
    uint32_t pixels; /**< Of all bytes of the pictures. */
    uint32_t counts; /**< Of what glint_stats counts of them, but bytes: what is dropped, and where. */
} pixel_sums;

extern const unsigned pixel_sums_count;

const char *pixel_sums_name(unsigned index);

/** Draws all scenes of a kind. @return 0 when the library refuses one */
int pixel_sums_draw(unsigned index, pixel_sums *found);

#endif
