/* SPDX-License-Identifier: MIT */
/*
 * The I2C master to the OLED: clock PB2, data PB3. Registers from the vendor's LM3S811 manual as its public drivers use
 * them; each byte is waited for.
 */
#include "i2c.h"

#include "board.h"
#include "cortex-m/cortex-m.h"
#include "panel/i2c.h"

enum { PANEL_ADDRESS = 0x3d };

enum {
    SYSCTL_GATES_1 = 0x400fe104,
    SYSCTL_GATES_2 = 0x400fe108,
    GATE_1_I2C = 1u << 12,
    GATE_2_PORT_B = 1u << 1,
};

enum { PORT_B = 0x40005000, PORT_ALTERNATE = 0x420, PORT_OPEN_DRAIN = 0x50c, PORT_DIGITAL = 0x51c };

enum { PIN_CLOCK = 1u << 2, PIN_DATA = 1u << 3 };

enum {
    I2C = 0x40020000,
    I2C_ADDRESS = I2C + 0x00,
    I2C_CONTROL = I2C + 0x04,
    I2C_DATA = I2C + 0x08,
    I2C_PERIOD = I2C + 0x0c,
    I2C_CONFIGURATION = I2C + 0x20,
};

enum { CONTROL_RUN = 1u << 0, CONTROL_START = 1u << 1, CONTROL_STOP = 1u << 2 };

/* Read from I2C_CONTROL. */
enum { STATUS_BUSY = 1u << 0, STATUS_ERROR = 1u << 1, STATUS_BUS_BUSY = 1u << 6 };

enum { CONFIGURATION_MASTER = 1u << 4 };

/* A bit takes 10 core clocks for each step of the period: 6 low, 4 high. */
enum { CLOCKS_A_STEP = 20 };

/* Polls of a few clocks each: several hundred microseconds, where a byte takes 25. */
enum { WAIT_POLLS = 20000 };

void lm3s_i2c_start(uint32_t core_hz, uint32_t bus_hz) {
    *cortex_m_register(SYSCTL_GATES_1) |= GATE_1_I2C;
    *cortex_m_register(SYSCTL_GATES_2) |= GATE_2_PORT_B;
    cortex_m_delay(1, core_hz); /* gates need some clocks to open */
    *cortex_m_register(PORT_B + PORT_ALTERNATE) |= PIN_CLOCK | PIN_DATA;
    *cortex_m_register(PORT_B + PORT_OPEN_DRAIN) |= PIN_CLOCK | PIN_DATA;
    *cortex_m_register(PORT_B + PORT_DIGITAL) |= PIN_CLOCK | PIN_DATA;
    *cortex_m_register(I2C_CONFIGURATION) = CONFIGURATION_MASTER;
    *cortex_m_register(I2C_PERIOD) = (core_hz + CLOCKS_A_STEP * bus_hz - 1) / (CLOCKS_A_STEP * bus_hz) - 1;
}

/* Waits until what is to be clear is. */
static glint_status wait_while(uint32_t busy) {
    for (int i = 0; i < WAIT_POLLS; i++) {
        const uint32_t status = *cortex_m_register(I2C_CONTROL);
        if (!(status & busy)) {
            return status & STATUS_ERROR ? GLINT_ERROR_BUS : GLINT_OK;
        }
    }
    return GLINT_ERROR_TIMEOUT;
}

static glint_status i2c_start(void *context, uint8_t address, uint8_t first) {
    (void)context;
    *cortex_m_register(I2C_ADDRESS) = (uint32_t)address << 1;
    *cortex_m_register(I2C_DATA) = first;
    *cortex_m_register(I2C_CONTROL) = CONTROL_RUN | CONTROL_START;
    return wait_while(STATUS_BUSY);
}

static glint_status i2c_write(void *context, const uint8_t *bytes, size_t count) {
    glint_status status = GLINT_OK;

    (void)context;
    for (size_t i = 0; i < count && !status; i++) {
        *cortex_m_register(I2C_DATA) = bytes[i];
        *cortex_m_register(I2C_CONTROL) = CONTROL_RUN;
        status = wait_while(STATUS_BUSY);
    }
    return status;
}

static glint_status i2c_stop(void *context) {
    (void)context;
    *cortex_m_register(I2C_CONTROL) = CONTROL_STOP;
    return wait_while(STATUS_BUSY | STATUS_BUS_BUSY);
}

static void delay(void *context, uint32_t milliseconds) {
    (void)context;
    board_delay(milliseconds);
}

static const glint_i2c panel_i2c = {.start = i2c_start, .write = i2c_write, .stop = i2c_stop, .address = PANEL_ADDRESS};

/* The panel is reset with the board, and glows by itself. */
static const glint_bus panel_bus = {.command = glint_i2c_command,
                                    .data = glint_i2c_data,
                                    .begin = glint_i2c_begin,
                                    .delay = delay,
                                    .context = (void *)(uintptr_t)&panel_i2c}; /* which they only read */

const glint_bus *board_panel_bus(void) {
    return &panel_bus;
}
