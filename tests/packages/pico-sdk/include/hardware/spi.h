/* SPDX-License-Identifier: MIT */
#ifndef HARDWARE_SPI_H
#define HARDWARE_SPI_H

#include "pico/stdlib.h"

typedef struct spi_inst spi_inst_t;
typedef struct spi_hw {
    volatile uint32_t dr;
} spi_hw_t;

extern spi_inst_t *const spi0;

uint spi_init(spi_inst_t *spi, uint baudrate);
int spi_write_blocking(spi_inst_t *spi, const uint8_t *bytes, size_t count);
bool spi_is_busy(const spi_inst_t *spi);
uint spi_get_dreq(spi_inst_t *spi, bool is_tx);
spi_hw_t *spi_get_hw(spi_inst_t *spi);

#endif
