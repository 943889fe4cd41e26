/* SPDX-License-Identifier: MIT */
/* Fast lighting of other formats, which make their pixels of words. */
#include "fast_draw.h"

GLINT_DEFINE_FAST(spread, GLINT_STORES_SPREAD);
