/* SPDX-License-Identifier: MIT */
/* A teapot that turns on an ST7789 of 320x240 pixels, through esp_lcd. DMA sends a tile while the core draws the next.
 */
#include <glint.h>

#include "driver/spi_master.h"
#include "esp_heap_caps.h"
#include "esp_lcd_panel_io.h"
#include "esp_lcd_panel_ops.h"
#include "esp_lcd_panel_vendor.h"
#include "freertos/FreeRTOS.h"
#include "freertos/semphr.h"
#include "turntable/turntable.h"

enum { PIN_CLOCK = 18, PIN_OUT = 19, PIN_DATA = 21, PIN_SELECT = 5, PIN_RESET = 22 };
enum { WIDTH = 320, HEIGHT = 240 };

static uint32_t arena[12288];
static esp_lcd_panel_handle_t panel;
static SemaphoreHandle_t sent;

static bool note_sent(esp_lcd_panel_io_handle_t io, esp_lcd_panel_io_event_data_t *event, void *context) {
    BaseType_t woken = pdFALSE;

    (void)io;
    (void)event;
    (void)context;
    xSemaphoreGiveFromISR(sent, &woken);
    return woken == pdTRUE;
}

/* esp_lcd wants rows that follow each other: 320 is a multiple of the tile's width, so that none is cut. */
static int begin_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context;
    if (stride != (size_t)width * 2)
        return ESP_ERR_INVALID_SIZE;
    return esp_lcd_panel_draw_bitmap(panel, x, y, x + width, y + height, pixels);
}

static int wait_for_tile(void *context) {
    (void)context;
    return xSemaphoreTake(sent, portMAX_DELAY) != pdTRUE;
}

static void start_panel(void) {
    const spi_bus_config_t bus = {.sclk_io_num = PIN_CLOCK,
                                  .mosi_io_num = PIN_OUT,
                                  .miso_io_num = -1,
                                  .quadwp_io_num = -1,
                                  .quadhd_io_num = -1,
                                  .max_transfer_sz = 64 * 64 * 2};
    const esp_lcd_panel_io_spi_config_t lines = {.dc_gpio_num = PIN_DATA,
                                                 .cs_gpio_num = PIN_SELECT,
                                                 .pclk_hz = 40000000,
                                                 .lcd_cmd_bits = 8,
                                                 .lcd_param_bits = 8,
                                                 .trans_queue_depth = 1,
                                                 .on_color_trans_done = note_sent};
    const esp_lcd_panel_dev_config_t glass = {
        .reset_gpio_num = PIN_RESET, .rgb_ele_order = LCD_RGB_ELEMENT_ORDER_RGB, .bits_per_pixel = 16};
    esp_lcd_panel_io_handle_t io;

    sent = xSemaphoreCreateBinary();
    ESP_ERROR_CHECK(spi_bus_initialize(SPI2_HOST, &bus, SPI_DMA_CH_AUTO));
    ESP_ERROR_CHECK(esp_lcd_new_panel_io_spi((esp_lcd_spi_bus_handle_t)SPI2_HOST, &lines, &io));
    ESP_ERROR_CHECK(esp_lcd_new_panel_st7789(io, &glass, &panel));
    ESP_ERROR_CHECK(esp_lcd_panel_reset(panel));
    ESP_ERROR_CHECK(esp_lcd_panel_init(panel));
    ESP_ERROR_CHECK(esp_lcd_panel_invert_color(panel, true));
    ESP_ERROR_CHECK(esp_lcd_panel_swap_xy(panel, true));
    ESP_ERROR_CHECK(esp_lcd_panel_mirror(panel, true, false));
    ESP_ERROR_CHECK(esp_lcd_panel_disp_on_off(panel, true));
}

void app_main(void) {
    static glint_renderer renderer;
    static turntable table;
    glint_config config = {.width = WIDTH,
                           .height = HEIGHT,
                           .format = &glint_format_rgb565_be,
                           .flush = {begin_tile, wait_for_tile, NULL},
                           .arena = arena,
                           .arena_size = sizeof arena,
                           .keeps_arena = 1};

    start_panel();
    config.pixels_size = glint_pixels_need(&config);
    config.pixels = heap_caps_malloc(config.pixels_size, MALLOC_CAP_DMA);
    int failed = glint_init(&renderer, &config);
    for (uint32_t frame = 0; !failed; frame++) {
        turntable_frame(&table, TURNTABLE_TEAPOT, frame);
        failed = glint_render(&renderer, &table.scene);
    }
}
