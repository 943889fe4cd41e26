/* SPDX-License-Identifier: MIT */
#include "glint_tft_espi.h"

static int push_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    TFT_eSPI &display = *static_cast<TFT_eSPI *>(context);

    display.startWrite();
    display.setAddrWindow(x, y, width, height);
    for (int row = 0; row < height; row++)
        display.pushPixels(static_cast<const uint8_t *>(pixels) + static_cast<size_t>(row) * stride,
                           static_cast<uint32_t>(width));
    display.endWrite();
    return 0;
}

glint_flush adapter_tft_espi_flush(TFT_eSPI &display) {
    display.setSwapBytes(true); /* pixels are numbers of the core's byte order */
    return {push_tile, nullptr, &display};
}
