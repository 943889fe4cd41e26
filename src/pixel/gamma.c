/* SPDX-License-Identifier: MIT */
/* Gamma: an output table for each channel, linear between its entries; off by at most 2.5 steps of Q16. */
#include "pixel.h"

/* What a panel needs to show a channel; 1 is taken for a step less. */
static inline int32_t look_up(const uint16_t *table, int32_t channel) {
    const uint32_t x = glint_saturate(channel, 23, GLINT_CHANNEL_BITS - 23);
    const uint16_t *const entry = table + (x >> 15);
    const int32_t value =
        entry[0] + glint_shift_right((entry[1] - entry[0]) * (int32_t)(x & 0x7fff), 15); /* 65535 is 1 */
    return (value + glint_shift_right(value, 15)) * (1 << (GLINT_CHANNEL_BITS - 16));
}

/* The same of a channel of some colours, in levels. */
static void look_up_all(const uint16_t *table, unsigned bits, int32_t (*colour)[3], int c, uint32_t count) {
    for (uint32_t i = 0; i < count; i++)
        colour[i][c] = glint_to_levels(look_up(table, colour[i][c]), bits);
}

void glint_finish_colours(const glint_config *config, int32_t (*colour)[3], uint32_t count) {
    const uint8_t *const bits = config->format->channel;
    if (config->gamma) {
        for (int c = 0; c < 3; c++)
            look_up_all(config->gamma[c], bits[c], colour, c, count);
        return;
    }
    for (uint32_t i = 0; i < count; i++)
        for (int c = 0; c < 3; c++)
            colour[i][c] = glint_to_levels(colour[i][c], bits[c]);
}

/* A level of 2^bits - 1, Q15, from a channel of 15 bits. */
static inline int32_t to_level(int32_t channel, unsigned bits) {
    const int32_t one = channel + glint_shift_right(channel, 14);
    return one - glint_shift_right(one, bits);
}

/* Brings a level to where it can be cut off, or take a threshold. */
static inline int16_t place_level(const glint_format *format, int32_t level, unsigned bits, int is_interpolated) {
    const int32_t unit = 1 << (15 - bits);
    if (!format->is_dithered)
        return (int16_t)(level + unit / 2);
    return (int16_t)(is_interpolated ? level + unit / glint_dither_margin(bits) : level);
}

static void to_lane_levels(const glint_format *format, const int16_t colour[3], int16_t level[3], int is_interpolated) {
    if (!format->channel[1]) { /* luma (ITU-R BT.601) */
        const int32_t luma = glint_shift_right(colour[0] * 9798 + colour[1] * 19235 + colour[2] * 3735, 15);
        level[0] = level[1] = level[2] =
            place_level(format, to_level(luma, format->bits), format->bits, is_interpolated);
        return;
    }
    for (int c = 0; c < 3; c++)
        level[c] = place_level(format, to_level(colour[c], format->channel[c]), format->channel[c], is_interpolated);
}

void glint_finish_lane_levels(const glint_config *config, const int16_t colour[3], int16_t level[3]) {
    int16_t shown[3];
    for (int c = 0; c < 3; c++) {
        shown[c] = colour[c];
        if (config->gamma)
            shown[c] =
                (int16_t)glint_least(look_up(config->gamma[c], glint_channel_of(colour[c])) >> 12, GLINT_COLOUR_ONE);
    }
    to_lane_levels(config->format, shown, level, 0);
}

/* Clamps a colour, Q23, at 1: 1 = GLINT_COLOUR_ONE. */
static void clamp_colour(const uint32_t colour[3], int16_t clamped[3]) {
    for (int c = 0; c < 3; c++)
        clamped[c] = (int16_t)(colour[c] < (1u << 23) - 256 ? (colour[c] + 128) >> 8 : GLINT_COLOUR_ONE);
}

/* Brings a channel, Q23, to Q15 of a format's levels, half a level added. */
static inline int16_t finish_channel(uint32_t channel, uint32_t bits) {
    const uint32_t one = channel < 1u << 23 ? channel : 1u << 23;
    return (int16_t)((one - (one >> bits) + ((1u << 22) >> bits)) >> 8);
}

/* Brings a colour to levels of a format that has three channels, and is not dithered. @return 0 for others */
static inline int finish_plain(const glint_config *config, const uint32_t colour[3], int16_t level[3]) {
    const glint_format *format = config->format;
    if (config->gamma || format->is_dithered || !format->channel[1])
        return 0;
    level[0] = finish_channel(colour[0], format->channel[0]);
    level[1] = finish_channel(colour[1], format->channel[1]);
    level[2] = finish_channel(colour[2], format->channel[2]);
    return 1;
}

void glint_finish_facet(const glint_config *config, const uint32_t colour[3], int16_t level[3]) {
    if (finish_plain(config, colour, level))
        return;
    clamp_colour(colour, level);
    glint_finish_lane_levels(config, level, level);
}

void glint_finish_corner(const glint_config *config, const uint32_t colour[3], int16_t level[3]) {
    if (finish_plain(config, colour, level))
        return;
    clamp_colour(colour, level);
    if (!config->gamma)
        to_lane_levels(config->format, level, level, 1);
}

glint_lanes glint_flat_lanes(const glint_config *config, const int32_t channel[3]) {
    const glint_format *format = config->format;
    const uint32_t whole = GLINT_CHANNEL_ONE - 1, rounds = format->is_dithered ? 0 : GLINT_NEAREST;
    int32_t colour[1][3];
    uint32_t level[3];
    for (int c = 0; c < 3; c++)
        colour[0][c] = glint_least(channel[c], GLINT_CHANNEL_ONE);
    glint_finish_colours(config, colour, 1);
    if (!format->channel[1]) {
        const uint32_t luma = glint_luma(colour[0]) * ((1u << format->bits) - 1) << (14 - format->bits);
        return (glint_lanes){0, luma + (rounds << (25 - format->bits))};
    }
    for (int c = 0; c < 3; c++) {
        const int32_t half = format->is_dithered ? 1 << (GLINT_CHANNEL_BITS - 1 - format->channel[c]) : 0;
        level[c] = (uint32_t)glint_least(colour[0][c] - half, (int32_t)whole);
    }
    return (glint_lanes){level[2] >> 11 << 16 | level[0] >> 11, level[1] << 5};
}

uint32_t glint_pack(const glint_format *format, glint_lanes lanes) {
    return glint_pack_lanes(lanes, format->channel[0], glint_green_bits(format));
}
