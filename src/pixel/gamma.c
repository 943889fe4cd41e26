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
