/* SPDX-License-Identifier: MIT */
/* Gamma: an output table for each channel, linear between its entries; off by at most 2.5 steps of Q16. */
#include "frame.h"

void glint_apply_gamma(const uint16_t (*gamma)[GLINT_GAMMA_ENTRIES], uint32_t (*colour)[3], uint32_t count) {
    for (uint32_t i = 0; i < count; i++) {
        for (int c = 0; c < 3; c++) {
            uint32_t x = colour[i][c] < 1u << 23 ? colour[i][c] : 1u << 23;
            uint32_t entry = x >> 15, fraction = x & 0x7fff;
            int32_t low = gamma[c][entry], high = gamma[c][entry < 256 ? entry + 1 : 256];
            int32_t value = low + glint_shift_right((high - low) / 2 * (int32_t)fraction, 14); /* Q16, 65535 is 1 */
            colour[i][c] = ((uint32_t)value + ((uint32_t)value >> 15)) << 7;
        }
    }
}
