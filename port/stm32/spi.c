/* SPDX-License-Identifier: MIT */
#include "spi.h"

#include "cortex-m/cortex-m.h"

enum { CONTROL_1 = 0x00, STATUS = 0x08, DATA = 0x0c };

enum {
    CONTROL_MASTER = 1u << 2,
    CONTROL_DIVIDER_SHIFT = 3, /* the clock is divided by 2 to the power of this and 1 */
    CONTROL_ENABLE = 1u << 6,
    CONTROL_SOFTWARE_SELECT = 3u << 8,
    STATUS_TX_EMPTY = 1u << 1,
    STATUS_BUSY = 1u << 7,
};

/* Polls, each of several clocks: an oscillator takes at most some milliseconds, a byte at most 2,048 clocks. */
enum { POLLS = 50000 };

int stm32_wait(uintptr_t address, uint32_t bits, uint32_t wanted) {
    for (int i = 0; i < POLLS; i++) {
        if ((*cortex_m_register(address) & bits) == wanted) {
            return 1;
        }
    }
    return 0;
}

void stm32_spi_start(uintptr_t base, uint32_t clock_hz, uint32_t bus_hz) {
    uint32_t divider = 0;

    while (divider < 7 && clock_hz >> (divider + 1) > bus_hz) {
        divider++;
    }
    *cortex_m_register(base + CONTROL_1) =
        CONTROL_MASTER | CONTROL_SOFTWARE_SELECT | divider << CONTROL_DIVIDER_SHIFT | CONTROL_ENABLE;
}

static glint_status send_row(uintptr_t base, const uint8_t *bytes, size_t count) {
    for (size_t i = 0; i < count; i++) {
        if (!stm32_wait(base + STATUS, STATUS_TX_EMPTY, STATUS_TX_EMPTY)) {
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
    glint_status status = GLINT_OK;

    for (size_t row = 0; row < rows && status == GLINT_OK; row++) {
        status = send_row(base, bytes + row * stride, row_bytes);
    }
    if (status == GLINT_OK && !stm32_spi_is_idle(base)) {
        status = GLINT_ERROR_TIMEOUT;
    }
    (void)*cortex_m_register(base + DATA); /* what came back, and with the status the overrun it may have left */
    (void)*cortex_m_register(base + STATUS);
    return status;
}
