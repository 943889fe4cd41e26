/* SPDX-License-Identifier: MIT */
/** @file gc9a01.h GalaxyCore GC9A01 with a round glass, 240 pixels across. */
#ifndef GLINT_PANEL_GC9A01_H
#define GLINT_PANEL_GC9A01_H

#include "panel.h"

extern const glint_panel_type glint_panel_gc9a01; /**< As above. */

#endif
