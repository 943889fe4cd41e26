/* SPDX-License-Identifier: MIT */
/* Of TFT_eSPI 2.5 what the sketch calls, for an ILI9341. */
#ifndef TFT_ESPI_H
#define TFT_ESPI_H

#include <Arduino.h>

class TFT_eSPI {
  public:
    void init();
    void setRotation(uint8_t rotation);
    void startWrite();
    void setAddrWindow(int32_t x, int32_t y, int32_t w, int32_t h);
    void pushPixels(const void *data, uint32_t len);
    void endWrite();
};

#endif
