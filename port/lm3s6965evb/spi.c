/* SPDX-License-Identifier: MIT */
/*
 * SSI0 (Arm PL022) to the OLED: clock PA2, chip select PA3, data PA5, D/C PC7. PD0 selects the SD card on the same bus
 * and stays high. Pixels are sent from the interrupt while the core draws on.
 */
#include "spi.h"

#include "board.h"
#include "cortex-m/cortex-m.h"
#include "pl022/pl022.h"

enum {
    SYSCTL_GATES_1 = 0x400fe104,
    SYSCTL_GATES_2 = 0x400fe108,
    GATE_1_SSI0 = 1u << 4,
    GATE_2_PORTS_A_C_D = 1u << 0 | 1u << 2 | 1u << 3,
};

enum { PORT_A = 0x40004000, PORT_C = 0x40006000, PORT_D = 0x40007000 };

/* Offsets in a port. Bits 2 to 9 of a data address are a mask: a write there touches only these pins. */
enum { PORT_DIRECTION = 0x400, PORT_ALTERNATE = 0x420, PORT_STRENGTH_8MA = 0x508, PORT_DIGITAL = 0x51c };

enum { PIN_CLOCK = 1u << 2, PIN_SELECT = 1u << 3, PIN_OUT = 1u << 5, PIN_DATA = 1u << 7, PIN_CARD_SELECT = 1u << 0 };

enum { SSI = 0x40008000, INTERRUPT_SSI = 7 };

#define INTERRUPTS_ENABLE 0xe000e100u

static pl022 ssi = {.base = SSI};

static void interrupt(void) {
    pl022_interrupt(&ssi);
}

__attribute__((section(".vectors.interrupts"), used)) static void (*const interrupts[INTERRUPT_SSI + 1])(void) = {
    [INTERRUPT_SSI] = interrupt};

static void write_pin(uintptr_t port, uint32_t pin, uint32_t level) {
    *cortex_m_register(port + (pin << 2)) = level ? pin : 0;
}

static void output_pin(uintptr_t port, uint32_t pin) {
    *cortex_m_register(port + PORT_DIRECTION) |= pin;
    *cortex_m_register(port + PORT_STRENGTH_8MA) |= pin;
    *cortex_m_register(port + PORT_DIGITAL) |= pin;
    write_pin(port, pin, 1);
}

void lm3s_spi_start(uint32_t core_hz, uint32_t bus_hz) {
    *cortex_m_register(SYSCTL_GATES_1) |= GATE_1_SSI0;
    *cortex_m_register(SYSCTL_GATES_2) |= GATE_2_PORTS_A_C_D;
    cortex_m_delay(1, core_hz); /* gates need some clocks to open */
    output_pin(PORT_D, PIN_CARD_SELECT);
    output_pin(PORT_A, PIN_SELECT);
    output_pin(PORT_C, PIN_DATA);
    *cortex_m_register(PORT_A + PORT_ALTERNATE) |= PIN_CLOCK | PIN_OUT;
    *cortex_m_register(PORT_A + PORT_STRENGTH_8MA) |= PIN_CLOCK | PIN_OUT;
    *cortex_m_register(PORT_A + PORT_DIGITAL) |= PIN_CLOCK | PIN_OUT;
    pl022_start(&ssi, core_hz, bus_hz, PL022_MODE_2);
    *cortex_m_register(INTERRUPTS_ENABLE) = 1u << INTERRUPT_SSI;
}

/* What a transfer that was given up left behind leaves before the panel listens. */
static glint_status select(int is_data) {
    const glint_status status = pl022_finish(&ssi);

    if (!status) {
        write_pin(PORT_C, PIN_DATA, (uint32_t)is_data);
        write_pin(PORT_A, PIN_SELECT, 0);
    }
    return status;
}

/* Lets the panel go. */
static glint_status finish(glint_status status) {
    write_pin(PORT_A, PIN_SELECT, 1);
    return status;
}

static glint_status send(const uint8_t *bytes, size_t count, int is_data) {
    glint_status status = select(is_data);

    if (status) {
        return status;
    }
    status = pl022_send(&ssi, bytes, count);
    return finish(status ? status : pl022_finish(&ssi));
}

static glint_status command(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    return send(bytes, count, 0);
}

static glint_status data(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    return send(bytes, count, 1);
}

static glint_status begin(void *context, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    const glint_status status = select(1);

    (void)context;
    if (!status) {
        pl022_begin(&ssi, bytes, row_bytes, rows, stride);
    }
    return status;
}

static glint_status wait(void *context) {
    (void)context;
    return finish(pl022_wait(&ssi));
}

static void delay(void *context, uint32_t milliseconds) {
    (void)context;
    board_delay(milliseconds);
}

/* The panel is reset with the board, and glows by itself. */
static const glint_bus panel_bus = {.command = command, .data = data, .begin = begin, .wait = wait, .delay = delay};

const glint_bus *board_panel_bus(void) {
    return &panel_bus;
}
