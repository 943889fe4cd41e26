/* SPDX-License-Identifier: MIT */
#ifndef WIRE_H
#define WIRE_H

#include <Arduino.h>

class TwoWire {
  public:
    void begin() {
    }
    void setClock(uint32_t) {
    }
    void beginTransmission(uint8_t address);
    size_t write(uint8_t byte);
    size_t write(const uint8_t *bytes, size_t count);
    /** @return 0; 1 when it was longer than the buffer, 2 when nobody has this address */
    uint8_t endTransmission();

  private:
    uint8_t buffer[32], to;
    size_t held, asked;
};

extern TwoWire Wire;

#endif
