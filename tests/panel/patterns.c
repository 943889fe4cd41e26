/* SPDX-License-Identifier: MIT */
#include "patterns.h"

#include <string.h>

/* Level of a channel, of 2^bits: the same upper bits, however many. */
static unsigned pattern_level(int x, int y, int channel, unsigned bits) {
    const uint32_t mixed = ((uint32_t)x * 2654435761u) ^ ((uint32_t)y * 40503u * 65537u) ^ ((uint32_t)channel << 20);

    return (mixed ^ mixed >> 15) * 2246822519u >> (32 - bits);
}

uint8_t pattern_expand(unsigned level, unsigned bits) {
    const unsigned top = (1u << bits) - 1;

    return (uint8_t)((level * 255 + top / 2) / top);
}

/* Bits of a channel that the glass shows of a pixel of so many bits: of 24, the upper 6 of each 8. */
static unsigned channel_bits(unsigned bits, int channel) {
    return bits == 24 ? 6 : bits == 16 ? (channel == 1 ? 6 : 5) : bits == 12 ? 4 : bits;
}

static void put_16(uint8_t *row, int column, int x, int y, int has_words) {
    const unsigned word = pattern_level(x, y, 0, 5) << 11 | pattern_level(x, y, 1, 6) << 5 | pattern_level(x, y, 2, 5);
    const uint16_t native = (uint16_t)word;

    row[2 * column] = (uint8_t)(word >> 8);
    row[2 * column + 1] = (uint8_t)word;
    if (has_words) {
        memcpy(row + 2 * column, &native, sizeof native);
    }
}

static void put_nibble(uint8_t *row, int at, unsigned level) {
    row[at / 2] = (uint8_t)(at % 2 ? (row[at / 2] & 0xf0) | level : (row[at / 2] & 0x0f) | level << 4);
}

void pattern_fill(const way *to, uint8_t *tile, size_t stride, const int rectangle[4]) {
    const int has_pages = to->bits == 1 && to->driver.rotation % 2 == 0;

    for (int i = 0; i < rectangle[2] * rectangle[3]; i++) {
        const int column = i % rectangle[2];
        const int line = i / rectangle[2];
        const int x = rectangle[0] + column;
        const int y = rectangle[1] + line;
        uint8_t *row = tile + (size_t)line * stride;
        if (to->bits == 24) {
            for (int channel = 0; channel < 3; channel++) {
                row[3 * column + channel] = (uint8_t)pattern_level(x, y, channel, 8);
            }
        } else if (to->bits == 16) {
            put_16(row, column, x, y, to->driver.has_words);
        } else if (to->bits == 12) {
            for (int channel = 0; channel < 3; channel++) {
                put_nibble(row, 3 * column + channel, pattern_level(x, y, channel, 4));
            }
        } else if (to->bits == 4) {
            put_nibble(row, column, pattern_level(x, y, 0, 4));
        } else if (has_pages) {
            tile[(size_t)(line / 8 * 8) * stride + (size_t)column] |= (uint8_t)(pattern_level(x, y, 0, 1) << line % 8);
        } else {
            row[column / 8] |= (uint8_t)(pattern_level(x, y, 0, 1) << column % 8);
        }
    }
}

void pattern_expect(const way *to, int x, int y, uint8_t rgb[3]) {
    const int is_grey = to->bits <= 4;

    for (int channel = 0; channel < (is_grey ? 1 : 3); channel++) {
        const unsigned bits = channel_bits(to->bits, channel);
        rgb[channel] = pattern_expand(pattern_level(x, y, channel, bits), bits);
    }
    if (is_grey) {
        rgb[1] = rgb[2] = rgb[0];
    }
}

way way_choose(const tested_panel *panel, const wire *line, unsigned rotation, unsigned bits, int has_words) {
    static const glint_format *const of_bits[25] = {
        [12] = &glint_format_rgb444, [16] = &glint_format_rgb565_be, [24] = &glint_format_rgb888};
    way to = {panel, {panel->type, &line->bus, (glint_panel_rotation)rotation, NULL, has_words}, bits};

    to.driver.format = has_words ? &glint_format_rgb565 : of_bits[bits];
    return to;
}
