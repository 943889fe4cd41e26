/* SPDX-License-Identifier: MIT */
/* ST's HAL: an SPI whose DMA reads what the cache has written back, when it is asked whether it has ended. */
#include "adapters.h"

#include <adapters/glint_stm32_hal.h>
#include <string.h>

struct GPIO_TypeDef {
    int levels;
};

struct SPI_HandleTypeDef {
    GPIO_TypeDef port;
    uint8_t sent[256]; /* with a byte before each transfer: D/C's level, and 2 by DMA */
    size_t count, pending;
    const uint8_t *from, *cleaned;
    size_t cleaned_bytes;
    int hangs, fails, aborted;
    uint32_t ticks;
};

static SPI_HandleTypeDef spi;

static void take(const uint8_t *bytes, size_t count, int by) {
    CHECK_EQUAL(spi.port.levels & GPIO_PIN_4, 0);
    CHECK(spi.count + count + 1 <= sizeof spi.sent);
    spi.sent[spi.count++] = (uint8_t)(by + (spi.port.levels & GPIO_PIN_5 ? 1 : 0));
    memcpy(spi.sent + spi.count, bytes, count);
    spi.count += count;
}

void HAL_GPIO_WritePin(GPIO_TypeDef *GPIOx, uint16_t GPIO_Pin, GPIO_PinState PinState) {
    CHECK_EQUAL(spi.pending == 0 || spi.aborted, 1); /* no pin moves while bytes leave */
    GPIOx->levels = PinState == GPIO_PIN_SET ? GPIOx->levels | GPIO_Pin : GPIOx->levels & ~GPIO_Pin;
}

HAL_StatusTypeDef HAL_SPI_Transmit(SPI_HandleTypeDef *hspi, uint8_t *pData, uint16_t Size, uint32_t Timeout) {
    CHECK(hspi == &spi && Timeout > 0);
    take(pData, Size, 0);
    return spi.fails ? HAL_ERROR : HAL_OK;
}

/* NOLINTNEXTLINE(readability-non-const-parameter): as ST declares it */
HAL_StatusTypeDef HAL_SPI_Transmit_DMA(SPI_HandleTypeDef *hspi, uint8_t *pData, uint16_t Size) {
    CHECK(hspi == &spi && spi.pending == 0);
    CHECK(spi.cleaned <= pData && pData + Size <= spi.cleaned + spi.cleaned_bytes);
    spi.from = pData;
    spi.pending = Size;
    return HAL_OK;
}

HAL_SPI_StateTypeDef HAL_SPI_GetState(SPI_HandleTypeDef *hspi) {
    if (spi.hangs)
        return HAL_SPI_STATE_BUSY_TX;
    take(spi.from, spi.pending, 2);
    hspi->pending = 0;
    return HAL_SPI_STATE_READY;
}

uint32_t HAL_SPI_GetError(SPI_HandleTypeDef *hspi) {
    return hspi->fails ? 1 : HAL_SPI_ERROR_NONE;
}

HAL_StatusTypeDef HAL_SPI_Abort(SPI_HandleTypeDef *hspi) {
    hspi->aborted++;
    return HAL_OK;
}

uint32_t HAL_GetTick(void) {
    return spi.ticks++;
}

void HAL_Delay(uint32_t Delay) {
    spi.ticks += Delay;
}

void SCB_CleanDCache_by_Addr(volatile void *addr, int32_t dsize) {
    CHECK_EQUAL((uintptr_t)addr % 32, 0);
    spi.cleaned = (const uint8_t *)addr;
    spi.cleaned_bytes = (size_t)dsize;
}

static adapter_stm32_hal wires = {&spi, &spi.port, &spi.port, GPIO_PIN_4, GPIO_PIN_5};

static glint_bus start(void) {
    memset(&spi, 0, sizeof spi);
    spi.port.levels = GPIO_PIN_4;
    return adapter_stm32_hal_bus(&wires);
}

static const uint8_t bytes[12] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};

/* What was sent is `expected`, and chip select is high. */
static void check_sent(const uint8_t *expected, size_t count) {
    CHECK_EQUAL(spi.count, count);
    CHECK(memcmp(spi.sent, expected, count) == 0);
    CHECK_EQUAL(spi.port.levels & GPIO_PIN_4, GPIO_PIN_4);
}

void stm32_hal_sends_by_dma(void) {
    static const uint8_t whole[] = {0, 1, 1, 2, 3, 3, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    static const uint8_t parts[] = {1, 1, 2, 1, 5, 6, 3, 9, 10};
    glint_bus bus = start();

    CHECK_EQUAL(bus.command(bus.context, bytes, 1), GLINT_OK);
    CHECK_EQUAL(bus.data(bus.context, bytes + 1, 2), GLINT_OK);
    CHECK_EQUAL(bus.begin(bus.context, bytes, 4, 3, 4), GLINT_OK);
    CHECK_EQUAL(spi.count, 5); /* nothing of it has left */
    CHECK_EQUAL(bus.wait(bus.context), GLINT_OK);
    check_sent(whole, sizeof whole);
    bus = start();
    CHECK_EQUAL(bus.begin(bus.context, bytes, 2, 3, 4), GLINT_OK);
    CHECK_EQUAL(bus.wait(bus.context), GLINT_OK);
    check_sent(parts, sizeof parts);
}

void stm32_hal_gives_a_dead_bus_up(void) {
    glint_bus bus = start();

    spi.hangs = 1;
    CHECK_EQUAL(bus.begin(bus.context, bytes, 4, 3, 4), GLINT_OK);
    CHECK_EQUAL(bus.wait(bus.context), GLINT_ERROR_TIMEOUT);
    CHECK(spi.aborted == 1 && spi.ticks > 100);
    CHECK_EQUAL(spi.port.levels & GPIO_PIN_4, GPIO_PIN_4);
    bus = start();
    spi.fails = 1;
    CHECK_EQUAL(bus.command(bus.context, bytes, 1), GLINT_ERROR_BUS);
    CHECK_EQUAL(bus.begin(bus.context, bytes, 2, 3, 4), GLINT_ERROR_BUS);
    CHECK_EQUAL(bus.begin(bus.context, bytes, 4, 3, 4), GLINT_OK);
    CHECK_EQUAL(bus.wait(bus.context), GLINT_ERROR_BUS);
}
