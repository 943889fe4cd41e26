/* SPDX-License-Identifier: MIT */
/*
 * The calls of the sample on this machine: bytes with chip select low are written as text. What DMA has to send is read
 * when it is waited for, as late as it may be. Ends well after two frames.
 */
#include "hardware/dma.h"
#include "hardware/spi.h"

#include <stdio.h>
#include <stdlib.h>

enum { PIN_DATA = 16, PIN_SELECT = 17, PIN_RESET = 21, PINS = 30, DREQ = 16, CHANNEL = 3, FRAME_BYTES = 240 * 240 * 2 };

static struct spi_inst { spi_hw_t hw; } device;
spi_inst_t *const spi0 = &device;

static int level[PINS], is_output[PINS], is_spi[PINS];
static const volatile uint8_t *waiting;
static uint32_t waiting_count;
static long sent;

static void demand(int good, const char *what) {
    if (good)
        return;
    fprintf(stderr, "pico: %s\n", what);
    exit(1);
}

static void send(const volatile uint8_t *bytes, size_t count) {
    demand(is_output[PIN_DATA] && is_output[PIN_SELECT] && !level[PIN_SELECT], "bytes with chip select high");
    demand(is_spi[18] && is_spi[19], "the pins are not the SPI's");
    putchar(level[PIN_DATA] ? 'D' : 'C');
    for (size_t i = 0; i < count; i++)
        printf(" %02x", bytes[i]);
    putchar('\n');
    /* windows are data too, of 4 bytes */
    sent += level[PIN_DATA] && count > 4 ? (long)count : 0;
}

void gpio_init(uint gpio) {
    demand(gpio < PINS, "no such pin");
}

void gpio_set_dir(uint gpio, bool out) {
    is_output[gpio] = out;
}

void gpio_put(uint gpio, bool value) {
    demand(!waiting, "a pin changes while DMA sends");
    if (gpio == PIN_RESET && is_output[gpio] && level[gpio] != value)
        printf("R %d\n", !value);
    level[gpio] = value;
    if (gpio == PIN_SELECT && value && sent >= 2 * FRAME_BYTES)
        exit(0);
}

void gpio_set_function(uint gpio, enum gpio_function function) {
    is_spi[gpio] = function == GPIO_FUNC_SPI;
}

void sleep_ms(uint32_t milliseconds) {
    printf("T %lu\n", milliseconds * 1000ul);
}

uint spi_init(spi_inst_t *spi, uint baudrate) {
    demand(spi == spi0, "no such SPI");
    return baudrate;
}

int spi_write_blocking(spi_inst_t *spi, const uint8_t *bytes, size_t count) {
    demand(spi == spi0 && !waiting, "SPI is in use");
    send(bytes, count);
    return (int)count;
}

bool spi_is_busy(const spi_inst_t *spi) {
    (void)spi;
    return false;
}

uint spi_get_dreq(spi_inst_t *spi, bool is_tx) {
    demand(spi == spi0 && is_tx, "another request");
    return DREQ;
}

spi_hw_t *spi_get_hw(spi_inst_t *spi) {
    return &spi->hw;
}

int dma_claim_unused_channel(bool required) {
    (void)required;
    return CHANNEL;
}

dma_channel_config dma_channel_get_default_config(uint channel) {
    demand(channel == CHANNEL, "a channel that was not claimed");
    return (dma_channel_config){2};
}

void channel_config_set_transfer_data_size(dma_channel_config *config, enum dma_channel_transfer_size size) {
    config->ctrl = (config->ctrl & ~3u) | size;
}

void channel_config_set_dreq(dma_channel_config *config, uint dreq) {
    config->ctrl |= dreq << 8;
}

void dma_channel_configure(uint channel, const dma_channel_config *config, volatile void *write,
                           const volatile void *read, uint transfers, bool trigger) {
    (void)read;
    demand(channel == CHANNEL && config->ctrl == DREQ << 8 && write == &device.hw.dr && !transfers && !trigger,
           "DMA does not send bytes to the SPI as it asks for them");
}

void dma_channel_transfer_from_buffer_now(uint channel, const volatile void *read, uint32_t transfers) {
    demand(channel == CHANNEL && !waiting, "DMA is busy");
    waiting = read;
    waiting_count = transfers;
}

void dma_channel_wait_for_finish_blocking(uint channel) {
    demand(channel == CHANNEL, "another channel");
    if (waiting)
        send(waiting, waiting_count);
    waiting = NULL;
}
