/* SPDX-License-Identifier: MIT */
/* Fast lighting of pixels of 16 bits, high byte first. */
#include "fast_draw.h"

GLINT_DEFINE_FAST(rgb565_be, GLINT_STORES_565_BE);
