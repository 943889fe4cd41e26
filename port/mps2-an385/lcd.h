/* SPDX-License-Identifier: MIT */
/** @file lcd.h The colour LCD's port of the MPS2 boards. */
#ifndef GLINT_MPS2_LCD_H
#define GLINT_MPS2_LCD_H

#include "panel/bus.h"

/** Sets the port up; the bus is never faster than bus_hz. */
void mps2_lcd_start(uint32_t clock_hz, uint32_t bus_hz);

extern const glint_bus mps2_lcd_bus;

#endif
