/* SPDX-License-Identifier: MIT */
/*
 * The STM32's SPI on a bus that works, but slowly: each byte leaves after so many looks at the port. What takes as long
 * as the clock allows is sent; what takes far longer, or for ever, ends by a named error, within bounds.
 */
#include "harness.h"
#include "slow/cortex-m/cortex-m.h"
#include "stm32/spi.h"

enum { CONTROL_1 = 0x00, STATUS = 0x08, DATA = 0x0c, REGISTERS = 4, SPI = 0x40013000 };

enum { TX_EMPTY = 1u << 1, BUSY = 1u << 7, DIVIDER_SHIFT = 3 };

enum { ROW = 250, ROWS = 4, PORT_CLOCK = 1 << 20 };

static struct {
    uint32_t registers[REGISTERS];
    uint32_t byte_looks, looks_left; /* of each byte; until the last one has left */
    uint32_t looks, sent;
    uint32_t stands, status; /* the status, of a port that stands still */
} port;

volatile uint32_t *cortex_m_register(uintptr_t address) {
    const uintptr_t offset = address - SPI;

    if (offset == STATUS) {
        port.looks++;
        port.looks_left -= port.looks_left > 0;
        port.registers[STATUS / 4] = port.stands ? port.status : port.looks_left ? BUSY : TX_EMPTY;
    } else if (offset == DATA) {
        port.looks_left = port.byte_looks;
        port.sent++;
    }
    return &port.registers[offset / 4];
}

static glint_status send(uint32_t byte_looks) {
    static const uint8_t bytes[ROW * ROWS];

    port.byte_looks = byte_looks;
    port.looks_left = port.looks = port.sent = 0;
    return stm32_spi_send(SPI, bytes, ROW, ROWS, ROW);
}

/* As fast as an F405's, whose core runs at twice the port's clock and takes some 10 clocks for a look; and the slowest.
 */
static uint32_t looks_at_speed(uint32_t divider) {
    return 2u << divider;
}

static uint32_t most_looks(uint32_t divider) {
    return 8u << (divider + 1);
}

static void start(uint32_t divider) {
    stm32_spi_start(SPI, PORT_CLOCK, PORT_CLOCK >> (divider + 1));
    CHECK_EQUAL(port.registers[CONTROL_1] >> DIVIDER_SHIFT & 7, divider);
}

static void transfers_at_every_speed_end(void) {
    for (uint32_t divider = 0; divider < 8; divider++) {
        start(divider);
        CHECK_EQUAL(send(1), GLINT_OK);
        CHECK_EQUAL(send(looks_at_speed(divider)), GLINT_OK);
        CHECK_EQUAL(send(most_looks(divider)), GLINT_OK);
        CHECK_EQUAL(port.sent, ROW * ROWS + 1); /* and what came back is taken */
    }
}

static void a_slow_transfer_times_out(void) {
    for (uint32_t divider = 0; divider < 8; divider++) {
        start(divider);
        CHECK_EQUAL(send(100 * looks_at_speed(divider)), GLINT_ERROR_TIMEOUT);
        CHECK(port.sent < ROW * ROWS);
        CHECK_AT_MOST(port.looks, 100000 + 2 * ROW * ROWS * most_looks(divider));
        CHECK_EQUAL(send(looks_at_speed(divider)), GLINT_OK); /* mended */
    }
}

/* Waits end for a port that takes no byte, and for one that never sends the last it took; one that works again sends.
 */
static void a_port_that_stands_still_times_out(void) {
    static const uint32_t stuck[] = {0, BUSY, TX_EMPTY | BUSY};

    start(0);
    for (unsigned i = 0; i < TEST_COUNT(stuck); i++) {
        port.stands = 1;
        port.status = stuck[i];
        CHECK_EQUAL(send(1), GLINT_ERROR_TIMEOUT);
        CHECK_EQUAL(port.sent, (stuck[i] & TX_EMPTY ? ROW * ROWS : 0) + 1); /* and what came back is taken */
        CHECK(!stm32_spi_is_idle(SPI));
        port.stands = 0;
        CHECK_EQUAL(send(1), GLINT_OK);
        CHECK(stm32_spi_is_idle(SPI));
    }
}

int test_main(void (*write)(const char *text)) {
    static const test_case cases[] = {
        TEST_CASE(transfers_at_every_speed_end),
        TEST_CASE(a_slow_transfer_times_out),
        TEST_CASE(a_port_that_stands_still_times_out),
    };

    return test_run(write, cases, TEST_COUNT(cases));
}
