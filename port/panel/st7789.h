/* SPDX-License-Identifier: MIT */
/** @file st7789.h Sitronix ST7789, whose memory of 240x320 pixels is larger than most of the glasses sold with it. */
#ifndef GLINT_PANEL_ST7789_H
#define GLINT_PANEL_ST7789_H

#include "panel.h"

extern const glint_panel_type glint_panel_st7789_240x240; /**< As above, 240x240. */
extern const glint_panel_type glint_panel_st7789_240x320; /**< As above, 240x320. */
extern const glint_panel_type glint_panel_st7789_135x240; /**< As above, 135x240. */

#endif
