/* SPDX-License-Identifier: MIT */
/** @file clock.h The clock of TI's (Luminary's) LM3S parts. */
#ifndef GLINT_LM3S_CLOCK_H
#define GLINT_LM3S_CLOCK_H

#include <stdint.h>

/** The clock that a part runs at once its PLL has locked, Hz. */
#define LM3S_CLOCK_FULL 50000000u

/** The crystal of a board. */
typedef enum lm3s_crystal { LM3S_CRYSTAL_6MHZ = 11, LM3S_CRYSTAL_8MHZ = 14 } lm3s_crystal;

/** @return the core's clock: LM3S_CLOCK_FULL, or that of the internal oscillator, 12 MHz, when the PLL does not lock.
 */
uint32_t lm3s_start_clock(lm3s_crystal crystal);

#endif
