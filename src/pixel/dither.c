/* SPDX-License-Identifier: MIT */
/* Thresholds of ordered dithering (Bayer, 1973): bits of x ^ y and y, interleaved in reverse, times 2 plus 1. */
#include "pixel.h"

const uint8_t glint_dither_matrix[64] = {
    1,  65, 17,  81, 5,   69, 21,  85, 97,  33, 113, 49, 101, 37, 117, 53, 25,  89, 9,   73, 29,  93,
    13, 77, 121, 57, 105, 41, 125, 61, 109, 45, 7,   71, 23,  87, 3,   67, 19,  83, 103, 39, 119, 55,
    99, 35, 115, 51, 31,  95, 15,  79, 27,  91, 11,  75, 127, 63, 111, 47, 123, 59, 107, 43,
};
