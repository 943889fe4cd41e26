/* SPDX-License-Identifier: MIT */
/**
 * @file glint_zephyr.h
 * Zephyr's display interface. Formats that agree: PIXEL_FORMAT_RGB_565 and glint_format_rgb565_be, RGB_888 and rgb888,
 * L_8 and grey8, MONO01 with SCREEN_INFO_MONO_VTILED and mono_pages (tiles as wide as the screen).
 */
#ifndef ADAPTER_ZEPHYR_H
#define ADAPTER_ZEPHYR_H

#include <glint.h>
#include <zephyr/drivers/display.h>

/** What tiles are sent to. */
typedef struct adapter_zephyr {
    const struct device *device;
    uint8_t bits; /**< Of a pixel: 1, 8, 16 or 24. */
} adapter_zephyr;

/** `display` must outlive the flush; errors are display_write's, in stats.flush_error. */
glint_flush adapter_zephyr_flush(const adapter_zephyr *display);

#endif
