/* SPDX-License-Identifier: MIT */
/*
 * TI (Luminary) LM3S6965 evaluation board: Cortex-M3 at 50 MHz, OLED on SSI0. Register layout from the vendor's
 * LM3S6965 manual as its public drivers use it; QEMU confirms SSI and GPIO, and neither clock speeds nor pads.
 */
#include "board.h"

#include "cortex-m/cortex-m.h"
#include "display.h"
#include "lm3s/clock.h"
#include "panel/ssd0323.h"
#include "semihosting/semihosting.h"
#include "spi.h"

void board_init(void) {
    lm3s_spi_start(lm3s_start_clock(LM3S_CRYSTAL_8MHZ), glint_panel_ssd0323.clock_max);
}

void board_write(const char *text) {
    semihosting_write(text);
}

void board_exit(int status) {
    cortex_m_exit(status);
}

void board_delay(uint32_t milliseconds) {
    cortex_m_delay(milliseconds, LM3S_CLOCK_FULL);
}

void board_checkpoint(const char *name) {
    semihosting_checkpoint(name);
}

glint_status board_display_start(board_display *display) {
    static glint_panel panel = {.type = &glint_panel_ssd0323};

    panel.bus = board_panel_bus();
    return glint_display_start(&panel, display);
}
