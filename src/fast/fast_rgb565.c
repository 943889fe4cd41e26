/* SPDX-License-Identifier: MIT */
/* Fast lighting of pixels of 16 bits: 5 red, 6 green, 5 blue. */
#include "fast_draw.h"

GLINT_DEFINE_FAST(rgb565, GLINT_STORES_565);
