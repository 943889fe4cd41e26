/* SPDX-License-Identifier: MIT */
/*
 * The calls of the sample on this machine: a display in memory, which reads pixels as late as it may, when the
 * semaphore is taken. After two frames its picture is written to teapot.ppm, with no more room for a third.
 */
#include "driver/spi_master.h"
#include "esp_heap_caps.h"
#include "esp_lcd_panel_io.h"
#include "esp_lcd_panel_ops.h"
#include "esp_lcd_panel_vendor.h"
#include "freertos/FreeRTOS.h"
#include "freertos/semphr.h"

#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 320, HEIGHT = 240 };

struct QueueDefinition {
    int given;
};

static struct QueueDefinition semaphore;
static esp_lcd_panel_io_color_trans_done_cb_t done;
static struct window {
    int left, top, right, bottom;
    const uint8_t *pixels;
} waiting;
static uint8_t screen[HEIGHT][WIDTH][2];
static uint8_t *dma_memory;
static size_t dma_bytes;
static int is_on, is_turned, drawn;

void app_main(void);

void esp_failed(const char *call) {
    fprintf(stderr, "esp: %s\n", call);
    exit(1);
}

static void demand(int good, const char *what) {
    if (!good)
        esp_failed(what);
}

void *heap_caps_malloc(size_t size, uint32_t caps) {
    demand(caps == MALLOC_CAP_DMA && size, "no memory for DMA");
    dma_memory = malloc(size);
    dma_bytes = size;
    return dma_memory;
}

esp_err_t spi_bus_initialize(spi_host_device_t host, const spi_bus_config_t *config, spi_dma_chan_t dma) {
    return host != SPI2_HOST || dma != SPI_DMA_CH_AUTO || config->max_transfer_sz < 32 * 32 * 2;
}

esp_err_t esp_lcd_new_panel_io_spi(esp_lcd_spi_bus_handle_t bus, const esp_lcd_panel_io_spi_config_t *config,
                                   esp_lcd_panel_io_handle_t *io) {
    done = config->on_color_trans_done;
    *io = NULL;
    return bus != SPI2_HOST || !done || config->lcd_cmd_bits != 8 || config->lcd_param_bits != 8;
}

esp_err_t esp_lcd_new_panel_st7789(esp_lcd_panel_io_handle_t io, const esp_lcd_panel_dev_config_t *config,
                                   esp_lcd_panel_handle_t *panel) {
    (void)io;
    *panel = NULL;
    return config->bits_per_pixel != 16;
}

esp_err_t esp_lcd_panel_reset(esp_lcd_panel_handle_t panel) {
    (void)panel;
    return ESP_OK;
}

esp_err_t esp_lcd_panel_init(esp_lcd_panel_handle_t panel) {
    (void)panel;
    return ESP_OK;
}

esp_err_t esp_lcd_panel_mirror(esp_lcd_panel_handle_t panel, bool mirror_x, bool mirror_y) {
    (void)panel;
    (void)mirror_x;
    (void)mirror_y;
    return ESP_OK;
}

esp_err_t esp_lcd_panel_swap_xy(esp_lcd_panel_handle_t panel, bool swap) {
    (void)panel;
    is_turned = swap;
    return ESP_OK;
}

esp_err_t esp_lcd_panel_invert_color(esp_lcd_panel_handle_t panel, bool invert) {
    (void)panel;
    (void)invert;
    return ESP_OK;
}

esp_err_t esp_lcd_panel_disp_on_off(esp_lcd_panel_handle_t panel, bool on) {
    (void)panel;
    is_on = on;
    return ESP_OK;
}

esp_err_t esp_lcd_panel_draw_bitmap(esp_lcd_panel_handle_t panel, int x_start, int y_start, int x_end, int y_end,
                                    const void *pixels) {
    const uint8_t *const from = pixels;

    (void)panel;
    demand(is_on && is_turned && !waiting.pixels, "a tile out of turn");
    demand(x_start >= 0 && y_start >= 0 && x_start < x_end && y_start < y_end && x_end <= WIDTH && y_end <= HEIGHT,
           "a tile beside the screen");
    demand(from >= dma_memory && from + (x_end - x_start) * (y_end - y_start) * 2 <= dma_memory + dma_bytes,
           "pixels that DMA does not reach");
    waiting = (struct window){x_start, y_start, x_end, y_end, from};
    return ESP_OK;
}

static void write_picture(void) {
    FILE *const file = fopen("teapot.ppm", "wb");

    demand(file != NULL, "teapot.ppm");
    fprintf(file, "P6\n%d %d\n255\n", WIDTH, HEIGHT);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const int word = screen[y][x][0] << 8 | screen[y][x][1];
            fprintf(file, "%c%c%c", ((word >> 11) * 255 + 15) / 31, ((word >> 5 & 63) * 255 + 31) / 63,
                    ((word & 31) * 255 + 15) / 31);
        }
    exit(fclose(file) != 0);
}

SemaphoreHandle_t xSemaphoreCreateBinary(void) {
    return &semaphore;
}

BaseType_t xSemaphoreGiveFromISR(SemaphoreHandle_t of, BaseType_t *woken) {
    of->given = 1;
    *woken = pdTRUE;
    return pdTRUE;
}

BaseType_t xSemaphoreTake(SemaphoreHandle_t of, TickType_t ticks) {
    const uint8_t *from = waiting.pixels;

    demand(ticks == portMAX_DELAY && from, "a wait for nothing");
    for (int y = waiting.top; y < waiting.bottom; y++)
        for (int x = waiting.left; x < waiting.right; x++, from += 2, drawn++) {
            screen[y][x][0] = from[0];
            screen[y][x][1] = from[1];
        }
    waiting.pixels = NULL;
    demand(done(NULL, NULL, NULL) && of->given, "the semaphore is not given");
    of->given = 0;
    if (drawn >= 2 * WIDTH * HEIGHT)
        write_picture();
    return pdTRUE;
}

int main(void) {
    app_main();
    return 1;
}
