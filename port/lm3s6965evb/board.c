/* SPDX-License-Identifier: MIT */
/*
 * TI (Luminary) LM3S6965 evaluation board: Cortex-M3 at 50 MHz, OLED on SSI0. Register layout from the vendor's
 * LM3S6965 manual as its public drivers use it; QEMU confirms SSI and GPIO, and neither clock speeds nor pads.
 */
#include "board.h"

#include "cortex-m/cortex-m.h"
#include "display.h"
#include "panel/ssd0323.h"
#include "semihosting/semihosting.h"
#include "spi.h"

enum {
    SYSCTL = 0x400fe000,
    SYSCTL_INTERRUPTS = SYSCTL + 0x50, /* raw */
    SYSCTL_CLOCK = SYSCTL + 0x60,
};

enum {
    CLOCK_MAIN_OFF = 1u << 0, /* switches the crystal off */
    CLOCK_SOURCE = 3u << 4,   /* 0: the crystal */
    CLOCK_CRYSTAL = 15u << 6, /* its frequency */
    CLOCK_CRYSTAL_8MHZ = 14u << 6,
    CLOCK_BYPASS = 1u << 11, /* run without PLL */
    CLOCK_PLL_NO_OUTPUT = 1u << 12,
    CLOCK_PLL_OFF = 1u << 13,
    CLOCK_DIVIDE = 1u << 22,
    CLOCK_DIVISOR = 15u << 23,
    CLOCK_DIVISOR_4 = 3u << 23, /* 200 MHz / 4 */
    INTERRUPT_PLL_LOCKED = 1u << 6,
    PLL_WAIT = 100000, /* polls; the PLL locks within 0.5 ms, 6,000 clocks of the internal oscillator */
    CRYSTAL_WAIT_MS = 10,
};

enum { CLOCK_FULL = 50000000, CLOCK_INTERNAL = 12000000 };

/* @return the core's clock. Goes on with the internal oscillator, 12 MHz, when the PLL does not lock. */
static uint32_t start_clock(void) {
    volatile uint32_t *clock = cortex_m_register(SYSCTL_CLOCK);
    const uint32_t internal = *clock;

    *clock = (internal | CLOCK_BYPASS) & ~(uint32_t)(CLOCK_DIVIDE | CLOCK_MAIN_OFF);
    cortex_m_delay(CRYSTAL_WAIT_MS, CLOCK_INTERNAL);
    *clock =
        (*clock & ~(uint32_t)(CLOCK_SOURCE | CLOCK_CRYSTAL | CLOCK_PLL_NO_OUTPUT | CLOCK_PLL_OFF)) | CLOCK_CRYSTAL_8MHZ;
    *clock = (*clock & ~(uint32_t)CLOCK_DIVISOR) | CLOCK_DIVISOR_4 | CLOCK_DIVIDE;
    for (int i = 0; i < PLL_WAIT; i++) {
        if (*cortex_m_register(SYSCTL_INTERRUPTS) & INTERRUPT_PLL_LOCKED) {
            *clock &= ~(uint32_t)CLOCK_BYPASS;
            return CLOCK_FULL;
        }
    }
    *clock = internal;
    return CLOCK_INTERNAL;
}

void board_init(void) {
    lm3s_spi_start(start_clock(), glint_panel_ssd0323.clock_max);
}

void board_write(const char *text) {
    semihosting_write(text);
}

void board_exit(int status) {
    cortex_m_exit(status);
}

void board_delay(uint32_t milliseconds) {
    cortex_m_delay(milliseconds, CLOCK_FULL);
}

void board_checkpoint(const char *name) {
    semihosting_checkpoint(name);
}

glint_status board_display_start(board_display *display) {
    static glint_panel panel = {.type = &glint_panel_ssd0323};

    panel.bus = board_panel_bus();
    return glint_display_start(&panel, display);
}
