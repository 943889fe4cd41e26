/* SPDX-License-Identifier: MIT */
/* Brings colours to the levels of a format, by way of an output table for each channel. The tables are linear between
 * their entries, and off by at most 2.5 steps of Q16. */
#include "pixel.h"

/* Returns the output of a table for a channel, Q27. 1 counts as a step less. */
static inline int32_t look_up(const uint16_t *table, int32_t channel) {
    const uint32_t x = glint_saturate(channel, 23, GLINT_CHANNEL_BITS - 23);
    const uint16_t *const entry = table + (x >> 15);
    const int32_t value =
        entry[0] + glint_shift_right((entry[1] - entry[0]) * (int32_t)(x & 0x7fff), 15); /* 65535 is 1 */
    return (value + glint_shift_right(value, 15)) * (1 << (GLINT_CHANNEL_BITS - 16));
}

void glint_finish_colours(const glint_config *config, int32_t (*colour)[3], uint32_t count) {
    const uint8_t *const bits = config->format->channel;
    if (config->gamma) {
        for (int c = 0; c < 3; c++) {
            const uint16_t *const table = config->gamma[c];
            const unsigned level_bits = bits[c];
            for (uint32_t i = 0; i < count; i++)
                colour[i][c] = glint_to_levels(look_up(table, colour[i][c]), level_bits);
        }
        return;
    }
    for (uint32_t i = 0; i < count; i++)
        for (int c = 0; c < 3; c++)
            colour[i][c] = glint_to_levels(colour[i][c], bits[c]);
}

/* Returns a level of 2^bits - 1, Q15, from a channel of 15 bits. */
static inline int32_t to_level(int32_t channel, unsigned bits) {
    const int32_t one = channel + glint_shift_right(channel, 14);
    return one - glint_shift_right(one, bits);
}

/* Places a level so that it can be cut off, or take a threshold. */
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

/* Clamps a colour, Q23, to 1. In the result 1 is GLINT_COLOUR_ONE. */
static void clamp_colour(const uint32_t colour[3], int16_t clamped[3]) {
    for (int c = 0; c < 3; c++)
        clamped[c] = (int16_t)(colour[c] < (1u << 23) - 256 ? (colour[c] + 128) >> 8 : GLINT_COLOUR_ONE);
}

/* Brings a channel, Q23, to Q15 of a format's levels, half a level added. */
static inline int16_t finish_channel(uint32_t channel, uint32_t bits) {
    const uint32_t one = channel < 1u << 23 ? channel : 1u << 23;
    return (int16_t)((one - (one >> bits) + ((1u << 22) >> bits)) >> 8);
}

/* Brings a colour to levels of a format that has three channels and is not dithered. @return 0 for others */
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

/* ---- Dithering ---- */

/* This table stays out of formats.c: compilers that know its entries peel the first one off loops, which costs more. */
const uint8_t glint_dither_matrix[64] = {
    1,  65, 17,  81, 5,   69, 21,  85, 97,  33, 113, 49, 101, 37, 117, 53, 25,  89, 9,   73, 29,  93,
    13, 77, 121, 57, 105, 41, 125, 61, 109, 45, 7,   71, 23,  87, 3,   67, 19,  83, 103, 39, 119, 55,
    99, 35, 115, 51, 31,  95, 15,  79, 27,  91, 11,  75, 127, 63, 111, 47, 123, 59, 107, 43,
};

/* ---- sRGB ---- */

/* This is the output table of displays that expect sRGB (IEC 61966-2-1). Suite `numbers` holds it against the formula.
 */
/* clang-format off */
#define CHANNEL { \
    0, 3255, 5552, 7237, 8618, 9809, 10867, 11827, 12710, 13531, 14300, 15025, \
    15713, 16368, 16995, 17595, 18173, 18730, 19269, 19790, 20295, 20786, 21263, 21728, \
    22181, 22624, 23056, 23478, 23892, 24297, 24694, 25083, 25465, 25840, 26209, 26571, \
    26927, 27278, 27623, 27963, 28298, 28627, 28953, 29273, 29590, 29902, 30210, 30515, \
    30815, 31112, 31406, 31696, 31983, 32266, 32547, 32824, 33099, 33370, 33639, 33906, \
    34169, 34430, 34689, 34945, 35199, 35450, 35699, 35947, 36191, 36434, 36675, 36914, \
    37151, 37385, 37619, 37850, 38079, 38307, 38533, 38757, 38980, 39201, 39420, 39638, \
    39854, 40069, 40282, 40494, 40705, 40914, 41122, 41328, 41533, 41737, 41939, 42141, \
    42341, 42539, 42737, 42934, 43129, 43323, 43516, 43708, 43899, 44089, 44277, 44465, \
    44652, 44837, 45022, 45206, 45388, 45570, 45751, 45931, 46110, 46288, 46465, 46642, \
    46817, 46992, 47166, 47339, 47511, 47682, 47853, 48023, 48192, 48360, 48527, 48694, \
    48860, 49025, 49190, 49354, 49517, 49679, 49841, 50002, 50162, 50322, 50481, 50639, \
    50797, 50954, 51111, 51266, 51422, 51576, 51730, 51884, 52036, 52189, 52340, 52491, \
    52642, 52792, 52941, 53090, 53238, 53386, 53533, 53680, 53826, 53972, 54117, 54262, \
    54406, 54549, 54693, 54835, 54977, 55119, 55260, 55401, 55541, 55681, 55820, 55959, \
    56098, 56236, 56373, 56510, 56647, 56783, 56919, 57054, 57189, 57324, 57458, 57592, \
    57725, 57858, 57990, 58122, 58254, 58385, 58516, 58647, 58777, 58907, 59036, 59165, \
    59294, 59422, 59550, 59678, 59805, 59932, 60058, 60184, 60310, 60435, 60561, 60685, \
    60810, 60934, 61058, 61181, 61304, 61427, 61549, 61671, 61793, 61915, 62036, 62157, \
    62277, 62398, 62518, 62637, 62757, 62876, 62994, 63113, 63231, 63349, 63466, 63584, \
    63701, 63817, 63934, 64050, 64166, 64281, 64397, 64512, 64626, 64741, 64855, 64969, \
    65083, 65196, 65309, 65422, 65535, \
}
/* clang-format on */

const uint16_t glint_gamma_srgb[3][GLINT_GAMMA_ENTRIES] = {CHANNEL, CHANNEL, CHANNEL};
