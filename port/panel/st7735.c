/* SPDX-License-Identifier: MIT */
#include "st7735.h"

#include "dcs.h"

/*
 * Supply, frame rate and gamma registers keep what reset gives them. Sizes of the memory: ST7735 V1.7 (2009-12-04),
 * page
 * 99. Offsets and colour orders of the modules are as public drivers have them; clock (66 ns a write cycle) and times
 * were not checked against a data sheet.
 */
static const uint8_t start[] = {GLINT_PANEL_DCS_WAKE, GLINT_PANEL_END};

#define MODULE(columns, rows, first_column, first_row, colours)                                                        \
    {                                                                                                                  \
        .family = &glint_panel_dcs, .format = &glint_format_rgb565_be, .start = start, .width = 128, .height = 160,    \
        .memory_width = (columns), .memory_height = (rows), .left = (first_column), .top = (first_row),                \
        .glass = GLINT_PANEL_MIRRORED_X | GLINT_PANEL_MIRRORED_Y | (colours), .bits = {16, 12, 24}, .reset_low_ms = 1, \
        .reset_wait_ms = GLINT_PANEL_DCS_WAKE_MS, .clock_max = 15000000                                                \
    }

const glint_panel_type glint_panel_st7735_green = MODULE(132, 162, 2, 1, GLINT_PANEL_BGR);
const glint_panel_type glint_panel_st7735_red = MODULE(128, 160, 0, 0, GLINT_PANEL_BGR);
const glint_panel_type glint_panel_st7735_black = MODULE(128, 160, 0, 0, 0);
