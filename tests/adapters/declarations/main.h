/* SPDX-License-Identifier: MIT */
/* Of ST's HAL and of CMSIS, what the adapter uses; on a part with a data cache. */
#ifndef MAIN_H
#define MAIN_H

#include <stdint.h>

#define __DCACHE_PRESENT 1U
#define GPIO_PIN_4 ((uint16_t)0x0010)
#define GPIO_PIN_5 ((uint16_t)0x0020)
#define HAL_SPI_ERROR_NONE 0x00000000U

typedef enum { HAL_OK, HAL_ERROR, HAL_BUSY, HAL_TIMEOUT } HAL_StatusTypeDef;
typedef enum { GPIO_PIN_RESET, GPIO_PIN_SET } GPIO_PinState;
typedef enum {
    HAL_SPI_STATE_RESET,
    HAL_SPI_STATE_READY,
    HAL_SPI_STATE_BUSY,
    HAL_SPI_STATE_BUSY_TX
} HAL_SPI_StateTypeDef;
typedef struct GPIO_TypeDef GPIO_TypeDef;
typedef struct SPI_HandleTypeDef SPI_HandleTypeDef;

void HAL_GPIO_WritePin(GPIO_TypeDef *GPIOx, uint16_t GPIO_Pin, GPIO_PinState PinState);
HAL_StatusTypeDef HAL_SPI_Transmit(SPI_HandleTypeDef *hspi, uint8_t *pData, uint16_t Size, uint32_t Timeout);
HAL_StatusTypeDef HAL_SPI_Transmit_DMA(SPI_HandleTypeDef *hspi, uint8_t *pData, uint16_t Size);
HAL_StatusTypeDef HAL_SPI_Abort(SPI_HandleTypeDef *hspi);
HAL_SPI_StateTypeDef HAL_SPI_GetState(SPI_HandleTypeDef *hspi);
uint32_t HAL_SPI_GetError(SPI_HandleTypeDef *hspi);
uint32_t HAL_GetTick(void);
void HAL_Delay(uint32_t Delay);
void SCB_CleanDCache_by_Addr(volatile void *addr, int32_t dsize);

#endif
