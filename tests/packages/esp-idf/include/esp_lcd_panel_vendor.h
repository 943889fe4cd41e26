/* SPDX-License-Identifier: MIT */
#ifndef ESP_LCD_PANEL_VENDOR_H
#define ESP_LCD_PANEL_VENDOR_H

#include "esp_lcd_panel_io.h"

typedef enum { LCD_RGB_ELEMENT_ORDER_RGB, LCD_RGB_ELEMENT_ORDER_BGR } lcd_rgb_element_order_t;

typedef struct esp_lcd_panel_dev_config_t {
    lcd_rgb_element_order_t rgb_ele_order;
    uint32_t bits_per_pixel;
    gpio_num_t reset_gpio_num;
} esp_lcd_panel_dev_config_t;

esp_err_t esp_lcd_new_panel_st7789(esp_lcd_panel_io_handle_t io, const esp_lcd_panel_dev_config_t *config,
                                   esp_lcd_panel_handle_t *panel);

#endif
