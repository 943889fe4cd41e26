/* SPDX-License-Identifier: MIT */
/** @file solomon.h The family of Solomon Systech's OLED controllers. */
#ifndef GLINT_PANEL_SOLOMON_H
#define GLINT_PANEL_SOLOMON_H

#include "panel.h"

extern const glint_panel_family glint_panel_solomon_grey;   /**< Two pixels of 4 bits in a byte: SSD0323. */
extern const glint_panel_family glint_panel_solomon_mono;   /**< One bit, pages of 8 rows: SSD1306. */
extern const glint_panel_family glint_panel_solomon_colour; /**< 16 bits: SSD1351. */

#endif
