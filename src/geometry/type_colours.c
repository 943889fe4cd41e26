/* SPDX-License-Identifier: MIT */
/* Colours of vertices, one a stride from the other. */
#include "layout.h"

static void fetch888(const uint8_t *from, size_t stride, uint32_t count, int16_t (*to)[3]) {
    for (uint32_t i = 0; i < count; i++, from += stride)
        for (int c = 0; c < 3; c++)
            to[i][c] = glint_channel_from8(from[c]);
}

static void fetch565(const uint8_t *from, size_t stride, uint32_t count, int16_t (*to)[3]) {
    for (uint32_t i = 0; i < count; i++, from += stride)
        for (int c = 0; c < 3; c++)
            to[i][c] = glint_channel_from565(*(const uint16_t *)(const void *)from, c);
}

const glint_attribute_type glint_attribute_rgb888 = {GLINT_OF_COLOURS, 3, 1, fetch888, &glint_layouts};
const glint_attribute_type glint_attribute_rgb565 = {GLINT_OF_COLOURS, 2, 2, fetch565, &glint_layouts};
