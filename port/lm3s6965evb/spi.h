/* SPDX-License-Identifier: MIT */
/** @file spi.h The OLED's bus on the LM3S6965 evaluation board. */
#ifndef GLINT_LM3S6965EVB_SPI_H
#define GLINT_LM3S6965EVB_SPI_H

#include <stdint.h>

/** Sets up SSI0 and its pins: from a core at core_hz, a bus of at most bus_hz. */
void lm3s_spi_start(uint32_t core_hz, uint32_t bus_hz);

#endif
