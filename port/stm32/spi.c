/* SPDX-License-Identifier: MIT */
#include "spi.h"

#include "cortex-m/cortex-m.h"

enum { CONTROL_1 = 0x00, STATUS = 0x08, DATA = 0x0c };

enum {
    CONTROL_MASTER = 1u << 2,
    CONTROL_DIVIDER_SHIFT = 3, /* the clock is divided by 2 to the power of this and 1 */
    CONTROL_DIVIDER_MASK = 7u,
    CONTROL_ENABLE = 1u << 6,
    CONTROL_SOFTWARE_SELECT = 3u << 8,
    STATUS_TX_EMPTY = 1u << 1,
    STATUS_BUSY = 1u << 7,
};

/* Polls, each of several clocks: an oscillator takes at most some milliseconds, a byte at most 2,048 clocks. */
enum { POLLS = 50000 };

/*
 * Polls for a byte of a transfer as a whole, times the divider: twice what it can take. It takes 8 clocks of the bus;
 * the core's clock is at most 4 times the port's, and a poll takes at least 4 of it.
 */
enum { BYTE_POLLS = 16 };

/* Waits for at most POLLS, and no longer than there is patience, which it takes from. */
static int wait_patiently(uintptr_t address, uint32_t bits, uint32_t wanted, uint32_t *patience) {
    for (int i = 0; i < POLLS && *patience; i++, --*patience) {
        if ((*cortex_m_register(address) & bits) == wanted) {
            return 1;
        }
    }
    return 0;
}

int stm32_wait(uintptr_t address, uint32_t bits, uint32_t wanted) {
    uint32_t patience = POLLS;

    return wait_patiently(address, bits, wanted, &patience);
}

void stm32_spi_start(uintptr_t base, uint32_t clock_hz, uint32_t bus_hz) {
    uint32_t divider = 0;

    while (divider < 7 && clock_hz >> (divider + 1) > bus_hz) {
        divider++;
    }
    *cortex_m_register(base + CONTROL_1) =
        CONTROL_MASTER | CONTROL_SOFTWARE_SELECT | divider << CONTROL_DIVIDER_SHIFT | CONTROL_ENABLE;
}

/* A bus that is slow at every byte must not take as long as all of them may, each for itself. */
static uint32_t patience_for(uintptr_t base, size_t bytes) {
    const uint32_t divider = *cortex_m_register(base + CONTROL_1) >> CONTROL_DIVIDER_SHIFT & CONTROL_DIVIDER_MASK;

    return POLLS + (uint32_t)bytes * ((uint32_t)BYTE_POLLS << (divider + 1));
}

static glint_status send_row(uintptr_t base, const uint8_t *bytes, size_t count, uint32_t *patience) {
    for (size_t i = 0; i < count; i++) {
        if (!wait_patiently(base + STATUS, STATUS_TX_EMPTY, STATUS_TX_EMPTY, patience)) {
            return GLINT_ERROR_TIMEOUT;
        }
        *cortex_m_register(base + DATA) = bytes[i];
    }
    return GLINT_OK;
}

int stm32_spi_is_idle(uintptr_t base) {
    return stm32_wait(base + STATUS, STATUS_TX_EMPTY, STATUS_TX_EMPTY) && stm32_wait(base + STATUS, STATUS_BUSY, 0);
}

glint_status stm32_spi_send(uintptr_t base, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    uint32_t patience = patience_for(base, row_bytes * rows);
    glint_status status = GLINT_OK;

    for (size_t row = 0; row < rows && status == GLINT_OK; row++) {
        status = send_row(base, bytes + row * stride, row_bytes, &patience);
    }
    if (status == GLINT_OK && !stm32_spi_is_idle(base)) {
        status = GLINT_ERROR_TIMEOUT;
    }
    (void)*cortex_m_register(base + DATA); /* what came back, and with the status the overrun it may have left */
    (void)*cortex_m_register(base + STATUS);
    return status;
}
