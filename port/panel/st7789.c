/* SPDX-License-Identifier: MIT */
#include "st7789.h"

#include "dcs.h"

/*
 * Supply and gamma registers keep what reset gives them. The glasses are of the common IPS modules, inverted; where
 * they lie in the memory is as public drivers for these modules have it. Clock and times were not checked against a
 * data sheet: 66 ns a write cycle is the ST7789V's, later versions are faster.
 */
static const uint8_t start[] = {GLINT_PANEL_DCS_WAKE, GLINT_PANEL_END};

#define GLASS(columns, rows, first_column, first_row)                                                            \
    {                                                                                                            \
        .family = &glint_panel_dcs, .format = &glint_format_rgb565_be, .start = start, .width = (columns),       \
        .height = (rows), .memory_width = 240, .memory_height = 320, .left = (first_column), .top = (first_row), \
        .glass = GLINT_PANEL_INVERTED, .bits = {16, 12, 24}, .reset_low_ms = 1,                                  \
        .reset_wait_ms = GLINT_PANEL_DCS_WAKE_MS, .clock_max = 15000000                                          \
    }

const glint_panel_type glint_panel_st7789_240x240 = GLASS(240, 240, 0, 0);
const glint_panel_type glint_panel_st7789_240x320 = GLASS(240, 320, 0, 0);
const glint_panel_type glint_panel_st7789_135x240 = GLASS(135, 240, 52, 40);
