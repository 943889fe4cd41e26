/* SPDX-License-Identifier: MIT */
/*
 * TI (Luminary) LM3S811 evaluation board: Cortex-M3 at 50 MHz, 8 KB of RAM, OLED on I2C. Clock and system control are
 * those of the LM3S6965, with a crystal of 6 MHz.
 */
#include "board.h"

#include "cortex-m/cortex-m.h"
#include "display.h"
#include "i2c.h"
#include "lm3s/clock.h"
#include "panel/i2c.h"
#include "panel/ssd0303.h"
#include "semihosting/semihosting.h"

void board_init(void) {
    lm3s_i2c_start(lm3s_start_clock(LM3S_CRYSTAL_6MHZ), GLINT_I2C_CLOCK_MAX);
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
    static glint_panel panel = {.type = &glint_panel_ssd0303};

    panel.bus = board_panel_bus();
    return glint_display_start(&panel, display);
}
