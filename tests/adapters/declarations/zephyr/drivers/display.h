/* SPDX-License-Identifier: MIT */
/* Of Zephyr's display interface what the adapter uses. */
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

int display_write(const struct device *dev, const uint16_t x, const uint16_t y,
                  const struct display_buffer_descriptor *desc, const void *buf);

#endif
