/* SPDX-License-Identifier: MIT */
/* The emulator breaks the bus when it is told to (tests/pico/run.js): the firmware is not in on it. */
#include "faults.h"

#include "board.h"
#include "panel/st7789.h"
#include "pico/spi.h"

const glint_panel faults_panel = {.type = &glint_panel_st7789_240x240, .bus = &pico_spi_bus};

void faults_set(fault_kind kind) {
    static const char *const lines[] = {"bus: mended\n", "bus: stopped\n", "bus: slow\n", "bus: broken\n",
                                        "bus: reset\n"};

    board_write(lines[kind]);
}
