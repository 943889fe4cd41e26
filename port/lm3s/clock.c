/* SPDX-License-Identifier: MIT */
/* Register layout from the vendor's manuals as its public drivers use it. */
#include "clock.h"

#include "cortex-m/cortex-m.h"

enum {
    SYSCTL = 0x400fe000,
    SYSCTL_INTERRUPTS = SYSCTL + 0x50, /* raw */
    SYSCTL_CLOCK = SYSCTL + 0x60,
};

enum {
    CLOCK_MAIN_OFF = 1u << 0, /* switches the crystal off */
    CLOCK_SOURCE = 3u << 4,   /* 0: the crystal */
    CLOCK_CRYSTAL_SHIFT = 6,  /* its frequency, 4 bits */
    CLOCK_BYPASS = 1u << 11,  /* run without PLL */
    CLOCK_PLL_NO_OUTPUT = 1u << 12,
    CLOCK_PLL_OFF = 1u << 13,
    CLOCK_DIVIDE = 1u << 22,
    CLOCK_CRYSTAL = 15u << CLOCK_CRYSTAL_SHIFT,
    CLOCK_DIVISOR = 15u << 23,
    CLOCK_DIVISOR_4 = 3u << 23, /* 200 MHz / 4 */
    INTERRUPT_PLL_LOCKED = 1u << 6,
    PLL_WAIT = 100000, /* polls; the PLL locks within 0.5 ms, 6,000 clocks of the internal oscillator */
    CRYSTAL_WAIT_MS = 10,
};

enum { CLOCK_INTERNAL = 12000000 };

uint32_t lm3s_start_clock(lm3s_crystal crystal) {
    volatile uint32_t *clock = cortex_m_register(SYSCTL_CLOCK);
    const uint32_t internal = *clock;

    *clock = (internal | CLOCK_BYPASS) & ~(uint32_t)(CLOCK_DIVIDE | CLOCK_MAIN_OFF);
    cortex_m_delay(CRYSTAL_WAIT_MS, CLOCK_INTERNAL);
    *clock = (*clock & ~(uint32_t)(CLOCK_SOURCE | CLOCK_CRYSTAL | CLOCK_PLL_NO_OUTPUT | CLOCK_PLL_OFF)) |
             (uint32_t)crystal << CLOCK_CRYSTAL_SHIFT;
    *clock = (*clock & ~(uint32_t)CLOCK_DIVISOR) | CLOCK_DIVISOR_4 | CLOCK_DIVIDE;
    for (int i = 0; i < PLL_WAIT; i++) {
        if (*cortex_m_register(SYSCTL_INTERRUPTS) & INTERRUPT_PLL_LOCKED) {
            *clock &= ~(uint32_t)CLOCK_BYPASS;
            return LM3S_CLOCK_FULL;
        }
    }
    *clock = internal;
    return CLOCK_INTERNAL;
}
