/* SPDX-License-Identifier: MIT */
/*
 * Netduino Plus 2: STM32F405, Cortex-M4F at 168 MHz, with an ST7789 of 240x320, used as 320x240, wired to SPI1: clock
 * PA5, data PA7, chip select PA4, D/C PC4, reset PC5, backlight PB0. Registers from ST's reference manual RM0090 as its
 * public headers name them.
 */
#include "board.h"

#include "cortex-m/cortex-m.h"
#include "display.h"
#include "panel/st7789.h"
#include "semihosting/semihosting.h"
#include "stm32/spi.h"

enum { CLOCK_FULL = 168000000, CLOCK_INTERNAL = 16000000, SPI1 = 0x40013000 };

enum {
    RCC = 0x40023800,
    RCC_CONTROL = RCC + 0x00,
    RCC_PLL = RCC + 0x04,
    RCC_CONFIGURATION = RCC + 0x08,
    RCC_PORTS = RCC + 0x30,
    RCC_APB2 = RCC + 0x44,
    CONTROL_CRYSTAL = 1u << 16,
    CONTROL_CRYSTAL_READY = 1u << 17,
    CONTROL_PLL = 1u << 24,
    CONTROL_PLL_READY = 1u << 25,
    PLL_25MHZ_TO_168MHZ = 25u | 336u << 6 | 0u << 16 | 1u << 22 | 7u << 24, /* / 25 x 336 / 2; from the crystal */
    CONFIGURATION_APB1_BY_4_APB2_BY_2 = 5u << 10 | 4u << 13,
    CONFIGURATION_FROM_PLL = 2u,
    CONFIGURATION_IS_PLL = 2u << 2,
    CONFIGURATION_SOURCE = 3u << 2,
    PORTS_A_B_C = 7u,
    APB2_SPI1 = 1u << 12,
    FLASH_ACCESS = 0x40023c00,
    FLASH_5_WAIT_STATES = 5u | 7u << 8, /* with prefetch and caches */
};

enum { PORT_A = 0x40020000, PORT_B = 0x40020400, PORT_C = 0x40020800 };
enum { PORT_MODE = 0x00, PORT_SPEED = 0x08, PORT_SET_RESET = 0x18, PORT_FUNCTION_LOW = 0x20 };
enum { MODE_OUTPUT = 1, MODE_FUNCTION = 2, FUNCTION_SPI1 = 5 };
enum { A_SELECT = 4, A_CLOCK = 5, A_DATA = 7, C_DATA_COMMAND = 4, C_RESET = 5, B_BACKLIGHT = 0 };

static uint32_t core_hz = CLOCK_INTERNAL;

static void write_pin(uintptr_t port, unsigned pin, int high) {
    *cortex_m_register(port + PORT_SET_RESET) = 1u << (high ? pin : pin + 16);
}

static void use_pin(uintptr_t port, unsigned pin, uint32_t mode) {
    volatile uint32_t *modes = cortex_m_register(port + PORT_MODE);

    *cortex_m_register(port + PORT_SPEED) |= 3u << (2 * pin);
    *modes = (*modes & ~(3u << (2 * pin))) | mode << (2 * pin);
}

/* @return the core's clock: the internal oscillator's where crystal or PLL does not come up. */
static uint32_t start_clock(void) {
    *cortex_m_register(RCC_CONTROL) |= CONTROL_CRYSTAL;
    if (!stm32_wait(RCC_CONTROL, CONTROL_CRYSTAL_READY, CONTROL_CRYSTAL_READY)) {
        return CLOCK_INTERNAL;
    }
    *cortex_m_register(RCC_PLL) = PLL_25MHZ_TO_168MHZ;
    *cortex_m_register(RCC_CONTROL) |= CONTROL_PLL;
    if (!stm32_wait(RCC_CONTROL, CONTROL_PLL_READY, CONTROL_PLL_READY)) {
        return CLOCK_INTERNAL;
    }
    *cortex_m_register(FLASH_ACCESS) = FLASH_5_WAIT_STATES;
    *cortex_m_register(RCC_CONFIGURATION) = CONFIGURATION_APB1_BY_4_APB2_BY_2 | CONFIGURATION_FROM_PLL;
    return stm32_wait(RCC_CONFIGURATION, CONFIGURATION_SOURCE, CONFIGURATION_IS_PLL) ? CLOCK_FULL : CLOCK_INTERNAL;
}

void board_init(void) {
    core_hz = start_clock();
    *cortex_m_register(RCC_PORTS) |= PORTS_A_B_C;
    *cortex_m_register(RCC_APB2) |= APB2_SPI1;
    (void)*cortex_m_register(RCC_APB2); /* gates need some clocks to open */
    write_pin(PORT_A, A_SELECT, 1);
    write_pin(PORT_C, C_RESET, 1);
    use_pin(PORT_A, A_SELECT, MODE_OUTPUT);
    use_pin(PORT_B, B_BACKLIGHT, MODE_OUTPUT);
    use_pin(PORT_C, C_DATA_COMMAND, MODE_OUTPUT);
    use_pin(PORT_C, C_RESET, MODE_OUTPUT);
    *cortex_m_register(PORT_A + PORT_FUNCTION_LOW) = FUNCTION_SPI1 << 4 * A_CLOCK | (uint32_t)FUNCTION_SPI1
                                                                                        << 4 * A_DATA;
    use_pin(PORT_A, A_CLOCK, MODE_FUNCTION);
    use_pin(PORT_A, A_DATA, MODE_FUNCTION);
    stm32_spi_start(SPI1, core_hz == CLOCK_FULL ? core_hz / 2 : core_hz, glint_panel_st7789_240x320.clock_max);
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

static void backlight(void *context, int on) {
    (void)context;
    write_pin(PORT_B, B_BACKLIGHT, on);
}

static void delay(void *context, uint32_t milliseconds) {
    (void)context;
    board_delay(milliseconds);
}

static const glint_bus panel_bus = {
    .command = command, .data = data, .begin = begin, .reset = reset, .backlight = backlight, .delay = delay};

const glint_bus *board_panel_bus(void) {
    return &panel_bus;
}

glint_status board_display_start(board_display *display) {
    static const glint_panel panel = {
        .type = &glint_panel_st7789_240x320, .bus = &panel_bus, .rotation = GLINT_PANEL_90};

    return glint_display_start(&panel, display);
}
