/* SPDX-License-Identifier: MIT */
#ifndef HARDWARE_DMA_H
#define HARDWARE_DMA_H

#include "pico/stdlib.h"

enum dma_channel_transfer_size { DMA_SIZE_8 = 0, DMA_SIZE_16 = 1, DMA_SIZE_32 = 2 };

typedef struct dma_channel_config {
    uint32_t ctrl;
} dma_channel_config;

int dma_claim_unused_channel(bool required);
dma_channel_config dma_channel_get_default_config(uint channel);
void channel_config_set_transfer_data_size(dma_channel_config *config, enum dma_channel_transfer_size size);
void channel_config_set_dreq(dma_channel_config *config, uint dreq);
void dma_channel_configure(uint channel, const dma_channel_config *config, volatile void *write,
                           const volatile void *read, uint transfers, bool trigger);
void dma_channel_transfer_from_buffer_now(uint channel, const volatile void *read, uint32_t transfers);
void dma_channel_wait_for_finish_blocking(uint channel);

#endif
