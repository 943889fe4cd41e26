/* SPDX-License-Identifier: MIT */
/** @file bayer.h Thresholds of ordered dithering (Bayer, 1973). */
#ifndef GLINT_REFERENCE_BAYER_H
#define GLINT_REFERENCE_BAYER_H

/** Returns the threshold of a pixel of the screen: an odd number of 128ths. Each quarter of the matrix is the one of
 * half its size, times 4, plus 0, 2, 3 or 1. */
static inline double bayer_threshold(int x, int y) {
    static const int quarters[2][2] = {{0, 2}, {3, 1}};
    int value = 0;
    for (int half = 1; half < 8; half *= 2) /* the smallest quarter weighs most */
        value = 4 * value + quarters[y / half % 2][x / half % 2];
    return (2 * value + 1) / 128.0;
}

#endif
