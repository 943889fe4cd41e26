/* SPDX-License-Identifier: MIT */
/** @file st7567.h Sitronix ST7567 with an LCD of 128x64 pixels of one bit, dark on light. */
#ifndef GLINT_PANEL_ST7567_H
#define GLINT_PANEL_ST7567_H

#include "panel.h"

extern const glint_panel_type glint_panel_st7567; /**< As above. */

#endif
