/* SPDX-License-Identifier: MIT */
/**
 * @file spi.h
 * The SPI of STM32 parts (its registers are the same from F1 to F4), sending 8-bit frames as bus master, mode 0.
 * Polled: no emulator models its interrupt.
 */
#ifndef GLINT_STM32_SPI_H
#define GLINT_STM32_SPI_H

#include "panel/bus.h"

/** Sets the SPI at `base` up; the bus is never faster than bus_hz if a 256th of the peripheral's clock is not. */
void stm32_spi_start(uintptr_t base, uint32_t clock_hz, uint32_t bus_hz);

/** Waits until nothing is left of a transfer that was given up, at most a while. @return whether nothing is. */
int stm32_spi_is_idle(uintptr_t base);

/** Sends rows of bytes; returns when the last has left, or with GLINT_ERROR_TIMEOUT when the bus stands still at one or
 * takes far longer for all than its clock would. */
glint_status stm32_spi_send(uintptr_t base, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride);

/** Waits until all the bits are set in a register, at most a while. @return whether they are. */
int stm32_wait(uintptr_t address, uint32_t bits, uint32_t wanted);

#endif
