/* SPDX-License-Identifier: MIT */
#ifndef ESP_HEAP_CAPS_H
#define ESP_HEAP_CAPS_H

#include "esp_err.h"

#define MALLOC_CAP_DMA (1 << 3)

void *heap_caps_malloc(size_t size, uint32_t caps);

#endif
