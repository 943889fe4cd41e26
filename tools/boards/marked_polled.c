/* SPDX-License-Identifier: MIT */
/*
 * Marks that leave out what a polled bus takes of the core, which waits for the bus all that while. What is sent before
 * the first frame counts as part of that one.
 */
#include "../cycles/marks.h"
#include "stm32/spi.h"

glint_status __real_stm32_spi_send(uintptr_t base, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride);
glint_status __wrap_stm32_spi_send(uintptr_t base, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride);

glint_status __wrap_stm32_spi_send(uintptr_t base, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    CYCLES_STOP();
    const glint_status status = __real_stm32_spi_send(base, bytes, row_bytes, rows, stride);
    CYCLES_START();
    return status;
}
