/* SPDX-License-Identifier: MIT */
/** @file packed.h Reads and writes stored pixels of any format as numbers: red, green and blue from the highest bit
 * down, or luma. */
#ifndef GLINT_PACKED_H
#define GLINT_PACKED_H

#include "pixel.h"

/** A stored pixel lies in so many bytes, the high one first, from this bit on. */
typedef struct glint_packed_place {
    uint8_t *bytes;
    uint32_t count, low;
} glint_packed_place;

/** Finds pixel x, y of a tile 2^shift pixels wide. */
static inline glint_packed_place glint_find_packed(const glint_format *format, void *pixels, unsigned shift, uint32_t x,
                                                   uint32_t y) {
    const uint32_t bits = format->bits, at = ((y << shift) + x) * bits;
    if (format->edge[1])
        return (glint_packed_place){(uint8_t *)pixels + (y >> 3 << shift) + x, 1, y & 7};
    return (glint_packed_place){(uint8_t *)pixels + (at >> 3), (bits + 7) >> 3,
                                bits == 1  ? at & 7
                                : bits & 4 ? 4 - (at & 4) /* the left one of two is higher */
                                           : 0};
}

/** Brings what the bytes of a pixel say to its number, and back. */
static inline uint32_t glint_order_packed(const glint_format *format, uint32_t packed) {
    return format->bits == 16 && !format->is_high_first ? glint_to_high_first(packed) : packed;
}

/** Returns a pixel. */
static inline uint32_t glint_read_packed(const glint_format *format, const glint_packed_place *place) {
    uint32_t all = 0;
    for (uint32_t i = 0; i < place->count; i++)
        all = all << 8 | place->bytes[i];
    return glint_order_packed(format, all >> place->low & ((1u << format->bits) - 1));
}

/** Writes a pixel. */
static inline void glint_write_packed(const glint_format *format, const glint_packed_place *place, uint32_t packed) {
    uint32_t clear = ((1u << format->bits) - 1) << place->low, set = glint_order_packed(format, packed) << place->low;
    for (uint32_t i = place->count; i--; clear >>= 8, set >>= 8)
        place->bytes[i] = (uint8_t)((place->bytes[i] & ~clear) | set);
}

#endif
