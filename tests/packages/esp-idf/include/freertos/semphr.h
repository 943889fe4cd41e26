/* SPDX-License-Identifier: MIT */
#ifndef SEMPHR_H
#define SEMPHR_H

#include "FreeRTOS.h"

typedef struct QueueDefinition *SemaphoreHandle_t;

SemaphoreHandle_t xSemaphoreCreateBinary(void);
BaseType_t xSemaphoreTake(SemaphoreHandle_t of, TickType_t ticks);
BaseType_t xSemaphoreGiveFromISR(SemaphoreHandle_t of, BaseType_t *woken);

#endif
