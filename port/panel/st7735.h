/* SPDX-License-Identifier: MIT */
/**
 * @file st7735.h
 * Sitronix ST7735 with a glass of 128x160 pixels. The common modules are told apart by the colour of the tab on the
 * glass's protective film.
 */
#ifndef GLINT_PANEL_ST7735_H
#define GLINT_PANEL_ST7735_H

#include "panel.h"

extern const glint_panel_type glint_panel_st7735_green; /**< Memory of 132x162: two columns and a row are not seen. */
extern const glint_panel_type glint_panel_st7735_red;   /**< Memory of 128x160. */
extern const glint_panel_type glint_panel_st7735_black; /**< The same, with colours in the order red, green, blue. */

#endif
