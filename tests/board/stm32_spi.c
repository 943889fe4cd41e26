/* SPDX-License-Identifier: MIT */
/* The STM32's SPI against registers in memory that stand still: a transfer that never ends is a named error. */
#include "harness.h"
#include "stm32/spi.h"

enum { CONTROL_1, STATUS = 2, DATA, REGISTERS };

enum { TX_EMPTY = 1u << 1, BUSY = 1u << 7 };

static uint32_t registers[REGISTERS];

static glint_status send(uint32_t status) {
    static const uint8_t bytes[2][4] = {{1, 2, 99, 99}, {3, 4, 99, 99}};

    registers[STATUS] = status;
    registers[DATA] = 0;
    return stm32_spi_send((uintptr_t)registers, bytes[0], 2, 2, sizeof bytes[0]);
}

static void sound_transfers_end(void) {
    CHECK_EQUAL(send(TX_EMPTY), GLINT_OK);
    CHECK_EQUAL(registers[DATA], 4);
    CHECK(stm32_spi_is_idle((uintptr_t)registers));
}

static void a_port_that_takes_no_byte_times_out(void) {
    CHECK_EQUAL(send(0), GLINT_ERROR_TIMEOUT);
    CHECK_EQUAL(registers[DATA], 0);
    CHECK(!stm32_spi_is_idle((uintptr_t)registers));
}

static void a_port_that_stays_busy_times_out(void) {
    CHECK_EQUAL(send(TX_EMPTY | BUSY), GLINT_ERROR_TIMEOUT);
    CHECK_EQUAL(registers[DATA], 4);
    CHECK(!stm32_spi_is_idle((uintptr_t)registers));
}

static void a_port_that_works_again_sends(void) {
    CHECK_EQUAL(send(BUSY), GLINT_ERROR_TIMEOUT);
    CHECK_EQUAL(send(TX_EMPTY), GLINT_OK);
    CHECK_EQUAL(registers[DATA], 4);
}

int test_main(void (*write)(const char *text)) {
    static const test_case cases[] = {
        TEST_CASE(sound_transfers_end),
        TEST_CASE(a_port_that_takes_no_byte_times_out),
        TEST_CASE(a_port_that_stays_busy_times_out),
        TEST_CASE(a_port_that_works_again_sends),
    };

    return test_run(write, cases, TEST_COUNT(cases));
}
