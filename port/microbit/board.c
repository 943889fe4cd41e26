/* SPDX-License-Identifier: MIT */
/*
 * BBC micro:bit: nRF51822, Cortex-M0, 16 KB RAM, with an SSD1306 of 128x64 at its edge connector: clock P13, data P15,
 * chip select P16, D/C P8, reset P12. The pins are driven by hand, as no emulator models this part's SPI. GPIO
 * registers from Nordic's nRF51 Series Reference Manual as its public headers name them.
 */
#include "board.h"

#include "cortex-m/cortex-m.h"
#include "display.h"
#include "panel/ssd1306.h"
#include "semihosting/semihosting.h"

enum { CLOCK_HZ = 16000000 };

enum { GPIO_SET = 0x50000508, GPIO_CLEAR = 0x5000050c, GPIO_OUTPUTS_SET = 0x50000518 };

enum { CLOCK = 1u << 23, DATA = 1u << 21, SELECT = 1u << 16, DATA_COMMAND = 1u << 18, RESET = 1u << 20 };

enum { CLOCK_START = 0x40000000, CLOCK_STARTED = 0x40000100, CRYSTAL_POLLS = 50000 };

static void write_pin(uint32_t pin, uint32_t high) {
    *cortex_m_register(high ? GPIO_SET : GPIO_CLEAR) = pin;
}

/* The crystal is more exact than the oscillator that the part starts with, and no faster: go on without it if it fails.
 */
void board_init(void) {
    *cortex_m_register(CLOCK_START) = 1;
    for (int i = 0; i < CRYSTAL_POLLS && *cortex_m_register(CLOCK_STARTED) == 0; i++) {
    }
    write_pin(SELECT | RESET, 1);
    write_pin(CLOCK, 0);
    *cortex_m_register(GPIO_OUTPUTS_SET) = CLOCK | DATA | SELECT | DATA_COMMAND | RESET;
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

void board_checkpoint(const char *name) {
    semihosting_checkpoint(name);
}

/* Most significant bit first; the panel takes it when the clock rises. At 16 MHz no pulse is too short for it. */
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
    static const glint_panel panel = {.type = &glint_panel_ssd1306, .bus = &panel_bus};

    return glint_display_start(&panel, display);
}
