/* SPDX-License-Identifier: MIT */
#include "pl022.h"

#include "cortex-m/cortex-m.h"

enum {
    CONTROL_0 = 0x00,
    CONTROL_1 = 0x04,
    DATA = 0x08,
    STATUS = 0x0c,
    PRESCALE = 0x10,
    INTERRUPT_MASK = 0x14,
    CONTROL_0_8_BITS = 7u,
    CONTROL_1_ENABLE = 1u << 1,
    STATUS_TX_NOT_FULL = 1u << 1,
    STATUS_RX_NOT_EMPTY = 1u << 2,
    STATUS_BUSY = 1u << 4,
    INTERRUPT_TX_HALF_EMPTY = 1u << 3,
};

enum { FIFO = 8 };

/*
 * Polls before a wait for one byte or for the FIFO to run empty gives up. At 1 MHz on a core of 100 MHz a byte takes
 * 800 clocks and the FIFO 6,400, of which a poll takes at least 5.
 */
enum { WAIT_POLLS = 20000 };

static volatile uint32_t *at(const pl022 *port, uintptr_t offset) {
    return cortex_m_register(port->base + offset);
}

void pl022_start(const pl022 *port, uint32_t clock_hz, uint32_t bus_hz, pl022_mode mode) {
    *at(port, CONTROL_1) = 0;
    *at(port, PRESCALE) = ((clock_hz + bus_hz - 1) / bus_hz + 1) & ~1u; /* even, rounded up: never too fast */
    *at(port, CONTROL_0) = CONTROL_0_8_BITS | (uint32_t)mode;
    *at(port, INTERRUPT_MASK) = 0;
    *at(port, CONTROL_1) = CONTROL_1_ENABLE;
}

/* Every byte sent brings one back. QEMU's model stops sending when nobody takes them. */
static void drain(const pl022 *port) {
    for (int i = 0; i < FIFO && (*at(port, STATUS) & STATUS_RX_NOT_EMPTY); i++) {
        (void)*at(port, DATA);
    }
}

glint_status pl022_finish(const pl022 *port) {
    for (int i = 0; i < WAIT_POLLS; i++) {
        drain(port);
        if ((*at(port, STATUS) & STATUS_BUSY) == 0) {
            drain(port);
            return GLINT_OK;
        }
    }
    return GLINT_ERROR_TIMEOUT;
}

glint_status pl022_send(const pl022 *port, const uint8_t *bytes, size_t count) {
    for (size_t i = 0; i < count; i++) {
        int polls = WAIT_POLLS;
        while ((*at(port, STATUS) & STATUS_TX_NOT_FULL) == 0) {
            if (--polls == 0) {
                return GLINT_ERROR_TIMEOUT;
            }
            drain(port);
        }
        *at(port, DATA) = bytes[i];
        drain(port);
    }
    return GLINT_OK;
}

void pl022_begin(pl022 *port, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    port->next = bytes;
    port->row_left = port->row_bytes = row_bytes;
    port->gap = stride - row_bytes;
    port->rows_left = row_bytes ? rows : 0;
    *at(port, INTERRUPT_MASK) = INTERRUPT_TX_HALF_EMPTY;
}

static uint8_t take_byte(pl022 *port) {
    const uint8_t byte = *port->next;

    port->next++;
    if (--port->row_left == 0) {
        port->next += port->gap;
        port->row_left = port->row_bytes;
        port->rows_left--;
    }
    return byte;
}

void pl022_interrupt(pl022 *port) {
    drain(port);
    for (int i = 0; i < FIFO && port->rows_left && (*at(port, STATUS) & STATUS_TX_NOT_FULL); i++) {
        *at(port, DATA) = take_byte(port);
    }
    if (port->rows_left == 0) {
        *at(port, INTERRUPT_MASK) = 0;
    }
}

/* Every half FIFO that leaves gives the rest another while. */
glint_status pl022_wait(pl022 *port) {
    const uint8_t *seen = port->next;
    int polls = WAIT_POLLS;

    while (port->rows_left && --polls) {
        if (port->next != seen) {
            seen = port->next;
            polls = WAIT_POLLS;
        }
    }
    *at(port, INTERRUPT_MASK) = 0;
    port->rows_left = 0;
    return polls ? pl022_finish(port) : GLINT_ERROR_TIMEOUT;
}
