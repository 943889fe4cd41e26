/* SPDX-License-Identifier: MIT */
/*
 * A port that compiles and does nothing: copy the directory and linker/template.ld, fill in what the comments ask for,
 * and add a few lines to port/boards.mk. docs/porting.md walks through it.
 */
#include "board.h"

#include "display.h"
#include "panel/ssd0323.h"

/* Clock after board_init, Hz. FILL IN. */
enum { CLOCK_HZ = 16000000 };

/* ---- The panel's bus: leave out (and return null from board_panel_bus) when the board has no panel; on I2C,
 * port/panel/i2c.h has the callbacks ---------------------------------------------------------------------------------
 */

static glint_status command(void *context, const uint8_t *bytes, size_t count) {
    /* FILL IN: wait (bounded) until the bus is idle, D/C low, chip select low, send, wait (bounded) until the last bit
     * has left, chip select high. */
    (void)context;
    (void)bytes;
    (void)count;
    return GLINT_OK;
}

static glint_status data(void *context, const uint8_t *bytes, size_t count) {
    /* FILL IN: as command, with D/C high. */
    (void)context;
    (void)bytes;
    (void)count;
    return GLINT_OK;
}

static glint_status begin(void *context, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    /* FILL IN: D/C high, chip select low, start to send every row: by DMA and return, or by polling. */
    (void)context;
    (void)bytes;
    (void)row_bytes;
    (void)rows;
    (void)stride;
    return GLINT_OK;
}

static glint_status wait(void *context) {
    /* FILL IN: wait (bounded) until what begin started is sent, chip select high. */
    (void)context;
    return GLINT_OK;
}

static void delay(void *context, uint32_t milliseconds) {
    (void)context;
    board_delay(milliseconds);
}

/* FILL IN reset and backlight when the board has these lines. */
static const glint_bus panel_bus = {.command = command, .data = data, .begin = begin, .wait = wait, .delay = delay};

const glint_bus *board_panel_bus(void) {
    return &panel_bus;
}

/* FILL IN the kind of panel, and how it is turned (port/panel/panel.h). */
glint_status board_display_start(board_display *display) {
    static const glint_panel panel = {.type = &glint_panel_ssd0323, .bus = &panel_bus};

    return glint_display_start(&panel, display);
}

/* ---- The board -----------------------------------------------------------------------------------------------------
 */

void board_init(void) {
    /* FILL IN: clocks (every wait bounded), pins, the bus at no more than the panel's clock_max. */
}

void board_write(const char *text) {
    /* FILL IN: a serial line, or semihosting_write of port/semihosting. */
    (void)text;
}

void board_exit(int status) {
    /* FILL IN: tell a debugger or emulator, if one listens (cortex_m_exit does). Does not return. */
    (void)status;
    for (;;) {
    }
}

void board_delay(uint32_t milliseconds) {
    /* FILL IN: any counter that runs at a known speed; this loop is as good as the compiler makes it. */
    for (volatile uint32_t turns = milliseconds * (CLOCK_HZ / 1000 / 8); turns > 0; turns--) {
    }
}

void board_checkpoint(const char *name) {
    /* FILL IN, to be tested in an emulator: semihosting_checkpoint of port/semihosting. */
    (void)name;
}
