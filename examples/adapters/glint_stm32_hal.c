/* SPDX-License-Identifier: MIT */
#include "glint_stm32_hal.h"

/* Milliseconds that a transfer may take, and bytes that the HAL counts in one. */
enum { PATIENCE = 200, MOST = 65535 };

static void choose(const adapter_stm32_hal *wires, int is_data) {
    HAL_GPIO_WritePin(wires->data_port, wires->data_pin, is_data ? GPIO_PIN_SET : GPIO_PIN_RESET);
    HAL_GPIO_WritePin(wires->select_port, wires->select_pin, GPIO_PIN_RESET);
}

static glint_status end(const adapter_stm32_hal *wires, HAL_StatusTypeDef status) {
    HAL_GPIO_WritePin(wires->select_port, wires->select_pin, GPIO_PIN_SET);
    return status == HAL_OK ? GLINT_OK : status == HAL_TIMEOUT ? GLINT_ERROR_TIMEOUT : GLINT_ERROR_BUS;
}

static glint_status send(const adapter_stm32_hal *wires, int is_data, const uint8_t *bytes, size_t count) {
    choose(wires, is_data);
    return end(wires, HAL_SPI_Transmit(wires->spi, (uint8_t *)bytes, (uint16_t)count, PATIENCE));
}

static glint_status command(void *context, const uint8_t *bytes, size_t count) {
    return send(context, 0, bytes, count);
}

static glint_status data(void *context, const uint8_t *bytes, size_t count) {
    return send(context, 1, bytes, count);
}

/* A core with a data cache has pixels there that memory has not yet: the DMA reads memory. */
static void write_back(const uint8_t *bytes, size_t count) {
#if defined(__DCACHE_PRESENT) && __DCACHE_PRESENT == 1U
    const uintptr_t line = (uintptr_t)bytes & ~(uintptr_t)31;

    SCB_CleanDCache_by_Addr((uint32_t *)line, (int32_t)((uintptr_t)bytes + count - line));
#else
    (void)bytes;
    (void)count;
#endif
}

/* Whole tiles lie in one piece. Of parts, as the screen's right edge makes them, the last row goes by DMA. */
static glint_status begin(void *context, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    const adapter_stm32_hal *const wires = context;
    HAL_StatusTypeDef status = HAL_OK;

    if (stride == row_bytes && rows * stride <= MOST) {
        row_bytes *= rows;
        rows = 1;
    }
    choose(wires, 1);
    for (; rows > 1 && status == HAL_OK; rows--, bytes += stride)
        status = HAL_SPI_Transmit(wires->spi, (uint8_t *)bytes, (uint16_t)row_bytes, PATIENCE);
    write_back(bytes, row_bytes);
    if (status == HAL_OK)
        status = HAL_SPI_Transmit_DMA(wires->spi, (uint8_t *)bytes, (uint16_t)row_bytes);
    return status == HAL_OK ? GLINT_OK : end(wires, status);
}

static glint_status wait(void *context) {
    const adapter_stm32_hal *const wires = context;
    const uint32_t start = HAL_GetTick();

    while (HAL_SPI_GetState(wires->spi) != HAL_SPI_STATE_READY)
        if (HAL_GetTick() - start > PATIENCE) {
            HAL_SPI_Abort(wires->spi);
            return end(wires, HAL_TIMEOUT);
        }
    return end(wires, HAL_SPI_GetError(wires->spi) == HAL_SPI_ERROR_NONE ? HAL_OK : HAL_ERROR);
}

static void delay(void *context, uint32_t milliseconds) {
    (void)context;
    HAL_Delay(milliseconds);
}

glint_bus adapter_stm32_hal_bus(adapter_stm32_hal *wires) {
    return (glint_bus){
        .command = command, .data = data, .begin = begin, .wait = wait, .delay = delay, .context = wires};
}
