/* SPDX-License-Identifier: MIT */
/** @file display.h A panel as what a board shows pictures on, for board.c to use. */
#ifndef GLINT_DISPLAY_H
#define GLINT_DISPLAY_H

#include "board.h"
#include "panel/panel.h"

/**
 * board_display_start for a board with a panel.
 * @param panel must outlive the display
 * @param display set
 * @return GLINT_OK, or what the panel or its bus returns
 */
static inline glint_status glint_display_start(const glint_panel *panel, board_display *display) {
    const glint_status status = glint_panel_start(panel);

    if (status == GLINT_OK) {
        display->width = glint_panel_width(panel);
        display->height = glint_panel_height(panel);
        display->format = glint_panel_format(panel);
        display->flush = glint_panel_flush(panel);
    }
    return status;
}

#endif
