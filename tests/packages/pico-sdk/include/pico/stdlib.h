/* SPDX-License-Identifier: MIT */
#ifndef PICO_STDLIB_H
#define PICO_STDLIB_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef unsigned int uint;

enum gpio_function { GPIO_FUNC_SPI = 1 };
enum { GPIO_OUT = 1 };

void gpio_init(uint gpio);
void gpio_set_dir(uint gpio, bool out);
void gpio_put(uint gpio, bool value);
void gpio_set_function(uint gpio, enum gpio_function function);
void sleep_ms(uint32_t milliseconds);

#endif
