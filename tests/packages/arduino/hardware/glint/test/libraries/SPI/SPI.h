/* SPDX-License-Identifier: MIT */
#ifndef SPI_H
#define SPI_H

#include <Arduino.h>

enum { SPI_MODE0 = 0 };

class SPISettings {
  public:
    SPISettings(uint32_t, BitOrder, uint8_t) {
    }
};

class SPIClass {
  public:
    void begin() {
    }
    void beginTransaction(SPISettings) {
    }
    void endTransaction() {
    }
    uint8_t transfer(uint8_t byte);
    /** What comes back takes the place of what is sent. */
    void transfer(void *bytes, size_t count);
};

extern SPIClass SPI;

#endif
