/* SPDX-License-Identifier: MIT */
#ifndef ZEPHYR_DEVICE_H
#define ZEPHYR_DEVICE_H

#include <stdbool.h>

struct device;
extern const struct device zephyr_display_device;

#define DT_CHOSEN(name) name##_device
#define DEVICE_DT_GET(node) (&(node))

bool device_is_ready(const struct device *device);

#endif
