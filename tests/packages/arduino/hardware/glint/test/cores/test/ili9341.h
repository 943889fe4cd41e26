/* SPDX-License-Identifier: MIT */
/* An ILI9341 over the bus, for libraries that know panels. */
#ifndef TEST_ILI9341_H
#define TEST_ILI9341_H

#include <Arduino.h>
#include <bus.h>

static inline void ili9341_send(uint8_t command, const uint8_t *bytes, size_t count) {
    bus_write('C', &command, 1);
    bus_write('D', bytes, count);
}

static inline void ili9341_start() {
    static const uint8_t bits16 = 0x55;

    delay(120);
    ili9341_send(0x01, 0, 0); /* software reset */
    delay(120);
    ili9341_send(0x11, 0, 0); /* out of sleep */
    delay(120);
    ili9341_send(0x3a, &bits16, 1);
    ili9341_send(0x29, 0, 0); /* display on */
}

/** @param rotation 1: a quarter turn, which the sketches take */
static inline void ili9341_turn(uint8_t rotation) {
    const uint8_t order = rotation == 1 ? 0x28 : 0x48;

    ili9341_send(0x36, &order, 1);
}

static inline void ili9341_range(uint8_t command, int32_t first, int32_t count) {
    const int32_t last = first + count - 1;
    const uint8_t bytes[4] = {(uint8_t)(first >> 8), (uint8_t)first, (uint8_t)(last >> 8), (uint8_t)last};

    ili9341_send(command, bytes, 4);
}

static inline void ili9341_window(int32_t x, int32_t y, int32_t w, int32_t h) {
    ili9341_range(0x2a, x, w);
    ili9341_range(0x2b, y, h);
    ili9341_send(0x2c, 0, 0);
}

#endif
