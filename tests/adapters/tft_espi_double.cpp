/* SPDX-License-Identifier: MIT */
#include <adapters/glint_tft_espi.h>
#include <string.h>

extern "C" {
#include "adapters.h"
}

/* A display that takes pixels only in a window, in a transaction. */
static struct {
    bool swaps, writes;
    int32_t left, top, width, height;
    uint32_t pushed;
    int complaints;
    uint8_t screen[ADAPTED_BYTES];
} double_of;

void TFT_eSPI::setSwapBytes(bool swap) {
    double_of.swaps = swap;
}

void TFT_eSPI::startWrite() {
    double_of.complaints += double_of.writes;
    double_of.writes = true;
}

void TFT_eSPI::setAddrWindow(int32_t x, int32_t y, int32_t w, int32_t h) {
    double_of.complaints += !double_of.writes || x < 0 || y < 0 || x + w > ADAPTED_WIDTH || y + h > ADAPTED_HEIGHT;
    double_of.left = x;
    double_of.top = y;
    double_of.width = w;
    double_of.height = h;
    double_of.pushed = 0;
}

/* Panels take the high byte first. */
void TFT_eSPI::pushPixels(const void *data, uint32_t len) {
    const uint8_t *from = static_cast<const uint8_t *>(data);

    for (uint32_t i = 0; i < len; i++, double_of.pushed++, from += 2) {
        const uint32_t x =
            static_cast<uint32_t>(double_of.left) + double_of.pushed % static_cast<uint32_t>(double_of.width);
        const uint32_t y =
            static_cast<uint32_t>(double_of.top) + double_of.pushed / static_cast<uint32_t>(double_of.width);
        uint8_t *const to = double_of.screen + 2 * (y * ADAPTED_WIDTH + x);

        to[0] = from[double_of.swaps ? 1 : 0];
        to[1] = from[double_of.swaps ? 0 : 1];
    }
}

void TFT_eSPI::endWrite() {
    double_of.complaints +=
        !double_of.writes || double_of.pushed != static_cast<uint32_t>(double_of.width * double_of.height);
    double_of.writes = false;
}

extern "C" void tft_espi_is_sent_the_scene(void) {
    const uint8_t *const expected = adapted_expected(&glint_format_rgb565_be);
    TFT_eSPI display;
    const glint_config config = adapted_config(&glint_format_rgb565, adapter_tft_espi_flush(display), 0);

    CHECK_EQUAL(adapted_draw(&config), GLINT_OK);
    CHECK_EQUAL(double_of.complaints, 0);
    CHECK(memcmp(double_of.screen, expected, 2 * ADAPTED_WIDTH * ADAPTED_HEIGHT) == 0);
}
