/* SPDX-License-Identifier: MIT */
#include "TFT_eSPI.h"

#include <ili9341.h>

void TFT_eSPI::init() {
    ili9341_start();
}

void TFT_eSPI::setRotation(uint8_t rotation) {
    ili9341_turn(rotation);
}

void TFT_eSPI::startWrite() {
}

void TFT_eSPI::setAddrWindow(int32_t x, int32_t y, int32_t w, int32_t h) {
    ili9341_window(x, y, w, h);
}

void TFT_eSPI::pushPixels(const void *data, uint32_t len) {
    bus_write('D', (const uint8_t *)data, 2 * len);
}

void TFT_eSPI::endWrite() {
}
