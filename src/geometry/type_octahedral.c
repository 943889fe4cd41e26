/* SPDX-License-Identifier: MIT */
/* Normals as points of an octahedron that is folded onto a square (Meyer et al., 2010; Cigolle et al., 2014). */
#include "layout.h"

/*
 * The normal of x and y, |x| + |y| + |z| = one: exact. One up to 32767; what is below -one stands for -one. Where z < 0
 * a coordinate is one less the other's magnitude, with its own sign: that is itself and z more or less.
 */
static inline void unfold(int32_t x, int32_t y, int32_t one, int32_t scale, int16_t to[3]) {
    x = x < -one ? -one : x;
    y = y < -one ? -one : y;
    const int32_t z = one - (x < 0 ? -x : x) - (y < 0 ? -y : y);
    const int32_t folded = z < 0 ? z : 0;
    to[0] = (int16_t)((x < 0 ? x - folded : x + folded) * scale);
    to[1] = (int16_t)((y < 0 ? y - folded : y + folded) * scale);
    to[2] = (int16_t)(z * scale);
}

static void fetch8(const uint8_t *from, size_t stride, uint32_t count, int16_t (*to)[3]) {
    for (uint32_t i = 0; i < count; i++, from += stride)
        unfold((int8_t)from[0], (int8_t)from[1], 127, 258, to[i]);
}

static void fetch16(const uint8_t *from, size_t stride, uint32_t count, int16_t (*to)[3]) {
    for (uint32_t i = 0; i < count; i++, from += stride) {
        const int16_t *word = (const int16_t *)(const void *)from;
        unfold(word[0], word[1], 32767, 1, to[i]);
    }
}

const glint_attribute_type glint_attribute_octahedral8 = {GLINT_OF_NORMALS, 2, 1, fetch8, &glint_layouts};
const glint_attribute_type glint_attribute_octahedral16 = {GLINT_OF_NORMALS, 4, 2, fetch16, &glint_layouts};
