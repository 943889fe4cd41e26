/* SPDX-License-Identifier: MIT */
/** @file spi.h SPI0 of the RP2040, fed by DMA. */
#ifndef GLINT_PICO_SPI_H
#define GLINT_PICO_SPI_H

#include "panel/bus.h"

/** Sets up pins, SPI0 and DMA; the bus is never faster than bus_hz. */
void pico_spi_start(uint32_t core_hz, uint32_t bus_hz);

extern const glint_bus pico_spi_bus;

#endif
