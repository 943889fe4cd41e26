/* SPDX-License-Identifier: MIT */
/** @file solomon.h The family of Solomon Systech's grey OLED controllers: two pixels a byte, window by 0x15 and 0x75.
 */
#ifndef GLINT_PANEL_SOLOMON_H
#define GLINT_PANEL_SOLOMON_H

#include "panel.h"

extern const glint_panel_family glint_panel_solomon_grey;

#endif
