/* SPDX-License-Identifier: MIT */
#include "glint_zephyr.h"

static int write_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    const adapter_zephyr *const display = context;
    /* a stride in pixels; rows of a page share its bytes */
    const uint32_t pitch = (uint32_t)stride * 8 / display->bits;
    const struct display_buffer_descriptor tile = {.buf_size = (uint32_t)stride * (uint32_t)height,
                                                   .width = (uint16_t)width,
                                                   .height = (uint16_t)height,
                                                   .pitch = (uint16_t)pitch};

    return display_write(display->device, (uint16_t)x, (uint16_t)y, &tile, pixels);
}

glint_flush adapter_zephyr_flush(const adapter_zephyr *display) {
    return (glint_flush){.begin = write_tile, .context = (void *)display};
}
