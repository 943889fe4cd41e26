/* SPDX-License-Identifier: MIT */
#include "glint_u8g2.h"

/* A tile of u8x8 is 8 pixels high and wide, a byte a column: a page of glint's tile is some of them side by side. */
static int draw_pages(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    u8x8_t *const display = context;

    for (int page = 0; page < height / 8; page++)
        if (!u8x8_DrawTile(display, (uint8_t)(x / 8), (uint8_t)(y / 8 + page), (uint8_t)(width / 8),
                           (uint8_t *)pixels + (size_t)page * 8 * stride))
            return 1;
    return 0;
}

glint_flush adapter_u8x8_flush(u8x8_t *display) {
    return (glint_flush){.begin = draw_pages, .context = display};
}
