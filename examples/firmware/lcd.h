/* SPDX-License-Identifier: MIT */
/**
 * @file lcd.h
 * What own_flush.c wants of a panel that takes the MIPI command set, such as ST7735, ST7789 or ILI9341: yours to write
 * over your SPI. The test has it over the bus of a board here (tests/board/lcd.c).
 */
#ifndef LCD_H
#define LCD_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Starts the panel: 16 bits a pixel. @return what the others take */
void *lcd_start(void);

/** Sends a command with D/C low, and its parameters with D/C high. @return 0, or anything else for an error */
int lcd_send(void *lcd, uint8_t command, const uint8_t *parameters, size_t count);

/** Sends pixels with D/C high. @return 0, or anything else for an error */
int lcd_pixels(void *lcd, const uint8_t *bytes, size_t count);

#ifdef __cplusplus
}
#endif

#endif
