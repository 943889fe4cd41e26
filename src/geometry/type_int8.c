/* SPDX-License-Identifier: MIT */
/* Positions and normals of 8 bits: the high halves of 16. */
#include "layout.h"

static void fetch_int8(const uint8_t *from, size_t stride, uint32_t count, int16_t (*to)[3]) {
    for (uint32_t i = 0; i < count; i++, from += stride)
        for (int c = 0; c < 3; c++)
            to[i][c] = (int16_t)((int8_t)from[c] * 256);
}

const glint_attribute_type glint_attribute_int8 = {GLINT_OF_POSITIONS | GLINT_OF_NORMALS, 3, 1, fetch_int8,
                                                   &glint_layouts};
