/* SPDX-License-Identifier: MIT */
/*
 * SiFive HiFive1: FE310, RV32IMAC, 16 KB of RAM, with an SH1106 of 128x64 at its headers: clock D13, data D11, chip
 * select D10, D/C D9, reset D8. The pins are driven by hand, as no emulator models this part's SPI. Registers from
 * SiFive's FE310 manual as its public headers name them.
 */
#include "board.h"

#include "display.h"
#include "panel/sh1106.h"
#include "riscv/riscv.h"
#include "semihosting/semihosting.h"

enum { GPIO = 0x10012000, GPIO_OUTPUTS = GPIO + 0x08, GPIO_LEVELS = GPIO + 0x0c };

enum { RESET = 1u << 0, DATA_COMMAND = 1u << 1, SELECT = 1u << 2, DATA = 1u << 3, CLOCK = 1u << 5 };

/* The core's timer, low half; 32768 Hz, from the clock that stays on. */
enum { TIME = 0x0200bff8, TICKS_A_MILLISECOND = 33 };

static void write_pin(uint32_t pin, uint32_t high) {
    volatile uint32_t *levels = riscv_register(GPIO_LEVELS);

    *levels = high ? *levels | pin : *levels & ~pin;
}

/* The part runs on from the oscillator that it starts with, at 14 MHz or so. */
void board_init(void) {
    *riscv_register(GPIO_LEVELS) = SELECT | RESET;
    *riscv_register(GPIO_OUTPUTS) = CLOCK | DATA | SELECT | DATA_COMMAND | RESET;
}

void board_write(const char *text) {
    semihosting_write(text);
}

void board_exit(int status) {
    riscv_exit(status);
}

void board_delay(uint32_t milliseconds) {
    const volatile uint32_t *time = riscv_register(TIME);
    const uint32_t start = *time;

    while (*time - start <= milliseconds * TICKS_A_MILLISECOND) {
    }
}

void board_checkpoint(const char *name) {
    semihosting_checkpoint(name);
}

/* Most significant bit first; the panel takes it when the clock rises. No pulse is too short for it at this speed. */
static void send_byte(uint32_t byte) {
    for (uint32_t bit = 0x80; bit; bit >>= 1) {
        write_pin(DATA, byte & bit);
        write_pin(CLOCK, 1);
        write_pin(CLOCK, 0);
    }
}

static glint_status send(uint32_t is_data, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    write_pin(DATA_COMMAND, is_data);
    write_pin(SELECT, 0);
    for (size_t row = 0; row < rows; row++) {
        for (size_t i = 0; i < row_bytes; i++) {
            send_byte(bytes[row * stride + i]);
        }
    }
    write_pin(SELECT, 1);
    return GLINT_OK;
}

static glint_status command(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    return send(0, bytes, count, 1, count);
}

static glint_status data(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    return send(1, bytes, count, 1, count);
}

static glint_status begin(void *context, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    (void)context;
    return send(1, bytes, row_bytes, rows, stride);
}

static void reset(void *context, int active) {
    (void)context;
    write_pin(RESET, !active);
}

static void delay(void *context, uint32_t milliseconds) {
    (void)context;
    board_delay(milliseconds);
}

static const glint_bus panel_bus = {.command = command, .data = data, .begin = begin, .reset = reset, .delay = delay};

const glint_bus *board_panel_bus(void) {
    return &panel_bus;
}

glint_status board_display_start(board_display *display) {
    static const glint_panel panel = {.type = &glint_panel_sh1106, .bus = &panel_bus};

    return glint_display_start(&panel, display);
}
