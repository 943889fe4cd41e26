/* SPDX-License-Identifier: MIT */
/* Draws 2 x 2 samples a pixel: a frame of twice the width and height, whose tiles are averaged where they lie. */
#include "../pixel/packed.h"
#include "frame.h"

static void enlarge(glint_config *config) {
    glint_rectangle *const region = &config->region;
    config->width = (uint16_t)(2 * config->width);
    config->height = (uint16_t)(2 * config->height);
    config->tile_width = (uint16_t)(2 * config->tile_width);
    config->tile_height = (uint16_t)(2 * config->tile_height);
    *region = (glint_rectangle){(int16_t)(2 * region->x), (int16_t)(2 * region->y), (int16_t)(2 * region->width),
                                (int16_t)(2 * region->height)};
    config->samples = 0;
}

/* These two are out of line, as each is used twice. */
static GLINT_NOINLINE uint32_t read_at(const glint_frame *frame, void *pixels, unsigned shift, uint32_t x, uint32_t y) {
    const glint_packed_place place = glint_find_packed(frame->config.format, pixels, shift, x, y);
    return glint_read_packed(frame->config.format, &place);
}

static GLINT_NOINLINE void write_at(const glint_frame *frame, void *pixels, unsigned shift, uint32_t x, uint32_t y,
                                    uint32_t packed) {
    const glint_packed_place place = glint_find_packed(frame->config.format, pixels, shift, x, y);
    glint_write_packed(frame->config.format, &place, packed);
}

/* Makes four samples of each pixel, from the last one on: no pixel is written over before it is read. */
static void spread(const glint_frame *frame, void *pixels) {
    const unsigned shift = frame->tile_shift_x;
    uint16_t *const words = pixels;
    for (uint32_t at = (uint32_t)frame->config.tile_height << shift; at--;) {
        const uint32_t x = at & (frame->config.tile_width - 1u), y = at >> shift;
        if (frame->config.format->bits == 16)
            words[at] = words[(y >> 1 << (shift - 1)) + (x >> 1)];
        else
            write_at(frame, pixels, shift, x, y, read_at(frame, pixels, shift - 1, x >> 1, y >> 1));
    }
}

/*
 * Returns the quarters of a level that are added to a mean in a row of pixels, for each of 8 columns. Half a level
 * rounds. Of dithered formats, samples have been rounded by thresholds: 8 x 8 samples, 4 x 4 pixels, repeat, and their
 * sum is that of the threshold's bits 1 to 4, exact to a quarter of a level. The highest bits and the lowest, which
 * only change at every fourth pixel, give 8 x 8 pixels 64 thresholds in all.
 */
static void find_quarters(const glint_format *format, uint32_t y, uint8_t quarters[8]) {
    for (uint32_t x = 0; x < 8; x++) {
        const uint32_t threshold = glint_dither_matrix[(y & 7) * 8 + x];
        quarters[x] = format->is_dithered ? (threshold >> 5 ^ threshold >> 1) & 3 : 2;
    }
}

/* Turns a word to the right. */
static inline uint32_t turn(uint32_t word, unsigned bits) {
    return word >> bits | word << (-bits & 31);
}

/* Averages a row of pixels of 16 bits: a word has two samples. It is turned by 8 bits where their bytes are swapped,
 * which swaps the bytes back: the high ones then belong to the other sample, which their sum does not tell. Red and
 * blue of one sample are added in between green of the other. */
static void average_words(uint16_t *to, const glint_word *from, uint32_t width, const uint8_t quarters[8],
                          unsigned swap) {
    const uint32_t mask = 0x07e0f81fu;
    for (uint32_t x = 0; x < width; x++) {
        const uint32_t above = turn(from[x], swap), below = turn(from[x + width], swap);
        const uint32_t sum = quarters[x & 7] * 0x00200801u + (above & mask) + (turn(above, 16) & mask) +
                             (below & mask) + (turn(below, 16) & mask);
        const uint32_t mean = sum >> 2 & mask;
        to[x] = (uint16_t)turn(mean | turn(mean, 16), swap);
    }
}

/* Averages a row of pixels of so many whole bytes. */
static void average_bytes(uint8_t *to, const uint8_t *from, uint32_t width, const uint8_t quarters[8], uint32_t bytes) {
    const uint8_t *below = from + 2 * width * bytes;
    for (uint32_t x = 0; x < width; x++, from += bytes, below += bytes)
        for (uint32_t i = 0; i < bytes; i++, from++, below++)
            *to++ = (uint8_t)((from[0] + from[bytes] + below[0] + below[bytes] + quarters[x & 7]) >> 2);
}

/* Averages a row of pixels that share bytes: at most 12 bits, which are moved apart from 4 by 4 to 8 by 8. */
static void average_packed(const glint_frame *frame, void *pixels, uint32_t y, const uint8_t quarters[8]) {
    const unsigned shift = frame->tile_shift_x;
    for (uint32_t x = 0; x < frame->config.tile_width / 2u; x++) {
        uint32_t sum = quarters[x & 7] * 0x10101u;
        for (uint32_t i = 0; i < 4; i++) {
            const uint32_t sample = read_at(frame, pixels, shift, 2 * x + (i & 1), 2 * y + (i >> 1));
            sum += (sample & 0xf00) << 8 | (sample & 0xf0) << 4 | (sample & 0xf);
        }
        const uint32_t mean = sum >> 2;
        write_at(frame, pixels, shift - 1, x, y, (mean >> 8 & 0xf00) | (mean >> 4 & 0xf0) | (mean & 0xf));
    }
}

/* Averages a finished tile from its first pixel on: no pixel is written before it is read. */
static void average(const glint_frame *frame, void *pixels) {
    const glint_format *const format = frame->config.format;
    const uint32_t width = frame->config.tile_width / 2u;
    const size_t stride = width * format->bits / 8u;
    const unsigned swap = format->is_high_first ? glint_to_high_first(1) >> 5 : 0; /* 0 on a big-endian core */
    uint8_t *to = pixels;
    const uint8_t *from = pixels;
    for (uint32_t y = 0; y < frame->config.tile_height / 2u; y++, to += stride, from += 4 * stride) {
        uint8_t quarters[8];
        find_quarters(format, y, quarters);
        if (format->bits == 16)
            average_words((void *)to, (const void *)from, width, quarters, swap);
        else if (format->bits % 8 == 0)
            average_bytes(to, from, width, quarters, format->bits / 8u);
        else
            average_packed(frame, pixels, y, quarters);
    }
}

/* Keeps the nearest of four samples' depths, from the tile's first pixel on. */
static void keep_nearest(const glint_frame *frame, uint16_t *depth) {
    const uint32_t width = frame->config.tile_width;
    uint16_t *to = depth;
    for (uint32_t y = 0; y < frame->config.tile_height; y += 2, depth += width)
        for (uint32_t x = 0; x < width; x += 2, depth += 2) {
            const int32_t above = glint_most(depth[0], depth[1]), below = glint_most(depth[width], depth[width + 1]);
            *to++ = (uint16_t)glint_most(above, below);
        }
}

const glint_sampling glint_samples_2x2 = {enlarge, spread, average, keep_nearest};
