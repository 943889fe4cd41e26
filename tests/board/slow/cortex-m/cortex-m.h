/* SPDX-License-Identifier: MIT */
/** @file cortex-m.h In place of port/cortex-m/cortex-m.h: registers of a port that tests/board/stm32_slow.c lets run.
 */
#ifndef GLINT_CORTEX_M_H
#define GLINT_CORTEX_M_H

#include <stdint.h>

/** A register, as it is by now. */
volatile uint32_t *cortex_m_register(uintptr_t address);

#endif
