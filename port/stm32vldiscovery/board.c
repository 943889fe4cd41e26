/* SPDX-License-Identifier: MIT */
/*
 * STM32 value line discovery: STM32F100, Cortex-M3 at 24 MHz, 8 KB RAM, with an SSD1306 of 128x64 wired to SPI1: clock
 * PA5, data PA7, chip select PA4, D/C PC4, reset PC5. Registers from ST's reference manual RM0041 as its public headers
 * name them.
 */
#include "board.h"

#include "cortex-m/cortex-m.h"
#include "display.h"
#include "panel/ssd1306.h"
#include "semihosting/semihosting.h"
#include "stm32/spi.h"

enum { CLOCK_FULL = 24000000, CLOCK_INTERNAL = 8000000, SPI1 = 0x40013000 };

enum {
    RCC = 0x40021000,
    RCC_CONTROL = RCC + 0x00,
    RCC_CONFIGURATION = RCC + 0x04,
    RCC_APB2 = RCC + 0x18,
    CONTROL_CRYSTAL = 1u << 16,
    CONTROL_CRYSTAL_READY = 1u << 17,
    CONTROL_PLL = 1u << 24,
    CONTROL_PLL_READY = 1u << 25,
    CONFIGURATION_PLL_CRYSTAL_BY_3 = 1u << 16 | 1u << 18, /* 8 MHz x 3 */
    CONFIGURATION_FROM_PLL = 2u,
    CONFIGURATION_IS_PLL = 2u << 2,
    CONFIGURATION_SOURCE = 3u << 2,
    APB2_PORTS_A_C_SPI1 = 1u << 2 | 1u << 4 | 1u << 12,
};

enum { PORT_A = 0x40010800, PORT_C = 0x40011000 };
enum { PORT_CONFIGURATION_LOW = 0x00, PORT_SET_RESET = 0x10 };
enum { PIN_OUTPUT = 3, PIN_FUNCTION = 11 }; /* push-pull, 50 MHz */
enum { A_SELECT = 4, A_CLOCK = 5, A_DATA = 7, C_DATA_COMMAND = 4, C_RESET = 5 };

static void write_pin(uintptr_t port, unsigned pin, int high) {
    *cortex_m_register(port + PORT_SET_RESET) = 1u << (high ? pin : pin + 16);
}

static void use_pin(uintptr_t port, unsigned pin, uint32_t use) {
    volatile uint32_t *configuration = cortex_m_register(port + PORT_CONFIGURATION_LOW);

    *configuration = (*configuration & ~(15u << (4 * pin))) | use << (4 * pin);
}

/* @return the core's clock: the internal oscillator's where crystal or PLL does not come up. */
static uint32_t start_clock(void) {
    *cortex_m_register(RCC_CONTROL) |= CONTROL_CRYSTAL;
    if (!stm32_wait(RCC_CONTROL, CONTROL_CRYSTAL_READY, CONTROL_CRYSTAL_READY)) {
        return CLOCK_INTERNAL;
    }
    *cortex_m_register(RCC_CONFIGURATION) = CONFIGURATION_PLL_CRYSTAL_BY_3;
    *cortex_m_register(RCC_CONTROL) |= CONTROL_PLL;
    if (!stm32_wait(RCC_CONTROL, CONTROL_PLL_READY, CONTROL_PLL_READY)) {
        return CLOCK_INTERNAL;
    }
    *cortex_m_register(RCC_CONFIGURATION) = CONFIGURATION_PLL_CRYSTAL_BY_3 | CONFIGURATION_FROM_PLL;
    return stm32_wait(RCC_CONFIGURATION, CONFIGURATION_SOURCE, CONFIGURATION_IS_PLL) ? CLOCK_FULL : CLOCK_INTERNAL;
}

void board_init(void) {
    const uint32_t core_hz = start_clock();

    *cortex_m_register(RCC_APB2) |= APB2_PORTS_A_C_SPI1;
    (void)*cortex_m_register(RCC_APB2); /* gates need some clocks to open */
    write_pin(PORT_A, A_SELECT, 1);
    write_pin(PORT_C, C_RESET, 1);
    use_pin(PORT_A, A_SELECT, PIN_OUTPUT);
    use_pin(PORT_C, C_DATA_COMMAND, PIN_OUTPUT);
    use_pin(PORT_C, C_RESET, PIN_OUTPUT);
    use_pin(PORT_A, A_CLOCK, PIN_FUNCTION);
    use_pin(PORT_A, A_DATA, PIN_FUNCTION);
    stm32_spi_start(SPI1, core_hz, glint_panel_ssd1306.clock_max);
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

static glint_status send(int is_data, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    if (!stm32_spi_is_idle(SPI1)) {
        return GLINT_ERROR_TIMEOUT;
    }
    write_pin(PORT_C, C_DATA_COMMAND, is_data);
    write_pin(PORT_A, A_SELECT, 0);
    const glint_status status = stm32_spi_send(SPI1, bytes, row_bytes, rows, stride);
    write_pin(PORT_A, A_SELECT, 1);
    return status;
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
    write_pin(PORT_C, C_RESET, !active);
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
