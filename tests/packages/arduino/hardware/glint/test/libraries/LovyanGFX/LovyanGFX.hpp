/* SPDX-License-Identifier: MIT */
/* Of LovyanGFX 1.2 what the sketch calls, for an ILI9341. */
#ifndef LOVYANGFX_HPP
#define LOVYANGFX_HPP

#ifndef LGFX_AUTODETECT
#error "LGFX is a class of what finds boards by itself"
#endif

#include <Arduino.h>

class LGFX {
  public:
    bool init();
    void setRotation(uint_fast8_t rotation);
    void startWrite(bool transaction = true);
    void setAddrWindow(int32_t x, int32_t y, int32_t w, int32_t h);
    void writePixelsDMA(const uint16_t *data, int32_t len, bool swap);
    void waitDMA();
    void endWrite();
};

#endif
