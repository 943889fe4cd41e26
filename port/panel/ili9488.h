/* SPDX-License-Identifier: MIT */
/** @file ili9488.h Ilitek ILI9488 with a glass of 320x480 pixels, on a serial bus: 3 bytes a pixel. */
#ifndef GLINT_PANEL_ILI9488_H
#define GLINT_PANEL_ILI9488_H

#include "panel.h"

extern const glint_panel_type glint_panel_ili9488; /**< As above. */

#endif
