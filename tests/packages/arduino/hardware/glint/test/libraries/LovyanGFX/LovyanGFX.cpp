/* SPDX-License-Identifier: MIT */
#define LGFX_AUTODETECT
#include "LovyanGFX.hpp"

#include <ili9341.h>

enum { ROWS = 64 };

/* Rows on their way: they are read when they have to have left, and by then nobody may have changed them. */
static const uint16_t *rows[ROWS];
static int32_t lengths[ROWS];
static int count;

bool LGFX::init() {
    ili9341_start();
    return true;
}

void LGFX::setRotation(uint_fast8_t rotation) {
    ili9341_turn((uint8_t)rotation);
}

void LGFX::startWrite(bool) {
}

void LGFX::setAddrWindow(int32_t x, int32_t y, int32_t w, int32_t h) {
    waitDMA();
    ili9341_window(x, y, w, h);
}

void LGFX::writePixelsDMA(const uint16_t *data, int32_t len, bool swap) {
    if (swap || count == ROWS)
        return; /* pixels are missing */
    rows[count] = data;
    lengths[count++] = len;
}

void LGFX::waitDMA() {
    for (int i = 0; i < count; i++)
        bus_write('D', (const uint8_t *)rows[i], 2 * (size_t)lengths[i]);
    count = 0;
}

void LGFX::endWrite() {
    waitDMA();
}
