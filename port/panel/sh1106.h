/* SPDX-License-Identifier: MIT */
/** @file sh1106.h Sino Wealth SH1106 with an OLED of 128x64 pixels of one bit. */
#ifndef GLINT_PANEL_SH1106_H
#define GLINT_PANEL_SH1106_H

#include "panel.h"

extern const glint_panel_type glint_panel_sh1106; /**< As above. */

#endif
