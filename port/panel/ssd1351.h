/* SPDX-License-Identifier: MIT */
/** @file ssd1351.h Solomon SSD1351 with a colour OLED of 128x128 pixels. */
#ifndef GLINT_PANEL_SSD1351_H
#define GLINT_PANEL_SSD1351_H

#include "panel.h"

extern const glint_panel_type glint_panel_ssd1351; /**< As above. */

#endif
