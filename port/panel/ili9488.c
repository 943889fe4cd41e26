/* SPDX-License-Identifier: MIT */
#include "ili9488.h"

#include "dcs.h"

/*
 * Supply and gamma registers keep what reset gives them. On a serial bus it takes pixels of 18 bits, in 3 bytes:
 * ILI9488 V100 (2012-11-28), page 121. How the glass lies is as on the common modules; clock (66 ns a write cycle) and
 * times were not checked against the data sheet.
 */
static const uint8_t start[] = {GLINT_PANEL_DCS_WAKE, GLINT_PANEL_END};

const glint_panel_type glint_panel_ili9488 = {
    .family = &glint_panel_dcs,
    .format = &glint_format_rgb888,
    .start = start,
    .width = 320,
    .height = 480,
    .memory_width = 320,
    .memory_height = 480,
    .glass = GLINT_PANEL_MIRRORED_X | GLINT_PANEL_BGR,
    .bits = {24},
    .reset_low_ms = 1,
    .reset_wait_ms = GLINT_PANEL_DCS_WAKE_MS,
    .clock_max = 15000000,
};
