/* SPDX-License-Identifier: MIT */
/** @file ssd0323.h Solomon SSD0323 with an OLED of 128x64 pixels in 16 greys. */
#ifndef GLINT_PANEL_SSD0323_H
#define GLINT_PANEL_SSD0323_H

#include "panel.h"

extern const glint_panel_type glint_panel_ssd0323; /**< As above. */

#endif
