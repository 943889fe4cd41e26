/* SPDX-License-Identifier: MIT */
/* Types of 16 bits, as a mesh's own arrays have them, one a stride from the other. */
#include "layout.h"

static void fetch_words(const uint8_t *from, size_t stride, uint32_t count, int16_t (*to)[3]) {
    for (uint32_t i = 0; i < count; i++, from += stride) {
        const int16_t *word = (const int16_t *)(const void *)from;
        for (int c = 0; c < 3; c++)
            to[i][c] = word[c];
    }
}

const glint_attribute_type glint_attribute_int16 = {GLINT_OF_POSITIONS | GLINT_OF_NORMALS, 6, 2, fetch_words,
                                                    &glint_layouts};
const glint_attribute_type glint_attribute_uint16 = {GLINT_OF_TRIANGLES, 6, 2, fetch_words, &glint_layouts};
