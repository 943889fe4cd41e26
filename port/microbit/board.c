/* SPDX-License-Identifier: MIT */
/* BBC micro:bit: nRF51822, Cortex-M0 at 16 MHz, 16 KB RAM. Runs from reset on its internal oscillator; no panel yet. */
#include "board.h"

#include "cortex-m/cortex-m.h"
#include "cortex-m/semihosting.h"

enum { CLOCK_HZ = 16000000 };

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
    return 0;
}

void board_checkpoint(const char *name) {
    cortex_m_checkpoint(name);
}
