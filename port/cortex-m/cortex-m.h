/* SPDX-License-Identifier: MIT */
/** @file cortex-m.h What the boards with a Cortex-M share, for their board.c to use. */
#ifndef GLINT_CORTEX_M_H
#define GLINT_CORTEX_M_H

#include <stdint.h>

/** Exit status of a program that start-up code ends. */
enum { EXIT_FAULT = 100, EXIT_INTERRUPT = 101 };

/** A register of a peripheral. */
static inline volatile uint32_t *cortex_m_register(uintptr_t address) {
    return (volatile uint32_t *)address;
}

/** Waits at least so many milliseconds on a core that runs at clock_hz. */
void cortex_m_delay(uint32_t milliseconds, uint32_t clock_hz);

/** board_exit by semihosting. */
void cortex_m_exit(int status);

#endif
