/* SPDX-License-Identifier: MIT */
/** @file ili9341.h Ilitek ILI9341 with a glass of 240x320 pixels. */
#ifndef GLINT_PANEL_ILI9341_H
#define GLINT_PANEL_ILI9341_H

#include "panel.h"

extern const glint_panel_type glint_panel_ili9341; /**< As above. */

#endif
