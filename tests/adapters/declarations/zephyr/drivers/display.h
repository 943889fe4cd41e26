/* SPDX-License-Identifier: MIT */
/* Of Zephyr's display interface what adapter and sample use. */
#ifndef ZEPHYR_DRIVERS_DISPLAY_H
#define ZEPHYR_DRIVERS_DISPLAY_H

#include <stdbool.h>
#include <stdint.h>

struct device;

struct display_buffer_descriptor {
    uint32_t buf_size; /* bytes */
    uint16_t width, height;
    uint16_t pitch; /* pixels */
    bool frame_incomplete;
};

enum display_pixel_format { PIXEL_FORMAT_RGB_888 = 1, PIXEL_FORMAT_RGB_565 = 16, PIXEL_FORMAT_L_8 = 64 };

struct display_capabilities {
    uint16_t x_resolution, y_resolution;
    uint32_t supported_pixel_formats, screen_info;
    enum display_pixel_format current_pixel_format;
    int current_orientation;
};

void display_get_capabilities(const struct device *dev, struct display_capabilities *capabilities);
int display_blanking_off(const struct device *dev);
int display_write(const struct device *dev, const uint16_t x, const uint16_t y,
                  const struct display_buffer_descriptor *desc, const void *buf);

#endif
