/* SPDX-License-Identifier: MIT */
/*
 * Raspberry Pi Pico: RP2040, Cortex-M0+ at 125 MHz, an ST7789 of 240x240 on SPI0. Register layout from the RP2040
 * datasheet's chapters on clocks, PLL, resets and SIO as the emulator models them; what no emulator confirms is listed
 * in README.md.
 */
#include "board.h"

#include "cortex-m/cortex-m.h"
#include "display.h"
#include "panel/st7789.h"
#include "rp2040.h"
#include "semihosting/semihosting.h"
#include "spi.h"

enum { CRYSTAL_HZ = 12000000, RING_HZ = 6500000 };

enum { XOSC_CONTROL = 0x40024000, XOSC_STATUS = 0x40024004, XOSC_STARTUP = 0x4002400c };
enum {
    XOSC_ENABLE = 0xfab << 12 | 0xaa0, /* 1 to 15 MHz */
    XOSC_STARTUP_1_MS = 47,            /* times 256 crystal clocks */
};
#define XOSC_STABLE (1u << 31)

enum {
    CLOCK_REFERENCE = 0x40008030,
    CLOCK_REFERENCE_SELECTED = 0x40008038,
    CLOCK_SYSTEM = 0x4000803c,
    CLOCK_SYSTEM_SELECTED = 0x40008044,
    CLOCK_PERIPHERAL = 0x40008048,
    REFERENCE_CRYSTAL = 2,
    SYSTEM_PLL = 1, /* the auxiliary source, whose first choice is the PLL */
    PERIPHERAL_ENABLE = 1u << 11,
};

enum { PLL_CONTROL = 0x40028000, PLL_POWER = 0x40028004, PLL_FEEDBACK = 0x40028008, PLL_DIVIDERS = 0x4002800c };
enum {
    PLL_POWER_CORE_AND_VCO = 1u << 0 | 1u << 5,
    PLL_POWER_DIVIDERS = 1u << 3,
    PLL_TIMES_125 = 125,                /* 12 MHz x 125 = 1500 MHz */
    PLL_BY_6_BY_2 = 6u << 16 | 2u << 12 /* 1500 / 12 = 125 MHz */
};
#define PLL_LOCKED (1u << 31)

/* Polls, each of several clocks of 6.5 to 12 MHz: the crystal takes 1 ms, the PLL and the switches far less. */
enum { POLLS = 100000 };

/* @return whether the bits came up in time. */
static int wait_for(uintptr_t address, uint32_t bits) {
    for (int i = 0; i < POLLS; i++) {
        if ((*cortex_m_register(address) & bits) == bits) {
            return 1;
        }
    }
    return 0;
}

int rp2040_release(uint32_t peripherals) {
    *cortex_m_register(RP2040_RESETS + RP2040_CLEAR) = peripherals;
    return wait_for(RP2040_RESETS_DONE, peripherals);
}

static int start_crystal(void) {
    *cortex_m_register(XOSC_STARTUP) = XOSC_STARTUP_1_MS;
    *cortex_m_register(XOSC_CONTROL) = XOSC_ENABLE;
    if (!wait_for(XOSC_STATUS, XOSC_STABLE)) {
        return 0;
    }
    *cortex_m_register(CLOCK_REFERENCE) = REFERENCE_CRYSTAL;
    return wait_for(CLOCK_REFERENCE_SELECTED, 1u << REFERENCE_CRYSTAL);
}

static int start_pll(void) {
    if (!rp2040_release(RP2040_RESET_PLL)) {
        return 0;
    }
    *cortex_m_register(PLL_CONTROL) = 1; /* the reference is not divided */
    *cortex_m_register(PLL_FEEDBACK) = PLL_TIMES_125;
    *cortex_m_register(PLL_POWER + RP2040_CLEAR) = PLL_POWER_CORE_AND_VCO;
    if (!wait_for(PLL_CONTROL, PLL_LOCKED)) {
        return 0;
    }
    *cortex_m_register(PLL_DIVIDERS) = PLL_BY_6_BY_2;
    *cortex_m_register(PLL_POWER + RP2040_CLEAR) = PLL_POWER_DIVIDERS;
    *cortex_m_register(CLOCK_SYSTEM) = SYSTEM_PLL;
    return wait_for(CLOCK_SYSTEM_SELECTED, 1u << SYSTEM_PLL);
}

/* @return the core's clock: what comes up of PLL, crystal and the ring oscillator that it starts with. */
static uint32_t start_clock(void) {
    uint32_t hz = RING_HZ;

    if (start_crystal()) {
        hz = start_pll() ? RP2040_CLOCK_HZ : CRYSTAL_HZ;
    }
    *cortex_m_register(CLOCK_PERIPHERAL) = PERIPHERAL_ENABLE; /* from the system clock */
    return hz;
}

void board_init(void) {
    pico_spi_start(start_clock(), glint_panel_st7789_240x240.clock_max);
}

void board_write(const char *text) {
    semihosting_write(text);
}

void board_exit(int status) {
    cortex_m_exit(status);
}

void board_delay(uint32_t milliseconds) {
    cortex_m_delay(milliseconds, RP2040_CLOCK_HZ);
}

void board_checkpoint(const char *name) {
    semihosting_checkpoint(name);
}

glint_status board_display_start(board_display *display) {
    static const glint_panel panel = {.type = &glint_panel_st7789_240x240, .bus = &pico_spi_bus};

    return glint_display_start(&panel, display);
}

const glint_bus *board_panel_bus(void) {
    return &pico_spi_bus;
}
