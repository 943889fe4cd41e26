/* SPDX-License-Identifier: MIT */
/* Gamma: an output table for each channel, linear between its entries; off by at most 2.5 steps of Q16. */
#include "format.h"

/* What a panel needs to show a channel. */
static int32_t look_up(const uint16_t *table, int32_t channel) {
    const uint32_t x = (uint32_t)glint_least(glint_most(channel, 0), GLINT_CHANNEL_ONE) >> 4; /* Q23 */
    const uint32_t entry = x >> 15, fraction = x & 0x7fff;
    const int32_t low = table[entry], high = table[entry + (entry < 256)];
    const int32_t value = low + glint_shift_right((high - low) / 2 * (int32_t)fraction, 14); /* 65535 is 1 */
    return (value + glint_shift_right(value, 15)) * (1 << (GLINT_CHANNEL_BITS - 16));
}

void glint_finish_colours(const glint_config *config, int32_t (*colour)[3], uint32_t count) {
    for (uint32_t i = 0; i < count; i++)
        for (int c = 0; c < 3; c++) {
            const int32_t shown = config->gamma ? look_up(config->gamma[c], colour[i][c]) : colour[i][c];
            colour[i][c] = glint_to_levels(shown, config->format->channel[c]);
        }
}
