/* SPDX-License-Identifier: MIT */
/**
 * @file pages.h
 * The families of controllers with one bit a pixel, whose memory has pages: a byte is a column of 8 rows, the top one
 * lowest. They share Solomon's early commands, whoever makes them.
 */
#ifndef GLINT_PANEL_PAGES_H
#define GLINT_PANEL_PAGES_H

#include "panel.h"

/**
 * A page and a first column are set, and columns count up to the end of the page: SSD0303, SH1106, ST7567. Each page of
 * a tile takes three bytes of command, and all but its last page are waited for: tiles 8 pixels high (turned by a
 * quarter, 8 wide) have one page, which is sent while the next tile is drawn.
 */
extern const glint_panel_family glint_panel_pages;

/** The same with windows of columns and pages: SSD1306. */
extern const glint_panel_family glint_panel_pages_window;

#endif
