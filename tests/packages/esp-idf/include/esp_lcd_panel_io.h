/* SPDX-License-Identifier: MIT */
#ifndef ESP_LCD_PANEL_IO_H
#define ESP_LCD_PANEL_IO_H

#include "driver/spi_master.h"

typedef int gpio_num_t;
typedef int esp_lcd_spi_bus_handle_t;
typedef struct esp_lcd_panel_io_t *esp_lcd_panel_io_handle_t;
typedef struct esp_lcd_panel_t *esp_lcd_panel_handle_t;
typedef struct esp_lcd_panel_io_event_data_t esp_lcd_panel_io_event_data_t;
typedef bool (*esp_lcd_panel_io_color_trans_done_cb_t)(esp_lcd_panel_io_handle_t io,
                                                       esp_lcd_panel_io_event_data_t *event, void *context);

typedef struct esp_lcd_panel_io_spi_config_t {
    gpio_num_t cs_gpio_num, dc_gpio_num;
    int spi_mode;
    unsigned int pclk_hz;
    size_t trans_queue_depth;
    esp_lcd_panel_io_color_trans_done_cb_t on_color_trans_done;
    void *user_ctx;
    int lcd_cmd_bits, lcd_param_bits;
} esp_lcd_panel_io_spi_config_t;

esp_err_t esp_lcd_new_panel_io_spi(esp_lcd_spi_bus_handle_t bus, const esp_lcd_panel_io_spi_config_t *config,
                                   esp_lcd_panel_io_handle_t *io);

#endif
