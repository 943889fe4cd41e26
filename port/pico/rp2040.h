/* SPDX-License-Identifier: MIT */
/** @file rp2040.h Registers that more than one file of the port uses. */
#ifndef GLINT_RP2040_H
#define GLINT_RP2040_H

#include <stdint.h>

enum { RP2040_CLOCK_HZ = 125000000 };

/** Offsets of a register's aliases: what is written there sets or clears bits. */
enum { RP2040_SET = 0x2000, RP2040_CLEAR = 0x3000 };

enum {
    RP2040_RESETS = 0x4000c000,
    RP2040_RESETS_DONE = 0x4000c008,
    RP2040_RESET_DMA = 1u << 2,
    RP2040_RESET_IO = 1u << 5,
    RP2040_RESET_PADS = 1u << 8,
    RP2040_RESET_PLL = 1u << 12,
    RP2040_RESET_SPI0 = 1u << 16,
};

/** Lets peripherals out of reset. @return whether they came out in time. */
int rp2040_release(uint32_t peripherals);

#endif
