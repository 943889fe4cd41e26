/* SPDX-License-Identifier: MIT */
#include "Wire.h"

#include <bus.h>

TwoWire Wire;

void TwoWire::beginTransmission(uint8_t address) {
    to = address;
    held = asked = 0;
}

size_t TwoWire::write(uint8_t byte) {
    return write(&byte, 1);
}

size_t TwoWire::write(const uint8_t *bytes, size_t count) {
    asked += count;
    for (size_t i = 0; i < count && held < sizeof buffer; i++)
        buffer[held++] = bytes[i];
    return count;
}

uint8_t TwoWire::endTransmission() {
    if (asked > sizeof buffer)
        return 1;
    if (to != 0x3c)
        return 2;
    if (held)
        bus_write(buffer[0] == 0x40 ? 'D' : 'C', buffer + 1, held - 1);
    return 0;
}
