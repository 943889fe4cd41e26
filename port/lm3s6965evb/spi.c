/* SPDX-License-Identifier: MIT */
/*
 * SSI0 (Arm PL022) to the OLED: clock PA2, chip select PA3, data PA5, D/C PC7. PD0 selects the SD card on the same bus
 * and stays high. Polled: the bytes of a tile leave while begin runs; begin returns when the last is on its way and
 * wait sees it out.
 */
#include "spi.h"

#include "board.h"
#include "cortex-m/cortex-m.h"

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

enum {
    SSI = 0x40008000,
    SSI_CONTROL_0 = SSI + 0x00,
    SSI_CONTROL_1 = SSI + 0x04,
    SSI_DATA = SSI + 0x08,
    SSI_STATUS = SSI + 0x0c,
    SSI_PRESCALE = SSI + 0x10,
    CONTROL_0_8_BIT_MODE_2 = 7u | 1u << 6, /* Motorola frames of 8 bits, clock idles high, sampled on its first edge */
    CONTROL_1_ENABLE = 1u << 1,
    STATUS_TX_NOT_FULL = 1u << 1,
    STATUS_RX_NOT_EMPTY = 1u << 2,
    STATUS_BUSY = 1u << 4,
};

/*
 * Polls before a wait gives up. A byte takes 8 bits / 3.5 MHz = 2.3 us, 115 clocks, and the FIFO holds 8: 920 clocks,
 * of which a poll takes at least 5.
 */
enum { WAIT_POLLS = 10000 };

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
    const uint32_t prescale = ((core_hz + bus_hz - 1) / bus_hz + 1) & ~1u; /* even, rounded up: never too fast */

    *cortex_m_register(SYSCTL_GATES_1) |= GATE_1_SSI0;
    *cortex_m_register(SYSCTL_GATES_2) |= GATE_2_PORTS_A_C_D;
    cortex_m_delay(1, core_hz); /* gates need some clocks to open */
    output_pin(PORT_D, PIN_CARD_SELECT);
    output_pin(PORT_A, PIN_SELECT);
    output_pin(PORT_C, PIN_DATA);
    *cortex_m_register(PORT_A + PORT_ALTERNATE) |= PIN_CLOCK | PIN_OUT;
    *cortex_m_register(PORT_A + PORT_STRENGTH_8MA) |= PIN_CLOCK | PIN_OUT;
    *cortex_m_register(PORT_A + PORT_DIGITAL) |= PIN_CLOCK | PIN_OUT;
    *cortex_m_register(SSI_CONTROL_1) = 0;
    *cortex_m_register(SSI_PRESCALE) = prescale;
    *cortex_m_register(SSI_CONTROL_0) = CONTROL_0_8_BIT_MODE_2;
    *cortex_m_register(SSI_CONTROL_1) = CONTROL_1_ENABLE;
}

static void drain(void) {
    for (int i = 0; i < WAIT_POLLS && (*cortex_m_register(SSI_STATUS) & STATUS_RX_NOT_EMPTY); i++) {
        (void)*cortex_m_register(SSI_DATA);
    }
}

static glint_bus_status wait_idle(void) {
    for (int i = 0; i < WAIT_POLLS; i++) {
        drain();
        if ((*cortex_m_register(SSI_STATUS) & STATUS_BUSY) == 0) {
            drain();
            return GLINT_BUS_OK;
        }
    }
    return GLINT_BUS_TIMEOUT;
}

/* Every byte sent brings one back; the receive FIFO is drained because QEMU's PL022 stops sending when it is full. */
static glint_bus_status send(const uint8_t *bytes, size_t count) {
    volatile uint32_t *status = cortex_m_register(SSI_STATUS);
    volatile uint32_t *data = cortex_m_register(SSI_DATA);

    for (size_t i = 0; i < count; i++) {
        int polls = WAIT_POLLS;
        while ((*status & STATUS_TX_NOT_FULL) == 0) {
            if (--polls == 0) {
                return GLINT_BUS_TIMEOUT;
            }
            drain();
        }
        *data = bytes[i];
        if (*status & STATUS_RX_NOT_EMPTY) {
            (void)*data;
        }
    }
    return GLINT_BUS_OK;
}

static glint_bus_status finish(glint_bus_status status) {
    const glint_bus_status idle = wait_idle();

    write_pin(PORT_A, PIN_SELECT, 1);
    return status ? status : idle;
}

static glint_bus_status begin(void *context, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    glint_bus_status status = GLINT_BUS_OK;

    (void)context;
    write_pin(PORT_C, PIN_DATA, 1);
    write_pin(PORT_A, PIN_SELECT, 0);
    for (size_t row = 0; row < rows && status == GLINT_BUS_OK; row++) {
        status = send(bytes + row * stride, row_bytes);
    }
    return status ? finish(status) : GLINT_BUS_OK;
}

static glint_bus_status wait(void *context) {
    (void)context;
    return finish(GLINT_BUS_OK);
}

static glint_bus_status data(void *context, const uint8_t *bytes, size_t count) {
    const glint_bus_status status = begin(context, bytes, count, 1, count);

    return status ? status : wait(context);
}

static glint_bus_status command(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    write_pin(PORT_C, PIN_DATA, 0);
    write_pin(PORT_A, PIN_SELECT, 0);
    return finish(send(bytes, count));
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
