/* SPDX-License-Identifier: MIT */
#include "SPI.h"

#include <bus.h>

SPIClass SPI;

uint8_t SPIClass::transfer(uint8_t byte) {
    bus_write(bus_data_is_high() ? 'D' : 'C', &byte, 1);
    return 0xff;
}

void SPIClass::transfer(void *bytes, size_t count) {
    bus_write(bus_data_is_high() ? 'D' : 'C', (const uint8_t *)bytes, count);
    for (size_t i = 0; i < count; i++)
        ((uint8_t *)bytes)[i] = 0xff;
}
