/* SPDX-License-Identifier: MIT */
/** @file ssd1306.h Solomon SSD1306 with an OLED of 128x64 pixels of one bit. */
#ifndef GLINT_PANEL_SSD1306_H
#define GLINT_PANEL_SSD1306_H

#include "panel.h"

extern const glint_panel_type glint_panel_ssd1306; /**< As above. */

#endif
