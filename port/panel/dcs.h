/* SPDX-License-Identifier: MIT */
/** @file dcs.h The family of controllers that speak the MIPI display command set over a serial bus. */
#ifndef GLINT_PANEL_DCS_H
#define GLINT_PANEL_DCS_H

#include "panel.h"

/**
 * Pixels of 12, 16 or 24 bits, as far as the panel has them; of 24, a panel reads the upper 6 of each byte. Start-up
 * sequences end awake; the family sets the rest and switches the display on.
 */
extern const glint_panel_family glint_panel_dcs;

/** From reset to the command that wakes the panel, and from there to what follows; half as long would mostly do. */
#define GLINT_PANEL_DCS_WAKE_MS 120

/** What every start-up sequence ends with. */
#define GLINT_PANEL_DCS_WAKE GLINT_PANEL_SEND(1), 0x11, GLINT_PANEL_DELAY(GLINT_PANEL_DCS_WAKE_MS)

#endif
