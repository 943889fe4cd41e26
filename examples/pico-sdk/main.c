/* SPDX-License-Identifier: MIT */
/* A teapot that turns on an ST7789 of 240x240 pixels at SPI 0. DMA sends a tile while the core draws the next. */
#include <glint.h>

#include "hardware/dma.h"
#include "hardware/spi.h"
#include "panel/st7789.h"
#include "pico/stdlib.h"
#include "turntable/turntable.h"

enum { PIN_DATA = 16, PIN_SELECT = 17, PIN_CLOCK = 18, PIN_OUT = 19, PIN_RESET = 21 };

static uint channel;
static uint32_t arena[16384];

static void select_panel(bool is_data) {
    gpio_put(PIN_DATA, is_data);
    gpio_put(PIN_SELECT, 0);
}

static glint_status send_command(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    select_panel(false);
    spi_write_blocking(spi0, bytes, count);
    gpio_put(PIN_SELECT, 1);
    return GLINT_OK;
}

static glint_status send_data(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    select_panel(true);
    spi_write_blocking(spi0, bytes, count);
    gpio_put(PIN_SELECT, 1);
    return GLINT_OK;
}

/* Rows that follow each other go by DMA; those of a tile that the screen's edge cuts are sent here, one by one. */
static glint_status begin_rows(void *context, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    (void)context;
    select_panel(true);
    if (stride == row_bytes)
        dma_channel_transfer_from_buffer_now(channel, bytes, (uint32_t)(rows * row_bytes));
    else
        for (size_t row = 0; row < rows; row++)
            spi_write_blocking(spi0, bytes + row * stride, row_bytes);
    return GLINT_OK;
}

/* What came back meanwhile is dropped by the next spi_write_blocking. */
static glint_status wait_for_rows(void *context) {
    (void)context;
    dma_channel_wait_for_finish_blocking(channel);
    while (spi_is_busy(spi0)) {
    }
    gpio_put(PIN_SELECT, 1);
    return GLINT_OK;
}

static void set_reset(void *context, int active) {
    (void)context;
    gpio_put(PIN_RESET, !active);
}

static void wait_milliseconds(void *context, uint32_t milliseconds) {
    (void)context;
    sleep_ms(milliseconds);
}

static void start_bus(uint32_t clock) {
    static const uint outputs[] = {PIN_DATA, PIN_SELECT, PIN_RESET};

    spi_init(spi0, clock);
    gpio_set_function(PIN_CLOCK, GPIO_FUNC_SPI);
    gpio_set_function(PIN_OUT, GPIO_FUNC_SPI);
    for (size_t i = 0; i < sizeof outputs / sizeof outputs[0]; i++) {
        gpio_init(outputs[i]);
        gpio_put(outputs[i], 1);
        gpio_set_dir(outputs[i], GPIO_OUT);
    }
    channel = (uint)dma_claim_unused_channel(true);
    dma_channel_config bytes = dma_channel_get_default_config(channel);
    channel_config_set_transfer_data_size(&bytes, DMA_SIZE_8);
    channel_config_set_dreq(&bytes, spi_get_dreq(spi0, true));
    dma_channel_configure(channel, &bytes, &spi_get_hw(spi0)->dr, NULL, 0, false);
}

int main(void) {
    static const glint_bus bus = {.command = send_command,
                                  .data = send_data,
                                  .begin = begin_rows,
                                  .wait = wait_for_rows,
                                  .reset = set_reset,
                                  .delay = wait_milliseconds};
    const glint_panel panel = {.type = &glint_panel_st7789_240x240, .bus = &bus};
    const glint_config config = {.width = glint_panel_width(&panel),
                                 .height = glint_panel_height(&panel),
                                 .format = glint_panel_format(&panel),
                                 .flush = glint_panel_flush(&panel),
                                 .arena = arena,
                                 .arena_size = sizeof arena,
                                 .keeps_arena = 1};
    glint_renderer renderer;
    turntable table = {0};

    start_bus(panel.type->clock_max);
    int failed = glint_panel_start(&panel) || glint_init(&renderer, &config);
    for (uint32_t frame = 0; !failed; frame++) {
        turntable_frame(&table, TURNTABLE_TEAPOT, frame);
        failed = glint_render(&renderer, &table.scene);
    }
    return failed;
}
