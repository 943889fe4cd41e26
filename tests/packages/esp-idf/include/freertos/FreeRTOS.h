/* SPDX-License-Identifier: MIT */
#ifndef FREERTOS_H
#define FREERTOS_H

#include <stdint.h>

typedef int BaseType_t;
typedef uint32_t TickType_t;

enum { pdFALSE = 0, pdTRUE = 1 };
#define portMAX_DELAY ((TickType_t)0xffffffff)

#endif
