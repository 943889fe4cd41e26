/* SPDX-License-Identifier: MIT */
/* Mixes pixels of any format, as they are stored. */
#include "../pixel/packed.h"
#include "blend.h"

/* Finds a pixel of a tile. */
static glint_packed_place find_stored(const glint_canvas *canvas, uint32_t offset) {
    return glint_find_packed(canvas->format, canvas->pixels, canvas->shift, offset & ((1u << canvas->shift) - 1),
                             offset >> canvas->shift);
}

uint32_t glint_read_pixel(const glint_canvas *canvas, uint32_t offset) {
    const glint_packed_place place = find_stored(canvas, offset);
    return glint_read_packed(canvas->format, &place);
}

void glint_write_pixel(const glint_canvas *canvas, uint32_t offset, uint32_t pixel) {
    const glint_packed_place place = find_stored(canvas, offset);
    glint_write_packed(canvas->format, &place, pixel);
}

/* Mixes a channel or luma of so many bits. The threshold is in 1/128 level. */
static inline uint32_t mix_level(uint32_t pixel, uint32_t with, unsigned bits, uint32_t part, int adds,
                                 uint32_t threshold) {
    const uint32_t most = (1u << bits) - 1, rest = adds ? GLINT_WHOLE : GLINT_WHOLE - part;
    const uint32_t level = (pixel * rest + with * part + 2 * threshold) / GLINT_WHOLE;
    return level < most ? level : most;
}

/* Mixes two pixels. */
static uint32_t mix_any(const glint_format *format, uint32_t pixel, uint32_t with, uint32_t part, int adds,
                        uint32_t threshold) {
    uint32_t mixed = 0;
    unsigned low = 0;
    if (!format->channel[0])
        return mix_level(pixel, with, format->bits, part, adds, threshold);
    for (int c = 2; c >= 0; c--) {
        const unsigned bits = format->channel[c];
        const uint32_t mask = (1u << bits) - 1;
        mixed |= mix_level(pixel >> low & mask, with >> low & mask, bits, part, adds, threshold) << low;
        low += bits;
    }
    return mixed;
}

/* Adds a part of a pixel of RGB565 likewise. */
static inline uint32_t add_565(uint32_t pixel, uint32_t with, uint32_t part, uint32_t threshold) {
    const uint32_t more = (glint_take_apart(with) * part + threshold * 0x00200801u) >> 5 & GLINT_APART;
    const uint32_t sum = glint_take_apart(pixel) + more, over = sum & 0x08010020u;
    const uint32_t full = over - ((over & 0x00010020u) >> 5) - ((over & 0x08000000u) >> 6);
    const uint32_t mixed = (sum | full) & GLINT_APART;
    return (mixed | mixed >> 16) & 0xffff;
}

/* Mixes two pixels of RGB565, or adds one. */
static GLINT_INLINE uint32_t mix_or_add(uint32_t pixel, uint32_t with, uint32_t part, int adds, uint32_t threshold) {
    return adds ? add_565(pixel, with, part, threshold) : glint_mix_565(pixel, with, part, threshold);
}

void glint_mix_pixel(const glint_canvas *canvas, uint32_t offset, uint32_t with, uint32_t part, int adds) {
    const uint32_t pixel = glint_read_pixel(canvas, offset), threshold = glint_canvas_threshold(canvas, offset);
    glint_write_pixel(canvas, offset,
                      canvas->format->bits == 16 ? mix_or_add(pixel, with, glint_in_steps(part), adds, threshold / 4)
                                                 : mix_any(canvas->format, pixel, with, part, adds, threshold));
}

/* Mixes pixels of RGB565 that are not dithered. */
static GLINT_INLINE void mix_pixels_565(const glint_canvas *canvas, const uint16_t *with, uint32_t first, uint32_t end,
                                        uint32_t part, int adds) {
    const glint_format *const format = canvas->format;
    uint16_t *pixel = (uint16_t *)canvas->pixels + first, *const last = (uint16_t *)canvas->pixels + end;
    for (with += first; pixel != last; pixel++, with++) {
        const uint32_t mixed = mix_or_add(glint_order_bytes(format, *pixel), glint_order_bytes(format, *with), part,
                                          adds, GLINT_NEAREST / 4);
        *pixel = (uint16_t)glint_order_bytes(format, mixed);
    }
}

GLINT_HOT void glint_mix_pixels(const glint_canvas *canvas, void *with, uint32_t first, uint32_t end, uint32_t part,
                                int adds) {
    const uint32_t steps = glint_in_steps(part);
    const int is_plain = canvas->format->bits == 16 && !canvas->format->is_dithered;
    if (is_plain && adds) {
        mix_pixels_565(canvas, with, first, end, steps, 1);
    } else if (is_plain) {
        mix_pixels_565(canvas, with, first, end, steps, 0);
    } else {
        const glint_canvas from = {canvas->format, with, canvas->shift};
        for (; first < end; first++)
            glint_mix_pixel(canvas, first, glint_read_pixel(&from, first), part, adds);
    }
}
