/* SPDX-License-Identifier: MIT */
/* Triangles of meshes of up to 256 vertices. */
#include "layout.h"

static void fetch_uint8(const uint8_t *from, size_t stride, uint32_t count, int16_t (*to)[3]) {
    for (uint32_t i = 0; i < count; i++, from += stride)
        for (int c = 0; c < 3; c++)
            to[i][c] = from[c];
}

const glint_attribute_type glint_attribute_uint8 = {GLINT_OF_TRIANGLES, 3, 1, fetch_uint8, &glint_layouts};
