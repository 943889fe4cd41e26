/* SPDX-License-Identifier: MIT */
/**
 * @file glint_stm32_hal.h
 * The bus to a panel (port/panel/bus.h) over ST's HAL, from STM32F0 to H7: the DMA sends a tile while the core draws
 * the next one. STM32CubeMX makes main.h, and starts SPI and pins.
 */
#ifndef ADAPTER_STM32_HAL_H
#define ADAPTER_STM32_HAL_H

#include <main.h>
#include <panel/bus.h>

/** An SPI that sends 8 bits at a time, its DMA stream and interrupt enabled, and two pins that are outputs. */
typedef struct adapter_stm32_hal {
    SPI_HandleTypeDef *spi;
    GPIO_TypeDef *select_port, *data_port; /**< Of chip select and of D/C. */
    uint16_t select_pin, data_pin;         /**< GPIO_PIN_4, say. */
} adapter_stm32_hal;

/** `wires` must outlive the bus. Reset and backlight are the caller's to add. */
glint_bus adapter_stm32_hal_bus(adapter_stm32_hal *wires);

#endif
