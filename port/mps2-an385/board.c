/* SPDX-License-Identifier: MIT */
/*
 * Arm MPS2 with the AN385 image: Cortex-M3 at 25 MHz, 4 MB RAM. Room for what needs more than a small board has;
 * ARMv6-M code runs here too, and so does the Cortex-M0 build of everything. An ILI9341 of 320x240 as it lies on the
 * LCD's port.
 */
#include "board.h"

#include "cortex-m/cortex-m.h"
#include "display.h"
#include "lcd.h"
#include "panel/ili9341.h"
#include "semihosting/semihosting.h"

enum { CLOCK_HZ = 25000000 };

void board_init(void) {
}

void board_write(const char *text) {
    semihosting_write(text);
}

void board_exit(int status) {
    cortex_m_exit(status);
}

void board_delay(uint32_t milliseconds) {
    cortex_m_delay(milliseconds, CLOCK_HZ);
}

const glint_bus *board_panel_bus(void) {
    mps2_lcd_start(CLOCK_HZ, glint_panel_ili9341.clock_max);
    return &mps2_lcd_bus;
}

glint_status board_display_start(board_display *display) {
    static const glint_panel panel = {.type = &glint_panel_ili9341, .bus = &mps2_lcd_bus, .rotation = GLINT_PANEL_90};

    board_panel_bus();
    return glint_display_start(&panel, display);
}

void board_checkpoint(const char *name) {
    semihosting_checkpoint(name);
}
