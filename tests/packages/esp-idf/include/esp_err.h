/* SPDX-License-Identifier: MIT */
#ifndef ESP_ERR_H
#define ESP_ERR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef int esp_err_t;

enum { ESP_OK = 0, ESP_ERR_INVALID_SIZE = 0x104 };

void esp_failed(const char *call);

#define ESP_ERROR_CHECK(call)  \
    do {                       \
        if ((call) != ESP_OK)  \
            esp_failed(#call); \
    } while (0)

#endif
