/* SPDX-License-Identifier: MIT */
/** @file ssd0303.h Solomon SSD0303 with an OLED of 96x16 pixels of one bit. */
#ifndef GLINT_PANEL_SSD0303_H
#define GLINT_PANEL_SSD0303_H

#include "panel.h"

extern const glint_panel_type glint_panel_ssd0303; /**< As above. */

#endif
