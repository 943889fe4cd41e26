/* SPDX-License-Identifier: MIT */
/** @file panels.h The panels that there are drivers for, each with the module that models it. */
#ifndef GLINT_TESTS_PANELS_H
#define GLINT_TESTS_PANELS_H

#include "panel/panel.h"

typedef struct tested_panel {
    const glint_panel_type *type;
    const char *module;
    uint8_t bits[3]; /**< Sizes of pixels that the controller takes; 0 where it takes fewer than three. */
    int can_turn;
    unsigned window_bytes; /**< Commands and parameters before the pixels of a rectangle, or of each page of one. */
    int has_single_pages;  /**< Each page has its own. */
} tested_panel;

/** Does it take pixels of so many bits? */
int panels_take(const tested_panel *panel, unsigned bits);

/** The panel of a module. */
const tested_panel *panels_find(const char *module);

extern const tested_panel tested_panels[];
extern const unsigned tested_panel_count;

/**
 * What the glass ought to show: where pixel (x, y) of a picture lies that is turned clockwise by `quarters`.
 */
void panels_find_on_glass(const glint_panel_type *type, unsigned quarters, int x, int y, int glass[2]);

/** Whether the glass has pixel (x, y) of its own: a round one has no corners. */
int panels_is_seen(const tested_panel *panel, int x, int y);

#endif
