/* SPDX-License-Identifier: MIT */
/** @file solomon.h The families of Solomon Systech's OLED controllers whose memory has columns and rows. */
#ifndef GLINT_PANEL_SOLOMON_H
#define GLINT_PANEL_SOLOMON_H

#include "panel.h"

extern const glint_panel_family glint_panel_solomon_grey;   /**< Two pixels of 4 bits in a byte: SSD0323. */
extern const glint_panel_family glint_panel_solomon_colour; /**< 16 bits: SSD1351. */

/**
 * A sequence that ends a command which a fault cut short: where parameters go as commands do, it would take what
 * follows for its parameters. None has more than 8; 0xe3 does nothing.
 */
#define GLINT_PANEL_SOLOMON_RECOVER GLINT_PANEL_SEND(8), 0xe3, 0xe3, 0xe3, 0xe3, 0xe3, 0xe3, 0xe3, 0xe3, GLINT_PANEL_END

#endif
