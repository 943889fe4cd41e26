/* SPDX-License-Identifier: MIT */
/** @file spi.h The OLED's bus on the LM3S6965 evaluation board. */
#ifndef GLINT_LM3S6965EVB_SPI_H
#define GLINT_LM3S6965EVB_SPI_H

#include <stdint.h>

/** Sets up SSI0 and its pins; core_hz is the clock they divide. */
void lm3s_spi_start(uint32_t core_hz);

#endif
